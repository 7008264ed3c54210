#include "render/objects/hull.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace terrview {
namespace {

constexpr std::size_t kTried = 256;

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The rectangle around `hull` with sides along `along`, of unit length.
OrientedRectangle rectangle_along(std::span<const glm::dvec2> hull, glm::dvec2 along) {
  const glm::dvec2 across(-along.y, along.x);
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (const glm::dvec2& corner : hull) {
    const glm::dvec2 at(glm::dot(corner - hull[0], along), glm::dot(corner - hull[0], across));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  const glm::dvec2 middle = (low + high) / 2.0;
  const glm::dvec2 half = (high - low) / 2.0;
  OrientedRectangle rectangle{hull[0] + middle.x * along + middle.y * across, along, half.x,
                              half.y};
  if (half.y > half.x) {
    rectangle.along = across;
    std::swap(rectangle.half_length, rectangle.half_width);
  }
  return rectangle;
}

}  // namespace

std::vector<glm::dvec2> convex_hull(std::span<const glm::dvec2> points) {
  std::vector<glm::dvec2> sorted(points.begin(), points.end());
  const auto before = [](glm::dvec2 a, glm::dvec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(sorted.begin(), sorted.end(), before);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return sorted;
  // Andrew's monotone chain: the lower side, then the upper one.
  std::vector<glm::dvec2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const glm::dvec2& point : sorted) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(sorted.begin(), sorted.end());
  }
  return hull;
}

OrientedRectangle enclosing_rectangle(std::span<const glm::dvec2> hull) {
  OrientedRectangle smallest;
  double area = std::numeric_limits<double>::infinity();
  const std::size_t step = hull.size() / kTried + 1;
  for (std::size_t i = 0; i < hull.size(); i += step) {
    const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
    if (edge == glm::dvec2(0)) continue;
    const OrientedRectangle rectangle = rectangle_along(hull, glm::normalize(edge));
    if (rectangle.half_length * rectangle.half_width < area) {
      area = rectangle.half_length * rectangle.half_width;
      smallest = rectangle;
    }
  }
  return smallest;
}

}  // namespace terrview
