#include "render/objects/prism.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

namespace terrview {
namespace {

// Where no wall can be crossed: so steep that the squares of the way across are no numbers.
constexpr double kVertical = 1e-100;

// Of a surface that is no plane of the roof, nor the base.
constexpr int kDome = -2;
constexpr int kSide = -1;

glm::dvec2 across(const glm::dvec3& direction) { return {direction.x, direction.y}; }

}  // namespace

// A ray in the plumb frame, its parameter in metres of the view frame.
struct Prism::Line {
  glm::dvec3 origin_m;
  glm::dvec3 direction;

  Line(const LevelPlane& level, const Ray& ray)
      : origin_m(level.point(ray.origin_m)),
        direction(level.direction(glm::normalize(ray.direction))) {}
};

// Where the solid begins or ends.
struct Prism::Meeting {
  double t_m;
  int surface;       // index of a half space, kDome, or kSide
  std::size_t edge;  // where it is a side
  bool enters;
};

Prism::Prism(Polygon footprint, const PrismShape& shape)
    : footprint_(std::move(footprint)),
      level_(shape.level),
      base_m_(shape.base_m),
      roof_(make_roof(footprint_.vertices(), shape.roof)) {
  for (const Roof::Plane& plane : roof_.planes)
    halves_.push_back({{-plane.slope.x, -plane.slope.y, 1},
                       plane.height_m - glm::dot(plane.slope, roof_.middle)});
  halves_.push_back({{0, 0, -1}, -base_m_});
}

Box Prism::bounds() const {
  // What positions on a ray lose to rounding.
  constexpr double kRounding = 1e-12;
  const glm::dvec2 low = footprint_.lowest();
  const glm::dvec2 high = footprint_.highest();
  std::array<double, 4> z_m{level_.z_at(low), level_.z_at(high), level_.z_at({low.x, high.y}),
                            level_.z_at({high.x, low.y})};
  const auto [lowest_m, highest_m] = std::minmax_element(z_m.begin(), z_m.end());
  Box box{{low, *lowest_m + base_m_}, {high, *highest_m + roof_.top_m}};
  const double slack_m = kRounding * (glm::length(box.lowest_m) + glm::length(box.highest_m));
  box.lowest_m -= slack_m;
  box.highest_m += slack_m;
  return box;
}

double Prism::top_z_m(glm::dvec2 ground_m) const {
  return level_.z_at(ground_m) + roof_.height_m(ground_m);
}

RayRange Prism::below_planes(const Line& line) const {
  RayRange range;
  for (std::size_t i = 0; i < halves_.size(); ++i)
    range.clip(halves_[i], line.origin_m, line.direction, static_cast<int>(i));
  return range;
}

RayRange Prism::in_dome(const Line& line) const {
  // In the frame where the dome is a unit sphere.
  const Roof::Dome& dome = *roof_.dome;
  const auto scaled = [&](const glm::dvec3& v) {
    return glm::dvec3((v.x * dome.along.x + v.y * dome.along.y) / dome.half_length_m,
                      (v.y * dome.along.x - v.x * dome.along.y) / dome.half_width_m,
                      v.z / dome.height_m);
  };
  const glm::dvec3 from = scaled(line.origin_m - glm::dvec3(roof_.middle, roof_.eaves_m));
  const glm::dvec3 way = scaled(line.direction);
  const double way2 = glm::dot(way, way);
  const double nearest = -glm::dot(from, way) / way2;
  const glm::dvec3 foot = from + nearest * way;
  const double half2 = (1 - glm::dot(foot, foot)) / way2;
  RayRange range;
  if (half2 <= 0) {
    range.to = range.from;
    return range;
  }
  const double half = std::sqrt(half2);
  range = {nearest - half, nearest + half, kDome, kDome};
  range.clip(halves_.back(), line.origin_m, line.direction, static_cast<int>(halves_.size() - 1));
  return range;
}

// The parts of a line at the heights of the solid, in order and apart.
struct Prism::Heights {
  std::array<RayRange, 2> ranges;
  std::size_t count;

