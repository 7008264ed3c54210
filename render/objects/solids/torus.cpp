#include "render/objects/solids/torus.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/objects/solids/check_size.h"
#include "render/objects/solids/crossing.h"
#include "render/objects/solids/monotone_root.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// Points in growing order: four at most between two ends.
struct Places {
  std::array<double, 6> at;
  std::size_t count = 0;

  void add(double t) { at[count++] = t; }
  [[nodiscard]] std::span<const double> all() const { return {at.data(), count}; }
};

// Where the signs of f change, if it rises or falls throughout between each two of `turns`.
template <class Function>
Places changes_of(const Function& f, std::span<const double> turns) {
  Places places;
  for (std::size_t i = 0; i + 1 < turns.size(); ++i)
    if ((f(turns[i]) < 0) != (f(turns[i + 1]) < 0))
      places.add(root_between(f, turns[i], turns[i + 1]));
  return places;
}

Places with_ends(double end, std::span<const double> between) {
  Places places;
  places.add(-end);
  for (const double t : between) places.add(t);
  places.add(end);
  return places;
}

}  // namespace

Torus::Torus(const TorusShape& shape) : shape_(shape) {
  check_size("torus", "minor radius", shape.minor_radius_m);
  check_size("torus", "major radius", shape.major_radius_m);
  if (shape.minor_radius_m >= shape.major_radius_m)
    throw InputError("torus: its section reaches its axis: give a minor radius below the major");
}

Box Torus::bounds() const {
  const double radius_m = shape_.major_radius_m + shape_.minor_radius_m;
  return {{-radius_m, -radius_m, -shape_.minor_radius_m},
          {radius_m, radius_m, shape_.minor_radius_m}};
}

// The distance of a point from the surface, negative inside.
double Torus::outside_m(const glm::dvec3& at_m) const {
  const double off_ring_m = glm::length(glm::dvec2(at_m)) - shape_.major_radius_m;
  return glm::length(glm::dvec2(off_ring_m, at_m.z)) - shape_.minor_radius_m;
}

glm::dvec3 Torus::normal(const glm::dvec3& at_m) const {
  const double off_axis_m = glm::length(glm::dvec2(at_m));
  const double share = 1 - shape_.major_radius_m / off_axis_m;
  return glm::normalize(glm::dvec3(at_m.x * share, at_m.y * share, at_m.z));
}

void Torus::append_crossings(const Line& line, Crossings& crossings) const {
  const double reach_m = shape_.major_radius_m + shape_.minor_radius_m;
  const double nearest = nearest_to(line, glm::dvec3(0));
  const double pace = glm::length(line.direction);
  const glm::dvec3 along = line.direction / pace;
  const glm::dvec3 foot_m = line.origin_m + nearest * line.direction;
  const double foot2_m2 = glm::dot(foot_m, foot_m);
  if (foot2_m2 >= reach_m * reach_m) return;
  // At s metres from the foot, (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2) is a quartic without a
  // cubic term, s^4 + p s^2 + q s + constant, as |p|^2 has no linear one. It turns where its
  // derivative is 0, and that turns at +- sqrt(-p / 6).
  const double major2_m2 = shape_.major_radius_m * shape_.major_radius_m;
  const double k = foot2_m2 + major2_m2 - shape_.minor_radius_m * shape_.minor_radius_m;
  const double p = 2 * k - 4 * major2_m2 * (along.x * along.x + along.y * along.y);
  const double q = -8 * major2_m2 * (foot_m.x * along.x + foot_m.y * along.y);
  const auto derivative = [&](double s) { return (4 * s * s + 2 * p) * s + q; };
  const double end_m = 1.01 * reach_m;
  const double bend_m = std::sqrt(std::max(-p / 6, 0.0));
  const std::array<double, 2> bends{-bend_m, bend_m};
  const bool is_bent = bend_m > 0 && bend_m < end_m;
  const Places ends = with_ends(end_m, {bends.data(), is_bent ? bends.size() : 0});
  const Places turns = with_ends(end_m, changes_of(derivative, ends.all()).all());
  const auto outside = [&](double s) { return outside_m(foot_m + s * along); };
  const Places sides = changes_of(outside, turns.all());
  bool enters = true;
  for (const double s : sides.all()) {
    crossings.push_back(
        crossing_at(line, nearest + s / pace, normal(foot_m + s * along), reach_m, enters));
    enters = !enters;
  }
}

}  // namespace terrview
