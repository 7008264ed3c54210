// From segments to polylines.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace terrview {

enum class LineKind : std::uint8_t { grid, silhouette, object };

// Where segments of one line meet: a place of the lattice of pixels, and the line.
struct LineNode {
  std::int64_t place = 0;
  std::int64_t line = 0;

  auto operator<=>(const LineNode&) const = default;
};

struct LineSegment {
  LineKind kind;
  LineNode ends[2];
  glm::dvec2 points_px[2];
  double distances_m[2];
  double gap = 0;  // of the outline it is part of
};

struct Polyline {
  LineKind kind;
  std::vector<glm::dvec2> points_px;
  std::vector<double> distances_m;  // of the points
  double gap = 0;                   // the widest of its segments
};

// Joins segments where exactly two of a kind meet. Every segment is part of one polyline; those of
// lines that close end where they began. The order depends on that of the segments alone.
[[nodiscard]] std::vector<Polyline> join_segments(const std::vector<LineSegment>& segments);

// Leaves out points that lie within `tolerance_px` of the line between those kept (Douglas and
// Peucker 1973).
[[nodiscard]] std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& points_px,
                                                 double tolerance_px);

[[nodiscard]] double length_px(const std::vector<glm::dvec2>& points_px);

}  // namespace terrview
