#include "render/render.h"

#include <atomic>
#include <chrono>
#include <optional>
#include <vector>

#include "render/parallel.h"
#include "render/pixel_tracer.h"
#include "render/shade.h"

namespace terrview {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Renders the pixels of a block into `frame`. Pixels do not depend on each other, so any thread may
// take any block.
RenderCounts render_block(const Scene& scene, const PixelTracer& tracer, const Block& block,
                          Frame& frame) {
  RenderCounts counts;
  const auto start = std::chrono::steady_clock::now();
  TraceCounts traced;
  const std::vector<std::optional<Hit>> hits = tracer.trace(block, traced);
  counts.rays = static_cast<std::int64_t>(hits.size());
  counts.tests = traced.tests;
  counts.nodes = traced.nodes;
  counts.trace_s = seconds_since(start);
  const auto shading = std::chrono::steady_clock::now();
  const std::vector<ShadedRay> shaded = shade(scene, tracer.rays(block), hits, counts.shadow_rays);
  std::size_t i = 0;
  for (int column = block.first.x; column < block.first.x + block.size.x; ++column) {
    for (int row = block.first.y; row < block.first.y + block.size.y; ++row, ++i) {
      frame.image.at(column, row) = shaded[i].color;
      if (!hits[i]) continue;
      ++counts.hits;
      if (!frame.samples.empty())
        frame.samples.at(column, row) = {hits[i]->position_m, shaded[i].normal,
                                         PixelSample::kGround};
    }
  }
  counts.shade_s = seconds_since(shading);
  return counts;
}

}  // namespace

RenderCounts& RenderCounts::operator+=(const RenderCounts& other) {
  rays += other.rays;
  hits += other.hits;
  tests += other.tests;
  nodes += other.nodes;
  shadow_rays += other.shadow_rays;
  trace_s += other.trace_s;
  shade_s += other.shade_s;
  return *this;
}

Frame render(const Scene& scene, const Camera& camera, const RenderOptions& options) {
  const glm::ivec2 size = camera.options().size_px;
  Frame frame;
  frame.image = Image(size.x, size.y);
  if (options.keep_samples) frame.samples = Raster<PixelSample>(size.x, size.y);
  const PixelTracer tracer(*scene.terrain, camera, options.coherence, pixel_centres(camera));
  const std::vector<Block> blocks = tracer.blocks();
  const int count = static_cast<int>(blocks.size());

  std::vector<RenderCounts> counts(blocks.size());
  std::atomic<int> blocks_done{0};
  parallel_for(count, options.threads, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    counts[i] = render_block(scene, tracer, blocks[i], frame);
    const int done = ++blocks_done;
    if (options.progress) options.progress(static_cast<double>(done) / count);
  });
  for (const RenderCounts& block : counts) frame.counts += block;
  return frame;
}

}  // namespace terrview
