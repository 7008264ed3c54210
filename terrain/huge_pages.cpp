#include "terrain/huge_pages.h"

#ifdef __linux__
#include <sys/mman.h>

#include <cstdint>
#endif

namespace terrview {

void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  // Nothing less can be one, and failure costs nothing but time.
  constexpr std::uintptr_t kHugePage = std::uintptr_t{2} << 20;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + kHugePage - 1) / kHugePage * kHugePage;
  const std::uintptr_t last = (begin + bytes) / kHugePage * kHugePage;
  if (first < last)
    static_cast<void>(madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE));
#endif
}

std::vector<float> floats_in_huge_pages(std::size_t count, float value) {
  std::vector<float> values;
  values.reserve(count);
  prefer_huge_pages(values.data(), count * sizeof(float));
  values.assign(count, value);
  return values;
}

}  // namespace terrview
