#include "terrain/huge_pages.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace terrview {
namespace {

TEST(HugePages, FloatsAreAllOfTheValueWhateverTheirNumber) {
  constexpr std::size_t kMillion = 1 << 20;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, 3 * kMillion + 7}) {
    const std::vector<float> values = floats_in_huge_pages(count, 2.5F);
    EXPECT_EQ(values.size(), count);
    EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](float x) { return x == 2.5F; }));
  }
}

TEST(HugePages, AdviceLeavesWhatIsStoredAsItIs) {
  std::vector<int> values(3 << 20);
  std::iota(values.begin(), values.end(), 0);
  const std::vector<int> before = values;
  prefer_huge_pages(values.data() + 1, (values.size() - 2) * sizeof(int));
  prefer_huge_pages(values.data(), 1);
  prefer_huge_pages(nullptr, 0);
  EXPECT_EQ(values, before);
}

}  // namespace
}  // namespace terrview
