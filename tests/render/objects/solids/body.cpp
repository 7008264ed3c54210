#include "tests/render/objects/solids/body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "render/objects/solids/box_solid.h"
#include "render/objects/solids/frustum.h"
#include "render/objects/solids/half_space_solid.h"
#include "render/objects/solids/prism_solid.h"
#include "render/objects/solids/sphere_solid.h"
#include "render/objects/solids/torus.h"
#include "render/objects/solids/transformed.h"

namespace terrview {

Body sphere_body(double radius_m) {
  const auto contains = [=](const LongPoint& p) {
    return glm::dot(p, p) < Long{radius_m} * Long{radius_m};
  };
  return {std::make_shared<SphereSolid>(radius_m), contains, radius_m};
}

Body box_body(const Box& box) {
  const auto contains = [=](const LongPoint& p) {
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] <= Long{box.lowest_m[axis]} || p[axis] >= Long{box.highest_m[axis]}) return false;
    return true;
  };
  return {std::make_shared<BoxSolid>(box), contains,
          glm::length(glm::max(glm::abs(box.lowest_m), glm::abs(box.highest_m)))};
}

Body half_space_body(const glm::dvec3& normal, double offset) {
  const auto contains = [=](const LongPoint& p) {
    return glm::dot(LongPoint(normal), p) < Long{offset};
  };
  return {std::make_shared<HalfSpaceSolid>(HalfSpace{normal, offset}), contains,
          std::abs(offset) + 1};
}

Body frustum_body(double base_radius_m, double top_radius_m, double height_m) {
  const auto contains = [=](const LongPoint& p) {
    const Long share = p.z / Long{height_m};
    const Long radius = Long{base_radius_m} * (1 - share) + Long{top_radius_m} * share;
    return share > 0 && share < 1 && std::hypot(p.x, p.y) < radius;
  };
  return {std::make_shared<Frustum>(FrustumShape{base_radius_m, top_radius_m, height_m}), contains,
          std::max({base_radius_m, top_radius_m, height_m})};
}

Body torus_body(double major_radius_m, double minor_radius_m) {
  const auto contains = [=](const LongPoint& p) {
    return std::hypot(std::hypot(p.x, p.y) - Long{major_radius_m}, p.z) < Long{minor_radius_m};
  };
  return {std::make_shared<Torus>(TorusShape{major_radius_m, minor_radius_m}), contains,
          major_radius_m + minor_radius_m};
}

Body star_body(int points, double radius_m, double height_m) {
  Polygon::Ring ring;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = std::numbers::pi * i / points;
    const double r = i % 2 == 0 ? radius_m : 0.4 * radius_m;
    ring.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  const auto contains = [=](const LongPoint& p) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const glm::vec<2, Long> a(ring[i]);
      const glm::vec<2, Long> b(ring[j]);
      if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
        inside = !inside;
    }
    return inside && p.z > 0 && p.z < Long{height_m};
  };
  const std::vector<Polygon::Ring> rings{ring};
  return {std::make_shared<PrismSolid>(Polygon(rings), height_m), contains,
          std::max(radius_m, height_m)};
}

Body transformed(const Body& body, const glm::dmat4& to_parent) {
  using LongMatrix = glm::mat<3, 3, Long>;
  const LongMatrix to_body = glm::inverse(LongMatrix(glm::dmat3(to_parent)));
  const LongPoint by(to_parent[3]);
  const auto contains = [=, inner = body.contains](const LongPoint& p) {
    return inner(to_body * (p - by));
  };
  const double stretch =
      glm::length(to_parent[0]) + glm::length(to_parent[1]) + glm::length(to_parent[2]);
  return {std::make_shared<Transformed>(body.solid, to_parent), contains,
          stretch * body.size_m + glm::length(glm::dvec3(to_parent[3]))};
}

Body composed(CsgOperator op, const Body& left, const Body& right) {
  const auto contains = [op, a = left.contains, b = right.contains](const LongPoint& p) {
    switch (op) {
      case CsgOperator::add:
        return a(p) || b(p);
      case CsgOperator::intersect:
        return a(p) && b(p);
      case CsgOperator::subtract:
        break;
    }
    return a(p) && !b(p);
  };
  return {std::make_shared<CsgSolid>(op, left.solid, right.solid), contains,
          std::max(left.size_m, right.size_m)};
}

double real(std::mt19937_64& engine, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(engine);
}

