// What a contender writes for every pixel: enough to shade it. 20 bytes a pixel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace terrview {

inline constexpr std::int32_t kNoCell = -1;

// Planes of size_px.x * size_px.y values, row by row. Where nothing is hit, the distance is
// infinite, the cell kNoCell and the normal zero.
struct TracedFrame {
  explicit TracedFrame(glm::ivec2 size)
      : size_px(size),
        distance_m(pixels()),
        cell(pixels()),
        normal_east(pixels()),
        normal_north(pixels()) {}

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y);
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_px.x) +
           static_cast<std::size_t>(column);
  }

  // Nothing hit anywhere.
  void clear() {
    std::fill(distance_m.begin(), distance_m.end(), std::numeric_limits<double>::infinity());
    std::fill(cell.begin(), cell.end(), kNoCell);
    std::fill(normal_east.begin(), normal_east.end(), 0.0F);
    std::fill(normal_north.begin(), normal_north.end(), 0.0F);
  }

  glm::ivec2 size_px;
  std::vector<double> distance_m;
  std::vector<std::int32_t> cell;  // row * (columns of posts - 1) + column
  std::vector<float> normal_east;  // of the unit facet normal, which points up
  std::vector<float> normal_north;
};

// Rays towards the sun, one a pixel, from the ground in the scene frame; NaN = no ray.
struct ShadowRays {
  explicit ShadowRays(glm::ivec2 size)
      : size_px(size),
        x_m(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)),
        y_m(x_m.size()),
        z_m(x_m.size()) {}

  glm::ivec2 size_px;
  std::vector<float> x_m;
  std::vector<float> y_m;
  std::vector<float> z_m;
  std::int64_t count = 0;  // rays that are there
};

// Per pixel, whether the ray is stopped: 0 or 1; 0 where there is no ray.
using ShadowFrame = std::vector<std::uint8_t>;

}  // namespace terrview
