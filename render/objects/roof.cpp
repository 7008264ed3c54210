#include "render/objects/roof.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>

#include "render/objects/hull.h"

namespace terrview {
namespace {

// A pyramid over a round tower needs no more sides.
constexpr std::size_t kMostSides = 64;

// The rectangle turned so that `along` is the ridge's way.
OrientedRectangle with_ridge(OrientedRectangle rectangle, const RoofOptions& options) {
  const glm::dvec2 across(-rectangle.along.y, rectangle.along.x);
  const bool turns = options.downhill ? std::abs(glm::dot(*options.downhill, rectangle.along)) >
                                            std::abs(glm::dot(*options.downhill, across))
                                      : options.ridge_across;
  if (turns) return {rectangle.middle, across, rectangle.half_width, rectangle.half_length};
  return rectangle;
}

// The planes that fall from `top_m` at `run_m` inside the rectangle's sides to the eaves there.
void add_sides(const RoofOptions& options, glm::dvec2 outward, double half_m, double run_m,
               Roof& roof) {
  const double fall = (options.top_m - options.eaves_m) / run_m;
  for (const double sign : {1.0, -1.0})
    roof.planes.push_back({options.eaves_m + fall * half_m, -sign * fall * outward});
}

void add_skillion(const OrientedRectangle& rectangle, const RoofOptions& options, Roof& roof) {
  const glm::dvec2 across(-rectangle.along.y, rectangle.along.x);
  const double sign = options.downhill && glm::dot(*options.downhill, across) < 0 ? -1 : 1;
  const double rise_m = options.top_m - options.eaves_m;
  roof.planes.push_back(
      {options.eaves_m + rise_m / 2, -sign * rise_m / (2 * rectangle.half_width) * across});
}

// Through each edge of the hull at the eaves, and the top over the middle.
void add_pyramid(std::span<const glm::dvec2> hull, const RoofOptions& options, Roof& roof) {
  const std::size_t step = (hull.size() + kMostSides - 1) / kMostSides;
  for (std::size_t i = 0; i < hull.size(); i += step) {
    const glm::dvec2 edge = glm::normalize(hull[(i + 1) % hull.size()] - hull[i]);
    const glm::dvec2 outward(edge.y, -edge.x);
    const double run_m = glm::dot(hull[i] - roof.middle, outward);
    roof.planes.push_back({options.top_m, -(options.top_m - options.eaves_m) / run_m * outward});
  }
}

// Of a convex polygon with an area.
glm::dvec2 centroid(std::span<const glm::dvec2> hull) {
  glm::dvec2 sum(0);
  double area = 0;
  for (std::size_t i = 2; i < hull.size(); ++i) {
    const glm::dvec2 a = hull[i - 1] - hull[0];
    const glm::dvec2 b = hull[i] - hull[0];
    const double part = a.x * b.y - a.y * b.x;
    area += part;
    sum += part * (a + b) / 3.0;
  }
  return hull[0] + sum / area;
}

void add_planes(std::span<const glm::dvec2> hull, const OrientedRectangle& rectangle,
                const RoofOptions& options, Roof& roof) {
  const glm::dvec2 across(-rectangle.along.y, rectangle.along.x);
  const double half_width_m = rectangle.half_width;
  const double run_m = std::min(half_width_m, rectangle.half_length);
  switch (options.shape) {
    case RoofShape::gabled:
      add_sides(options, across, half_width_m, half_width_m, roof);
      break;
    case RoofShape::hipped:
      add_sides(options, across, half_width_m, run_m, roof);
      add_sides(options, rectangle.along, rectangle.half_length, run_m, roof);
      break;
    case RoofShape::skillion:
      add_skillion(rectangle, options, roof);
      break;
    case RoofShape::pyramidal:
      add_pyramid(hull, options, roof);
      break;
    case RoofShape::dome:
      roof.dome = {rectangle.along, rectangle.half_length, half_width_m,
                   options.top_m - options.eaves_m};
      [[fallthrough]];
    case RoofShape::flat:
      roof.planes.push_back({options.eaves_m, {0, 0}});
      break;
  }
}

}  // namespace

double Roof::height_m(glm::dvec2 ground_m) const {
  const glm::dvec2 off_m = ground_m - middle;
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const Plane& plane : planes)
    lowest_m = std::min(lowest_m, plane.height_m + glm::dot(plane.slope, off_m));
  if (!dome) return lowest_m;
  const glm::dvec2 side(-dome->along.y, dome->along.x);
  const double x = glm::dot(off_m, dome->along) / dome->half_length_m;
  const double y = glm::dot(off_m, side) / dome->half_width_m;
  return std::max(lowest_m, eaves_m + dome->height_m * std::sqrt(std::max(0.0, 1 - x * x - y * y)));
}

Roof make_roof(std::span<const glm::dvec2> footprint, const RoofOptions& given) {
  RoofOptions options = given;
  if (!(options.top_m > options.eaves_m)) options.shape = RoofShape::flat;
  const std::vector<glm::dvec2> hull = convex_hull(footprint);
  const OrientedRectangle rectangle = with_ridge(enclosing_rectangle(hull), options);
  Roof roof{.middle = options.shape == RoofShape::pyramidal ? centroid(hull) : rectangle.middle,
            .eaves_m = options.eaves_m,
            .planes = {},
            .dome = {},
            .top_m = options.shape == RoofShape::flat ? options.eaves_m : options.top_m};
  add_planes(hull, rectangle, options, roof);
  return roof;
}

}  // namespace terrview
