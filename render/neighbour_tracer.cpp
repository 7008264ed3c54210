#include "render/neighbour_tracer.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>

#include "render/neighbour_order.h"
#include "render/parallel.h"
#include "terrain/tracer.h"

namespace terrview {
namespace {

// As many pixels a task as make its cost worth a thread's while.
constexpr int kChunk_px = 64;

// Above the rounding with which two rays of one plane meet the same ground.
constexpr double kShrink = 1 - 1e-9;

constexpr double kNever = std::numeric_limits<double>::infinity();

class NeighbourTracer {
 public:
  NeighbourTracer(const Terrain& terrain, const Camera& camera)
      : terrain_(terrain),
        camera_(camera),
        order_(camera),
        hits_(camera.options().size_px.x, camera.options().size_px.y),
        clear_m_(camera.options().size_px.x, camera.options().size_px.y) {}

  Raster<std::optional<Hit>> run(int threads, TraceCounts& counts) {
    std::atomic<std::int64_t> tests = 0;
    std::atomic<std::int64_t> nodes = 0;
    for (const std::vector<glm::ivec2>& step : order_.steps()) {
      const int pixels = static_cast<int>(step.size());
      parallel_for((pixels + kChunk_px - 1) / kChunk_px, threads, [&](int chunk) {
        TraceCounts mine;
        const int end = std::min((chunk + 1) * kChunk_px, pixels);
        for (int i = chunk * kChunk_px; i < end; ++i)
          trace_pixel(step[static_cast<std::size_t>(i)], mine);
        tests += mine.tests;
        nodes += mine.nodes;
      });
    }
    counts.tests += tests;
    counts.nodes += nodes;
    return std::move(hits_);
  }

 private:
  // As far as the pixel's ray is taken to be clear.
  [[nodiscard]] double start_m(glm::ivec2 pixel) const {
    const Forerunners before = order_.forerunners(pixel);
    if (before.count == 0) return 0;
    const double first_m = clear_m_.at(before.first.x, before.first.y);
    if (before.count == 1) return kShrink * first_m;
    return kShrink * std::min(first_m, clear_m_.at(before.second.x, before.second.y));
  }

  void trace_pixel(glm::ivec2 pixel, TraceCounts& counts) {
    double& clear_m = clear_m_.at(pixel.x, pixel.y);
    const double from_m = start_m(pixel);
    if (from_m == kNever) {
      clear_m = kNever;
      return;
    }
    const Ray ray = camera_.ray(glm::dvec2(pixel) + 0.5);
    const Trace found = trace(terrain_, terrain_.ceiling_m(), ray, from_m);
    counts.tests += found.counts.tests;
    counts.nodes += found.counts.nodes;
    // A ray that ends below an edge says nothing of those above it.
    clear_m = found.outcome == Outcome::hit    ? found.ground_m
              : found.outcome == Outcome::free ? kNever
                                               : 0;
    if (found.outcome == Outcome::hit) hits_.at(pixel.x, pixel.y) = found.hit;
  }

  const Terrain& terrain_;
  const Camera& camera_;
  NeighbourOrder order_;
  Raster<std::optional<Hit>> hits_;
  Raster<double> clear_m_;  // by pixel: where its ray meets ground
};

}  // namespace

Raster<std::optional<Hit>> trace_by_neighbours(const Terrain& terrain, const Camera& camera,
                                               int threads, TraceCounts& counts) {
  return NeighbourTracer(terrain, camera).run(threads, counts);
}

}  // namespace terrview
