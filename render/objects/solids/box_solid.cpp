#include "render/objects/solids/box_solid.h"

#include <algorithm>
#include <cmath>

#include "render/objects/solids/check_size.h"
#include "render/objects/solids/crossing.h"

namespace terrview {
namespace {

// The side of the box at the lower end of an axis is numbered 2 * axis, the other one more.
glm::dvec3 normal_of(int side) {
  glm::dvec3 normal(0);
  normal[side / 2] = side % 2 == 0 ? -1 : 1;
  return normal;
}

}  // namespace

BoxSolid::BoxSolid(const Box& box) : box_(box) {
  const char* const kSides[] = {"x size", "y size", "z size"};
  for (int axis = 0; axis < 3; ++axis)
    check_size("box", kSides[axis], box.highest_m[axis] - box.lowest_m[axis]);
}

void BoxSolid::append_crossings(const Line& line, Crossings& crossings) const {
  RayRange range;
  double size_m = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low_m = box_.lowest_m[axis];
    const double high_m = box_.highest_m[axis];
    const double from_m = line.origin_m[axis];
    const double pace = line.direction[axis];
    size_m = std::max({size_m, std::abs(low_m), std::abs(high_m)});
    if (pace == 0) {
      if (from_m < low_m || from_m > high_m) return;
      continue;
    }
    const bool forward = pace > 0;
    const double enter = ((forward ? low_m : high_m) - from_m) / pace;
    const double leave = ((forward ? high_m : low_m) - from_m) / pace;
    if (enter > range.from) {
      range.from = enter;
      range.enters_by = 2 * axis + (forward ? 0 : 1);
    }
    if (leave < range.to) {
      range.to = leave;
      range.leaves_by = 2 * axis + (forward ? 1 : 0);
    }
  }
  append_range(
      line, range, size_m, [](double /*t*/, int side) { return normal_of(side); }, crossings);
}

}  // namespace terrview
