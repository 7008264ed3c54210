#include "render/lines/wireline.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>

#include "render/lines/line_cells.h"
#include "render/lines/line_tracer.h"
#include "render/parallel.h"

namespace terrview {
namespace {

constexpr double kTolerance_px = 0.15;
// Shorter lines are specks, but for those of objects and of the sky, and of gaps as wide as these.
constexpr double kLeast_px = 4;
constexpr double kVast = 100;
// An outline of the ground is drawn where it has such a gap somewhere: two posts and a fiftieth of
// the distance. Along it, gaps that are less do not break it.
constexpr double kWide = 3;
constexpr int kStripRows = 16;

class Tracing {
 public:
  Tracing(const Scene& scene, const Camera& camera, const WirelineTracing& options)
      : tracer_(scene, camera), options_(options), size_(camera.options().size_px) {}

  [[nodiscard]] std::vector<LineSegment> segments() const {
    const int rows = size_.y + 1;
    std::vector<std::vector<LineSegment>> strips(
        static_cast<std::size_t>((rows + kStripRows - 1) / kStripRows));
    std::atomic<int> done{0};
    parallel_for(static_cast<int>(strips.size()), options_.threads, [&](int strip) {
      const int first = strip * kStripRows;
      strips[static_cast<std::size_t>(strip)] =
          strip_segments(first, std::min(rows, first + kStripRows));
      if (options_.progress)
        options_.progress(static_cast<double>(++done) / static_cast<double>(strips.size()));
    });
    std::vector<LineSegment> all;
    for (const auto& strip : strips) all.insert(all.end(), strip.begin(), strip.end());
    return all;
  }

 private:
  [[nodiscard]] std::vector<LineSegment> strip_segments(int first, int last) const {
    const GridLineOptions grid{.step_posts = options_.step_posts};
    std::vector<LineSegment> segments;
    std::vector<LinePoint> upper = points(first);
    for (int row = first; row < last; ++row) {
      std::vector<LinePoint> lower = points(row + 1);
      const auto more = row_segments(tracer_, row, upper, lower, grid);
      segments.insert(segments.end(), more.begin(), more.end());
      upper = std::move(lower);
    }
    return segments;
  }

  [[nodiscard]] std::vector<LinePoint> points(int row) const {
    std::vector<glm::dvec2> at_px;
    for (int column = 0; column < size_.x + 2; ++column) at_px.push_back(lattice_px(column, row));
    return tracer_.at(at_px);
  }

  LineTracer tracer_;
  const WirelineTracing& options_;
  glm::ivec2 size_;
};

// From the nearest to the furthest, in equal ratios.
std::vector<double> depth_limits(const std::vector<LineSegment>& segments) {
  if (segments.empty()) return {};
  double nearest_m = std::numeric_limits<double>::infinity();
  double furthest_m = 1e-3;
  for (const LineSegment& segment : segments) {
    for (const double distance_m : segment.distances_m) {
      nearest_m = std::min(nearest_m, std::max(distance_m, 1e-3));
      furthest_m = std::max(furthest_m, distance_m);
    }
  }
  std::vector<double> limits;
  for (int i = 0; i <= Wireline::kDepths; ++i)
    limits.push_back(nearest_m *
                     std::pow(furthest_m / nearest_m, static_cast<double>(i) / Wireline::kDepths));
  return limits;
}

int depth_of(const std::vector<double>& limits_m, double distance_m) {
  const auto above = std::upper_bound(limits_m.begin(), limits_m.end(), distance_m);
  return std::clamp(static_cast<int>(above - limits_m.begin()) - 1, 0, Wireline::kDepths - 1);
}

// Cuts a polyline where its depth changes.
void add_line(const Polyline& line, Wireline& wireline) {
  if (line.kind != LineKind::object && line.gap < kVast && length_px(line.points_px) < kLeast_px)
    return;
  if (line.kind == LineKind::silhouette && line.gap < kWide) return;
  ViewLine part{line.kind, depth_of(wireline.limits_m, line.distances_m.front()), {}};
  const auto finish = [&] {
    part.points_px = simplified(part.points_px, kTolerance_px);
    if (part.points_px.size() > 1) wireline.lines.push_back(part);
  };
  for (std::size_t i = 0; i < line.points_px.size(); ++i) {
    part.points_px.push_back(line.points_px[i]);
    const int depth = depth_of(wireline.limits_m, line.distances_m[i]);
    if (depth == part.depth) continue;
    finish();
    part.depth = depth;
    part.points_px = {line.points_px[i]};
  }
  finish();
}

}  // namespace

Wireline trace_wireline(const Scene& scene, const Camera& camera, const WirelineTracing& options) {
  const std::vector<LineSegment> segments = Tracing(scene, camera, options).segments();
  Wireline wireline{depth_limits(segments), {}};
  for (const Polyline& line : join_segments(segments)) add_line(line, wireline);
  return wireline;
}

}  // namespace terrview
