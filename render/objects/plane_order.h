// An order of places in which what is near in number is near in the plane, and so in the caches.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace terrview {

// The bits of two coordinates by turns (Morton, 1966).
[[nodiscard]] constexpr std::uint32_t interleaved(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint32_t v) {
    v = (v | v << 8) & 0x00FF00FF;
    v = (v | v << 4) & 0x0F0F0F0F;
    v = (v | v << 2) & 0x33333333;
    return (v | v << 1) & 0x55555555;
  };
  return spread(x) | spread(y) << 1;
}

// Bits per coordinate that suffice to tell `count` places apart, about.
[[nodiscard]] constexpr int order_bits(std::size_t count) {
  int bits = 1;
  while (bits < 15 && std::size_t{1} << (2 * bits) < count) ++bits;
  return bits;
}

// The items by rising key below `keys`; equal ones stay in their order.
[[nodiscard]] inline std::vector<int> order_of(const std::vector<std::uint32_t>& keys) {
  std::uint32_t most = 0;
  for (const std::uint32_t key : keys) most = key > most ? key : most;
  std::vector<int> ends(std::size_t{most} + 2);
  for (const std::uint32_t key : keys) ++ends[key + 1];
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  std::vector<int> order(keys.size());
  int item = 0;
  for (const std::uint32_t key : keys) order[static_cast<std::size_t>(ends[key]++)] = item++;
  return order;
}

}  // namespace terrview
