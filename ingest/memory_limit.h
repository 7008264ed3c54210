// How much memory files may take.
#pragma once

#include <cstddef>
#include <string>

namespace terrview {

// `memory_bytes`, or half of the machine's where that is 0.
[[nodiscard]] double memory_limit_bytes(std::size_t memory_bytes);

// For messages: "12 MiB", rounded up.
[[nodiscard]] std::string mebibytes(double bytes);

}  // namespace terrview