  [[nodiscard]] bool matter(double limit_m) const {
    return std::any_of(ranges.begin(), ranges.begin() + count, [&](const RayRange& range) {
      return !range.is_empty() && range.to >= 0 && range.from <= limit_m;
    });
  }
};

Prism::Heights Prism::heights(const Line& line) const {
  if (!roof_.dome) return {{below_planes(line), RayRange{}}, 1};
  RayRange first = below_planes(line);
  RayRange second = in_dome(line);
  if (second.from < first.from) std::swap(first, second);
  if (first.is_empty() || second.is_empty() || second.from > first.to) return {{first, second}, 2};
  if (second.to > first.to) {
    first.to = second.to;
    first.leaves_by = second.leaves_by;
  }
  return {{first, second}, 1};
}

void Prism::cross_sides(const Line& line, Polygon::Crossings& sides) const {
  if (glm::length(across(line.direction)) > kVertical) {
    footprint_.cross(across(line.origin_m), across(line.direction), sides);
  } else if (footprint_.contains(across(line.origin_m))) {
    constexpr double kEverywhere = std::numeric_limits<double>::infinity();
    sides.push_back({-kEverywhere, 0});
    sides.push_back({kEverywhere, 0});
  }
}

std::optional<Prism::Meeting> Prism::meet(const Line& line, double limit_m) const {
  const Heights heights = this->heights(line);
  if (!heights.matter(limit_m)) return std::nullopt;
  std::array<std::byte, 1024> room;
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
  Polygon::Crossings sides(&memory);
  sides.reserve(16);
  cross_sides(line, sides);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const Polygon::Crossing& enters = sides[i];
    // Where the polygon touches itself, it goes on.
    while (i + 2 < sides.size() && sides[i + 2].t <= sides[i + 1].t) i += 2;
    const Polygon::Crossing& leaves = sides[i + 1];
    for (std::size_t k = 0; k < heights.count; ++k) {
      const RayRange& range = heights.ranges[k];
      const double from = std::max(enters.t, range.from);
      const double to = std::min(leaves.t, range.to);
      if (!(from < to) || to < 0) continue;
      const bool begins_inside = from < 0;
      if ((begins_inside ? to : from) > limit_m) return std::nullopt;
      if (!begins_inside)
        return Meeting{from, enters.t >= range.from ? kSide : range.enters_by, enters.edge, true};
      return Meeting{to, leaves.t <= range.to ? kSide : range.leaves_by, leaves.edge, false};
    }
  }
  return std::nullopt;
}

glm::dvec3 Prism::normal(const Line& line, const Meeting& meeting) const {
  const double sign = meeting.enters ? -1 : 1;
  if (meeting.surface == kSide) {
    const glm::dvec2 edge = footprint_.edge(meeting.edge);
    const glm::dvec3 normal(edge.y, -edge.x, 0);
    return glm::dot(normal, line.direction) * sign < 0 ? -normal : normal;
  }
  if (meeting.surface == kDome) {
    const Roof::Dome& dome = *roof_.dome;
    const glm::dvec3 at =
        line.origin_m + meeting.t_m * line.direction - glm::dvec3(roof_.middle, roof_.eaves_m);
    const double length2 = dome.half_length_m * dome.half_length_m;
    const double width2 = dome.half_width_m * dome.half_width_m;
    const glm::dvec2 side(-dome.along.y, dome.along.x);
    const glm::dvec2 level = glm::dot(glm::dvec2(at), dome.along) / length2 * dome.along +
                             glm::dot(glm::dvec2(at), side) / width2 * side;
    return {level, at.z / (dome.height_m * dome.height_m)};
  }
  return halves_[static_cast<std::size_t>(meeting.surface)].normal;
}

std::optional<SurfaceHit> Prism::first_hit(const Ray& ray) const {
  const Line line(level_, ray);
  const auto meeting = meet(line, ray.length_m);
  if (!meeting) return std::nullopt;
  const bool is_base = meeting->surface == static_cast<int>(halves_.size() - 1);
  return SurfaceHit{meeting->t_m, ray.origin_m + meeting->t_m * glm::normalize(ray.direction),
                    glm::normalize(level_.view_normal(normal(line, *meeting))),
                    meeting->surface == kSide ? kWall
                    : is_base                 ? kBase
                                              : kRoof};
}

bool Prism::stops(const Ray& ray) const {
  return meet(Line(level_, ray), ray.length_m).has_value();
}

}  // namespace terrview
