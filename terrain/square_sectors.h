// Sectors of azimuth about the eye, told apart without trigonometry.
//
// A square about the eye stands for the horizon: on side 0 (north) directions are (c, 1), on sides
// 1, 2 and 3 (1, c), (c, -1) and (-1, c), c from -1 to 1. Sector k of side i holds c from
// -1 + 2 k / n to -1 + 2 (k + 1) / n, of n sectors a side; its number is i n + k.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace terrview {

// The unit direction that parts sectors `place` - 1 and `place` of a side; half numbers lie amid a
// sector.
inline glm::dvec2 sector_edge(int side, double place, int sectors_a_side) {
  const double c = -1 + 2 * place / sectors_a_side;
  switch (side) {
    case 0:
      return glm::normalize(glm::dvec2(c, 1));
    case 1:
      return glm::normalize(glm::dvec2(1, c));
    case 2:
      return glm::normalize(glm::dvec2(c, -1));
    default:
      return glm::normalize(glm::dvec2(-1, c));
  }
}

// Where a direction other than (0, 0) lies: on that side, from 0 to its number of sectors.
struct SquarePlace {
  int side;
  double place;
};
inline SquarePlace square_place(glm::dvec2 direction, int sectors_a_side) {
  const glm::dvec2 far = glm::abs(direction);
  const bool along_y = far.y >= far.x;
  const double c = (along_y ? direction.x : direction.y) / std::max(far.x, far.y);
  const int side = along_y ? (direction.y > 0 ? 0 : 2) : (direction.x > 0 ? 1 : 3);
  return {side, (c + 1) * (0.5 * sectors_a_side)};
}

inline int sector_of(glm::dvec2 direction, int sectors_a_side) {
  const auto [side, place] = square_place(direction, sectors_a_side);
  return side * sectors_a_side + std::min(static_cast<int>(place), sectors_a_side - 1);
}

}  // namespace terrview
