#include "render/lines/polyline.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace terrview {
namespace {

// One end of a segment.
struct End {
  std::size_t segment;
  int side;
};

class Joiner {
 public:
  explicit Joiner(const std::vector<LineSegment>& segments)
      : segments_(segments), joined_(segments.size(), {kNone, kNone}), done_(segments.size()) {
    std::vector<End> ends;
    ends.reserve(2 * segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) ends.insert(ends.end(), {{i, 0}, {i, 1}});
    const auto key = [&](const End& end) {
      const LineSegment& segment = segments[end.segment];
      return std::tuple(segment.ends[end.side], segment.kind, end.segment, end.side);
    };
    std::sort(ends.begin(), ends.end(),
              [&](const End& a, const End& b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < ends.size();) {
      std::size_t last = i;
      while (last < ends.size() && meet(ends[i], ends[last])) ++last;
      if (last - i == 2) {
        next(ends[i]) = ends[i + 1];
        next(ends[i + 1]) = ends[i];
      }
      i = last;
    }
  }

  std::vector<Polyline> join() {
    std::vector<Polyline> lines;
    // Lines with an end first; what is left closes.
    for (const bool open : {true, false}) {
      for (std::size_t i = 0; i < segments_.size(); ++i) {
        for (const int side : {0, 1})
          if (!done_[i] && (!open || next({i, side}).segment == kNone.segment))
            lines.push_back(walk({i, side}));
      }
    }
    return lines;
  }

 private:
  static constexpr End kNone{static_cast<std::size_t>(-1), 0};

  [[nodiscard]] bool meet(const End& a, const End& b) const {
    const LineSegment& one = segments_[a.segment];
    const LineSegment& other = segments_[b.segment];
    return one.kind == other.kind && one.ends[a.side] == other.ends[b.side];
  }

  End& next(const End& end) {
    auto& ends = joined_[end.segment];
    return end.side == 0 ? ends.first : ends.second;
  }

  Polyline walk(End start) {
    Polyline line{segments_[start.segment].kind, {}, {}, 0};
    add(start, line);
    while (start.segment != kNone.segment && !done_[start.segment]) {
      done_[start.segment] = true;
      line.gap = std::max(line.gap, segments_[start.segment].gap);
      const End end{start.segment, 1 - start.side};
      add(end, line);
      start = next(end);
    }
    return line;
  }

  void add(const End& end, Polyline& line) const {
    line.points_px.push_back(segments_[end.segment].points_px[end.side]);
    line.distances_m.push_back(segments_[end.segment].distances_m[end.side]);
  }

  const std::vector<LineSegment>& segments_;
  std::vector<std::pair<End, End>> joined_;  // what the ends of a segment meet
  std::vector<bool> done_;
};

double distance_to_segment(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double square = glm::dot(along, along);
  const double share = square > 0 ? glm::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0;
  return glm::distance(point, a + share * along);
}

}  // namespace

std::vector<Polyline> join_segments(const std::vector<LineSegment>& segments) {
  return Joiner(segments).join();
}

std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& points_px, double tolerance_px) {
  if (points_px.size() < 3) return points_px;
  std::vector<bool> kept(points_px.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, points_px.size() - 1}};
  while (!spans.empty()) {
    const auto [first, last] = spans.back();
    spans.pop_back();
    double most_px = tolerance_px;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double away_px = distance_to_segment(points_px[i], points_px[first], points_px[last]);
      if (away_px <= most_px) continue;
      most_px = away_px;
      at = i;
    }
    if (at == first) continue;
    kept[at] = true;
    spans.insert(spans.end(), {{first, at}, {at, last}});
  }
  std::vector<glm::dvec2> result;
  for (std::size_t i = 0; i < points_px.size(); ++i)
    if (kept[i]) result.push_back(points_px[i]);
  return result;
}

double length_px(const std::vector<glm::dvec2>& points_px) {
  double sum = 0;
  for (std::size_t i = 1; i < points_px.size(); ++i)
    sum += glm::distance(points_px[i - 1], points_px[i]);
  return sum;
}

}  // namespace terrview
