#include "render/objects/solids/half_space_solid.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "render/objects/solids/check_size.h"
#include "render/objects/solids/crossing.h"

namespace terrview {

HalfSpaceSolid::HalfSpaceSolid(const HalfSpace& half) : half_(half) {
  const double length = glm::length(half.normal);
  check_size("half-space", "length of its normal", length);
  check_size("half-space", "size of its offset", std::abs(half.offset), /*may_be_zero=*/true);
  half_.normal /= length;
  half_.offset /= length;
}

Box HalfSpaceSolid::bounds() const {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  Box box{glm::dvec3(-kEndless), glm::dvec3(kEndless)};
  for (int axis = 0; axis < 3; ++axis) {
    if (half_.normal[axis] == 1) box.highest_m[axis] = half_.offset;
    if (half_.normal[axis] == -1) box.lowest_m[axis] = -half_.offset;
  }
  return box;
}

void HalfSpaceSolid::append_crossings(const Line& line, Crossings& crossings) const {
  RayRange range;
  range.clip(half_, line.origin_m, line.direction, 0);
  append_range(
      line, range, std::abs(half_.offset),
      [&](double /*t*/, int /*surface*/) { return half_.normal; }, crossings);
}

}  // namespace terrview
