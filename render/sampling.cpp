#include "render/sampling.h"

#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/neighbour_tracer.h"
#include "render/objects/scene_objects.h"
#include "render/parallel.h"
#include "render/pixel_tracer.h"
#include "render/stopwatch.h"
#include "render/view_front.h"
#include "render/water.h"

namespace terrview {
namespace {

RenderCounts count_of(const TraceCounts& traced) {
  RenderCounts counts;
  counts.tests = traced.tests;
  counts.nodes = traced.nodes;
  return counts;
}

std::int64_t count_hits(const RayHits& hits) {
  std::int64_t count = 0;
  for (const auto& hit : hits.ground) count += hit ? 1 : 0;
  for (const auto& hit : hits.objects) count += hit ? 1 : 0;
  return count;
}

}  // namespace

glm::dvec2 sample_offset(int index) {
  if (index == 0) return {0.5, 0.5};
  // The bits of the index in reverse, and Sobol's second dimension, whose direction numbers are the
  // rows of Pascal's triangle modulo 2.
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t direction = 1U << 31;
  for (int bit = 0; bit < 31; ++bit, direction ^= direction >> 1) {
    if ((static_cast<std::uint32_t>(index) >> bit & 1U) == 0) continue;
    x ^= 1U << (31 - bit);
    y ^= direction;
  }
  // Turned by half a pixel, which keeps the strata, and centred in those of sixteen rays.
  constexpr double kTurn = 0.5 + 1.0 / 32;
  const glm::dvec2 at = glm::dvec2(x, y) * 0x1p-32 + kTurn;
  return {at.x - std::floor(at.x), at.y - std::floor(at.y)};
}

Sampler::Sampler(const Scene& scene, const Camera& camera, const RenderOptions& options)
    : scene_(scene), camera_(camera), options_(options), pixel_width_(pixel_width(camera)) {
  if (options.coherence == Coherence::on)
    front_ = view_front(*scene.terrain, camera, options.threads);
  if (options.coherence != Coherence::neighbours) return;
  Stopwatch stopwatch;
  TraceCounts traced;
  centres_ = trace_by_neighbours(*scene.terrain, camera, options.threads, traced);
  total.tests = traced.tests;
  total.nodes = traced.nodes;
  total.trace_s = stopwatch.lap();
}

void Sampler::set_progress(double from, double to) {
  progress_from_ = from;
  progress_to_ = to;
}

void Sampler::report(double share) const {
  if (options_.progress)
    options_.progress(progress_from_ + (progress_to_ - progress_from_) * share);
}

void Sampler::trace_lattice(int index, int step, const Wanted& wanted, const Take& take) {
  const glm::ivec2 size = camera_.options().size_px;
  const PixelLattice lattice{sample_offset(index), step, (size + step - 1) / step};
  const PixelTracer tracer(*scene_.terrain, camera_, options_.coherence == Coherence::on,
                           front_.get(), lattice);
  const bool known = index == 0 && !centres_.empty();
  const std::vector<Block> blocks = tracer.blocks();
  std::vector<RenderCounts> block_counts(blocks.size());
  std::atomic<int> done{0};
  const int count = static_cast<int>(blocks.size());
  parallel_for(count, options_.threads, [&](int i) {
    const auto b = static_cast<std::size_t>(i);
    block_counts[b] = trace_block(tracer, {blocks[b], step, known}, wanted, take);
    report(static_cast<double>(++done) / count);
  });
  for (const RenderCounts& block : block_counts) total += block;
}

std::vector<ShadedRay> Sampler::shade_rays(std::span<const Ray> rays, RayHits& hits,
                                           RenderCounts& counts) const {
  Stopwatch stopwatch;
  meet_water(scene_, rays, hits);
  meet_objects(scene_, rays, hits, counts.objects);
  counts.rays = static_cast<std::int64_t>(rays.size());
  counts.hits = count_hits(hits);
  counts.trace_s += stopwatch.lap();
  ShadowCounts shadows;
  std::vector<ShadedRay> shaded = shade(scene_, {pixel_width_}, rays, hits, shadows);
  counts.shadow_rays = shadows.rays;
  counts.shadow_objects = shadows.objects;
  counts.shade_s = stopwatch.lap();
  return shaded;
}

Seen Sampler::seen(const RayHits& hits, std::size_t i) const {
  if (hits.meets_object(i)) {
    const ObjectHit& hit = *hits.objects[i];
    return {scene_.objects->looks[static_cast<std::size_t>(hit.object)].id, hit.surface.position_m};
  }
  if (hits.ground[i]) return {PixelSample::kGround, hits.ground[i]->position_m};
  return {};
}

RenderCounts Sampler::trace_block(const PixelTracer& tracer, const LatticeBlock& part,
                                  const Wanted& wanted, const Take& take) const {
  Stopwatch stopwatch;
  const int step = part.step;
  const std::vector<glm::ivec2> points =
      tracer.points(part.block, [&](glm::ivec2 point) { return !wanted || wanted(step * point); });
  TraceCounts traced;
  const std::vector<Ray> rays = tracer.rays(points);
  RayHits hits;
  if (part.is_known) {
    for (const glm::ivec2& point : points)
      hits.ground.push_back(centres_.at(step * point.x, step * point.y));
  } else {
    hits.ground = tracer.trace(part.block, points, traced);
  }
  RenderCounts counts = count_of(traced);
  counts.trace_s = stopwatch.lap();
  const std::vector<ShadedRay> shaded = shade_rays(rays, hits, counts);
  for (std::size_t i = 0; i < points.size(); ++i) take(step * points[i], shaded[i], seen(hits, i));
  return counts;
}

std::vector<Sample> Sampler::trace_points(std::span<const glm::dvec2> points_px,
                                          RenderCounts& counts) const {
  Stopwatch stopwatch;
  std::vector<Ray> rays;
  for (const glm::dvec2& point : points_px) rays.push_back(camera_.ray(point));
  TraceCounts traced;
  RayHits hits{trace_rays(*scene_.terrain, front_.get(), rays, traced)};
  RenderCounts mine = count_of(traced);
  mine.trace_s = stopwatch.lap();
  std::vector<Sample> samples;
  for (const ShadedRay& shaded : shade_rays(rays, hits, mine))
    samples.push_back({shaded.color, shaded.distance_m});
  counts += mine;
  return samples;
}

}  // namespace terrview