glm::dvec3 direction(std::mt19937_64& engine) {
  while (true) {
    const glm::dvec3 v(real(engine, -1, 1), real(engine, -1, 1), real(engine, -1, 1));
    if (const double length = glm::length(v); length > 0.01 && length < 1) return v / length;
  }
}

glm::dmat4 turn(std::mt19937_64& engine, bool stretches) {
  glm::dmat4 m = glm::rotate(glm::dmat4(1), real(engine, 0, 6), direction(engine));
  if (!stretches) return m;
  return glm::scale(m, {real(engine, 0.5, 2), real(engine, 0.5, 2), real(engine, 0.5, 2)});
}

glm::dmat4 shift(const glm::dvec3& by_m) { return glm::translate(glm::dmat4(1), by_m); }

std::vector<Body> primitives(std::mt19937_64& engine) {
  const auto size = [&] { return real(engine, 0.2, 2); };
  const double major = size();
  return {sphere_body(size()),
          box_body({{-size(), -size(), -size()}, {size(), size(), size()}}),
          half_space_body(direction(engine), size()),
          frustum_body(size(), size(), size()),
          frustum_body(0.7, 0.7, size()),
          frustum_body(size(), 0, size()),
          frustum_body(0, size(), size()),
          torus_body(major, real(engine, 0.01, 0.99) * major),
          star_body(static_cast<int>(real(engine, 2, 9)), size(), size())};
}

Line line_through(std::mt19937_64& engine, const glm::dvec3& middle_m, double reach_m,
                  double far_m) {
  const glm::dvec3 through_m = middle_m + real(engine, 0, reach_m) * direction(engine);
  const glm::dvec3 way = real(engine, 0.1, 10) * direction(engine);
  const double back_m = std::pow(10.0, real(engine, -1, std::log10(far_m)));
  return {through_m - back_m / glm::length(way) * way, way};
}

std::vector<Crossing> crossings_of(const Solid& solid, const Line& line) {
  Crossings crossings;
  solid.append_crossings(line, crossings);
  return {crossings.begin(), crossings.end()};
}

LongPoint point_of(const Line& line, Long t) {
  return LongPoint(line.origin_m) + t * LongPoint(line.direction);
}

std::string fault_of(const Body& body, const Line& line, std::mt19937_64& engine) {
  const std::vector<Crossing> crossings = crossings_of(*body.solid, line);
  if (crossings.size() % 2 != 0) return "an odd number";
  std::ostringstream text;
  text.precision(17);
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Crossing& c = crossings[i];
    if (c.enters != (i % 2 == 0)) return "not by turns";
    if (i > 0 && crossings[i - 1].t > c.t) return "out of order";
    if (std::isinf(c.t)) continue;
    const double towards = glm::dot(c.normal, line.direction);
    if (std::abs(glm::length(c.normal) - 1) > 1e-12) return "a normal not of unit length";
    if (c.enters ? towards > 1e-9 : towards < -1e-9) return "a normal that faces the other side";
    // Beside the crossing, unless another is near.
    const double apart = std::min(i > 0 ? c.t - crossings[i - 1].t : 1,
                                  i + 1 < crossings.size() ? crossings[i + 1].t - c.t : 1);
    if (apart < 8 * c.error) continue;
    for (const bool after : {false, true}) {
      const Long t = Long{c.t} + (after ? 1 : -1) * Long{c.error};
      if (body.contains(point_of(line, t)) == (after == c.enters)) continue;
      text << "crossing " << i << " of " << crossings.size() << " at " << c.t
           << " is further off than " << c.error;
      return text.str();
    }
  }
  const double length = glm::length(line.direction);
  const double nearest = -glm::dot(line.origin_m, line.direction) / (length * length);
  for (int i = 0; i < 20; ++i) {
    const double t = nearest + real(engine, -2, 2) * body.size_m / length;
    const auto after = std::ranges::find_if(crossings, [&](const Crossing& c) { return c.t > t; });
    const bool inside = (after - crossings.begin()) % 2 == 1;
    const bool near = std::ranges::any_of(
        crossings, [&](const Crossing& c) { return std::abs(c.t - t) <= 2 * c.error; });
    if (near || inside == body.contains(point_of(line, t))) continue;
    text << "at " << t << (inside ? " inside" : " outside") << ", which it is not";
    return text.str();
  }
  return {};
}

}  // namespace terrview
