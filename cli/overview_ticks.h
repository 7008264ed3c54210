// Round coordinates along a line of a DEM.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace terrview {

// Of a place in posts: x and y, east and north.
using Coordinates = std::function<glm::dvec2(glm::dvec2 uv)>;

struct Tick {
  glm::dvec2 uv;
  double value;
};

struct Ticks {
  int axis = 0;     // of the coordinate that is told: the one that changes more along the line
  double step = 1;  // 1, 2 or 5 times a power of ten
  std::vector<Tick> ticks;
};

// The multiples of the smallest step of which no more than `most` steps fit between two points.
// The coordinate rises or falls along the line without a turn.
[[nodiscard]] Ticks ticks_along(glm::dvec2 from_uv, glm::dvec2 to_uv,
                                const Coordinates& coordinates, int most);

// The largest 1, 2 or 5 times a power of ten that is no more than `length`.
[[nodiscard]] double round_length(double length);

enum class CoordinateKind {
  degrees,  // 7.2° E, 47.5° N
  grid,     // 216000 E, 776000 N
  plain,    // x 790, y 590
};

// With as many decimals as tell a `step` from none.
[[nodiscard]] std::string coordinate_text(CoordinateKind kind, int axis, double value, double step);

}  // namespace terrview
