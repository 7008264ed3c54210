#include "render/objects/solids/prism_solid.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "render/objects/solids/check_size.h"
#include "render/objects/solids/crossing.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// Where no side can be crossed: so steep that the squares of the way across are no numbers.
constexpr double kVertical = 1e-100;

enum Surface { kSide, kBase, kTop };

glm::dvec2 across(const glm::dvec3& v) { return {v.x, v.y}; }

}  // namespace

PrismSolid::PrismSolid(Polygon base, double height_m)
    : base_(std::move(base)), height_m_(height_m) {
  check_size("prism", "height", height_m);
  if (base_.vertices().empty()) throw InputError("prism: no points: give at least three");
  check_size("prism", "area of its polygon", base_.area());
}

Box PrismSolid::bounds() const { return {{base_.lowest(), 0}, {base_.highest(), height_m_}}; }

void PrismSolid::cross_sides(const Line& line, Polygon::Crossings& sides) const {
  if (glm::length(across(line.direction)) > kVertical * glm::length(line.direction)) {
    base_.cross(across(line.origin_m), across(line.direction), sides);
  } else if (base_.contains(across(line.origin_m))) {
    constexpr double kEverywhere = std::numeric_limits<double>::infinity();
    sides.push_back({-kEverywhere, 0});
    sides.push_back({kEverywhere, 0});
  }
}

glm::dvec3 PrismSolid::side_normal(std::size_t edge, const Line& line, bool enters) const {
  const glm::dvec2 way = base_.edge(edge);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(way.y, -way.x, 0));
  return (glm::dot(normal, line.direction) > 0) == enters ? -normal : normal;
}

void PrismSolid::append_crossings(const Line& line, Crossings& crossings) const {
  RayRange level;
  level.clip({{0, 0, -1}, 0}, line.origin_m, line.direction, kBase);
  level.clip({{0, 0, 1}, height_m_}, line.origin_m, line.direction, kTop);
  if (level.is_empty()) return;
  const glm::dvec2 farthest_m = glm::max(glm::abs(base_.lowest()), glm::abs(base_.highest()));
  const double size_m = farthest_m.x + farthest_m.y + height_m_;
  Polygon::Crossings sides(crossings.get_allocator());
  cross_sides(line, sides);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const Polygon::Crossing& enters = sides[i];
    // Where the polygon touches itself, it goes on.
    while (i + 2 < sides.size() && sides[i + 2].t <= sides[i + 1].t) i += 2;
    const Polygon::Crossing& leaves = sides[i + 1];
    RayRange range = level;
    if (enters.t > range.from) {
      range.from = enters.t;
      range.enters_by = kSide;
    }
    if (leaves.t < range.to) {
      range.to = leaves.t;
      range.leaves_by = kSide;
    }
    const auto normal_at = [&](double t, int surface) {
      if (surface != kSide) return glm::dvec3(0, 0, surface == kBase ? -1 : 1);
      const bool is_entry = t == range.from;
      return side_normal((is_entry ? enters : leaves).edge, line, is_entry);
    };
    append_range(line, range, size_m, normal_at, crossings);
  }
}

}  // namespace terrview
