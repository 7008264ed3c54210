// 8-bit sRGB colours, and their triplets of bits.
//
// A colour of three 8-bit components is a string of eight triplets, from the top bits down; triplet
// j is 4 r_j + 2 g_j + b_j. The first k triplets name a cube of colours, 256 >> k wide: a node at
// level k of the tree of triplets. Written as one number (a Morton code) they put the colours, and
// the cubes, in the tree's pre-order.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/fwd.hpp>
#include <glm/vec3.hpp>

namespace terrview {

using Rgb8 = glm::u8vec3;

inline constexpr int kColorBits = 8;  // of each component: the levels of the tree
inline constexpr std::uint32_t kColorCount = 1U << (3 * kColorBits);

namespace detail {

constexpr std::array<std::uint32_t, 256> spread_bits() {
  std::array<std::uint32_t, 256> spread{};
  for (std::uint32_t value = 0; value < 256; ++value)
    for (std::uint32_t bit = 0; bit < 8; ++bit) spread[value] |= ((value >> bit) & 1U) << (3 * bit);
  return spread;
}

inline constexpr std::array<std::uint32_t, 256> kSpreadBits = spread_bits();

constexpr std::uint8_t gather_bits(std::uint32_t spread) {
  spread &= 0x249249U;
  spread = (spread | (spread >> 2)) & 0x0C30C3U;
  spread = (spread | (spread >> 4)) & 0x00F00FU;
  return static_cast<std::uint8_t>(spread | (spread >> 8));
}

}  // namespace detail

// The eight triplets, the first in bits 21 to 23.
[[nodiscard]] inline std::uint32_t triplets(Rgb8 color) {
  return (detail::kSpreadBits[color.r] << 2) | (detail::kSpreadBits[color.g] << 1) |
         detail::kSpreadBits[color.b];
}

[[nodiscard]] inline Rgb8 color_of_triplets(std::uint32_t triplets) {
  return {detail::gather_bits(triplets >> 2), detail::gather_bits(triplets >> 1),
          detail::gather_bits(triplets)};
}

// Colours by their address.
using Palette = std::vector<Rgb8>;

inline constexpr int kMaxPaletteColors = 65536;

}  // namespace terrview
