// Memory in huge pages. A walk over a large grid comes to another page of 4 KiB with every row or
// few, and waits for its address more often than for its heights.
#pragma once

#include <cstddef>
#include <vector>

namespace terrview {

// Asks the system for huge pages where memory has not been written yet. It may refuse, and memory
// below a few MiB has none; what is stored is the same.
void prefer_huge_pages(void* memory, std::size_t bytes);

// `count` times `value`.
[[nodiscard]] std::vector<float> floats_in_huge_pages(std::size_t count, float value);

}  // namespace terrview
