// Segments and polylines: render/lines/polyline.h.
#include "render/lines/polyline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace terrview {
namespace {

LineSegment segment(int a, int b) {
  return {LineKind::grid, {{a, 0}, {b, 0}}, {{a, 0}, {b, 0}}, {1, 1}, 0};
}

double distance_to(glm::dvec2 p, const std::vector<glm::dvec2>& line) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const glm::dvec2 along = line[i] - line[i - 1];
    const double square = glm::dot(along, along);
    const double t =
        square > 0 ? glm::clamp(glm::dot(p - line[i - 1], along) / square, 0.0, 1.0) : 0;
    least = std::min(least, glm::distance(p, line[i - 1] + t * along));
  }
  return least;
}

TEST(JoinedSegments, MakeOneLineOfAChainWhateverTheirOrder) {
  const auto lines = join_segments({segment(3, 2), segment(0, 1), segment(4, 3), segment(2, 1)});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].points_px.size(), 5U);
  EXPECT_EQ(length_px(lines[0].points_px), 4);
}

TEST(JoinedSegments, CloseWhereALineDoesAndEndWhereThreeMeet) {
  const auto closed = join_segments({segment(0, 1), segment(1, 2), segment(2, 0)});
  ASSERT_EQ(closed.size(), 1U);
  EXPECT_EQ(closed[0].points_px.front(), closed[0].points_px.back());
  EXPECT_EQ(join_segments({segment(0, 1), segment(1, 2), segment(1, 3)}).size(), 3U);
}

TEST(JoinedSegments, OfOtherKindsStayApart) {
  LineSegment outline = segment(1, 2);
  outline.kind = LineKind::silhouette;
  EXPECT_EQ(join_segments({segment(0, 1), outline}).size(), 2U);
}

RC_GTEST_PROP(JoinedSegments, HaveEverySegmentOnce, ()) {
  std::vector<LineSegment> segments;
  double before = 0;
  for (int i = *rc::gen::inRange(0, 80); i > 0; --i) {
    const int a = *rc::gen::inRange(0, 40);
    const int b = *rc::gen::inRange(0, 40);
    segments.push_back(segment(a, b));
    before += std::abs(a - b);
  }
  std::size_t pieces = 0;
  double after = 0;
  for (const Polyline& line : join_segments(segments)) {
    pieces += line.points_px.size() - 1;
    after += length_px(line.points_px);
  }
  RC_ASSERT(pieces == segments.size());
  RC_ASSERT(after == before);
}

RC_GTEST_PROP(SimplifiedLine, StaysWithinItsToleranceAndKeepsItsEnds, ()) {
  std::vector<glm::dvec2> points;
  glm::dvec2 at(0);
  for (int i = *rc::gen::inRange(2, 120); i > 0; --i) {
    at += glm::dvec2(*rc::gen::inRange(-10, 30), *rc::gen::inRange(-10, 11)) / 20.0;
    points.push_back(at);
  }
  const auto few = simplified(points, 0.15);
  RC_ASSERT(few.front() == points.front());
  RC_ASSERT(few.back() == points.back());
  for (const glm::dvec2& point : points) RC_ASSERT(distance_to(point, few) <= 0.15 + 1e-12);
}

}  // namespace
}  // namespace terrview
