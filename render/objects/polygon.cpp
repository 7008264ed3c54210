#include "render/objects/polygon.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace terrview {
namespace {

constexpr std::size_t kGroup = 8;

double cross_product(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace

// A line and the signs of points beside it.
struct Polygon::Line {
  glm::dvec2 origin;
  glm::dvec2 direction;

  [[nodiscard]] double side(glm::dvec2 point) const {
    return direction.x * (point.y - origin.y) - direction.y * (point.x - origin.x);
  }

  // Whether points of the rectangle may lie on both sides. side() grows or falls with each
  // coordinate, rounding included, so two corners tell.
  [[nodiscard]] bool may_part(const Rectangle& of) const {
    const bool right = direction.x >= 0;
    const bool up = direction.y >= 0;
    return side({up ? of.lowest.x : of.highest.x, right ? of.highest.y : of.lowest.y}) >= 0 &&
           side({up ? of.highest.x : of.lowest.x, right ? of.lowest.y : of.highest.y}) < 0;
  }

  // Where the line passes between points on its two sides.
  [[nodiscard]] double between(glm::dvec2 left, double left_side, glm::dvec2 right,
                               double right_side) const {
    const glm::dvec2 point = left + left_side / (left_side - right_side) * (right - left);
    return glm::dot(point - origin, direction) / glm::dot(direction, direction);
  }
};

Polygon::Polygon(std::span<const Ring> rings)
    : lowest_(std::numeric_limits<double>::infinity()), highest_(-lowest_) {
  for (const Ring& ring : rings) {
    if (ring.empty()) continue;
    vertices_.insert(vertices_.end(), ring.begin(), ring.end());
    if (ring.front() != ring.back()) vertices_.push_back(ring.front());
    ring_ends_.push_back(vertices_.size() - 1);
  }
  for (const glm::dvec2& vertex : vertices_) {
    lowest_ = glm::min(lowest_, vertex);
    highest_ = glm::max(highest_, vertex);
  }
  group_edges();
}

void Polygon::group_edges() {
  const std::size_t edges = vertices_.empty() ? 0 : vertices_.size() - 1;
  for (std::size_t run = kGroup; run < edges * kGroup && edges > kGroup; run *= kGroup) {
    std::vector<Rectangle> level;
    for (std::size_t first = 0; first < edges; first += run) {
      Rectangle bounds{vertices_[first], vertices_[first]};
      const std::size_t last = std::min(first + run, edges);
      for (std::size_t i = first; i <= last; ++i) {
        bounds.lowest = glm::min(bounds.lowest, vertices_[i]);
        bounds.highest = glm::max(bounds.highest, vertices_[i]);
      }
      level.push_back(bounds);
    }
    groups_.push_back(std::move(level));
  }
}

void Polygon::cross_edges(const Line& line, std::size_t first, std::size_t last,
                          Crossings& crossings) const {
  double before = line.side(vertices_[first]);
  for (std::size_t i = first; i < last; ++i) {
    const double after = line.side(vertices_[i + 1]);
    const bool parts = (before >= 0) != (after >= 0);
    if (parts && is_edge(i)) {
      const double t = before >= 0 ? line.between(vertices_[i], before, vertices_[i + 1], after)
                                   : line.between(vertices_[i + 1], after, vertices_[i], before);
      crossings.push_back({t, i});
    }
    before = after;
  }
}

void Polygon::cross_group(const Line& line, std::size_t level, std::size_t group,
                          Crossings& crossings) const {
  if (!line.may_part(groups_[level][group])) return;
  if (level == 0) {
    const std::size_t first = group * kGroup;
    cross_edges(line, first, std::min(first + kGroup, vertices_.size() - 1), crossings);
    return;
  }
  const std::size_t last = std::min((group + 1) * kGroup, groups_[level - 1].size());
  for (std::size_t i = group * kGroup; i < last; ++i) cross_group(line, level - 1, i, crossings);
}

void Polygon::cross(glm::dvec2 origin, glm::dvec2 direction, Crossings& crossings) const {
  crossings.clear();
  if (vertices_.empty()) return;
  const Line line{origin, direction};
  if (groups_.empty())
    cross_edges(line, 0, vertices_.size() - 1, crossings);
  else
    cross_group(line, groups_.size() - 1, 0, crossings);
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
}

bool Polygon::contains(glm::dvec2 point) const {
  std::array<std::byte, 1024> room;
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
  Crossings crossings(&memory);
  cross(point, {1, 0}, crossings);
  const auto behind = [](const Crossing& crossing) { return crossing.t <= 0; };
  return std::count_if(crossings.begin(), crossings.end(), behind) % 2 != 0;
}

bool Polygon::is_edge(std::size_t vertex) const {
  return !std::binary_search(ring_ends_.begin(), ring_ends_.end(), vertex);
}

double Polygon::area() const {
  const glm::dvec2 middle = (lowest_ + highest_) / 2.0;
  double twice = 0;
  std::size_t first = 0;
  for (const std::size_t last : ring_ends_) {
    double ring = 0;
    for (std::size_t i = first; i < last; ++i)
      ring += cross_product(vertices_[i] - middle, vertices_[i + 1] - middle);
    twice += first == 0 ? std::abs(ring) : -std::abs(ring);
    first = last + 1;
  }
  return twice / 2;
}

}  // namespace terrview
