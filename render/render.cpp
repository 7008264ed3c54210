#include "render/render.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/parallel.h"
#include "terrain/column_tracer.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

glm::vec3 sky_color(const SkyGradient& sky, const glm::dvec3& direction) {
  // The square root spends most of the gradient near the horizon, as the air does.
  const double height = std::sqrt(std::max(0.0, glm::normalize(direction).z));
  return glm::mix(sky.horizon, sky.zenith, static_cast<float>(height));
}

// A rectangle of pixels that one thread renders at a time.
struct Block {
  glm::ivec2 first;
  glm::ivec2 size;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Renders blocks of one frame. Pixels do not depend on each other, so any thread may take any
// block.
class BlockRenderer {
 public:
  BlockRenderer(const Scene& scene, const Camera& camera, bool coherence, Frame& frame)
      : scene_(scene), camera_(camera), frame_(frame) {
    if (coherence && has_columns(*scene.terrain)) columns_ = column_view(camera);
  }

  // Strips of columns where columns are coherent, else rows.
  [[nodiscard]] std::vector<Block> blocks() const {
    const glm::ivec2 size = camera_.options().size_px;
    const int step = columns_ ? kStripColumns : 1;
    std::vector<Block> blocks;
    if (columns_) {
      for (int column = 0; column < size.x; column += step)
        blocks.push_back({{column, 0}, {std::min(step, size.x - column), size.y}});
    } else {
      for (int row = 0; row < size.y; ++row) blocks.push_back({{0, row}, {size.x, 1}});
    }
    return blocks;
  }

  RenderCounts render(const Block& block) const {
    RenderCounts counts;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<std::optional<Hit>> hits = trace(block, counts);
    counts.rays = static_cast<std::int64_t>(hits.size());
    counts.trace_s = seconds_since(start);
    const auto traced = std::chrono::steady_clock::now();
    auto hit = hits.begin();
    for (int column = block.first.x; column < block.first.x + block.size.x; ++column) {
      for (int row = block.first.y; row < block.first.y + block.size.y; ++row, ++hit) {
        counts.hits += hit->has_value() ? 1 : 0;
        frame_.image.at(column, row) = *hit ? shade_ground(**hit, {column, row}, counts)
                                            : sky_color(scene_.sky, ray({column, row}).direction);
      }
    }
    counts.shade_s = seconds_since(traced);
    return counts;
  }

 private:
  static constexpr int kStripColumns = 16;

  [[nodiscard]] Ray ray(glm::ivec2 pixel) const { return camera_.ray(glm::dvec2(pixel) + 0.5); }

  // The hits of a block, column by column.
  std::vector<std::optional<Hit>> trace(const Block& block, RenderCounts& counts) const {
    std::vector<std::optional<Hit>> hits;
    hits.reserve(static_cast<std::size_t>(block.size.x) * static_cast<std::size_t>(block.size.y));
    TraceCounts traced;
    if (columns_) {
      trace_strip(block, hits, traced);
    } else {
      for (int column = block.first.x; column < block.first.x + block.size.x; ++column) {
        for (int row = block.first.y; row < block.first.y + block.size.y; ++row)
          hits.push_back(scene_.terrain->first_hit(ray({column, row}), &traced));
      }
    }
    counts.tests = traced.tests;
    counts.nodes = traced.nodes;
    return hits;
  }

  void trace_strip(const Block& block, std::vector<std::optional<Hit>>& hits,
                   TraceCounts& counts) const {
    std::vector<ColumnHit> met(hits.capacity());
    trace_columns(*scene_.terrain, *columns_, block.first.x, block.size.x, met, counts);
    auto next = met.begin();
    for (int column = block.first.x; column < block.first.x + block.size.x; ++column) {
      for (int row = 0; row < block.size.y; ++row, ++next) {
        if (next->g_m < 0)
          hits.emplace_back();
        else
          hits.emplace_back(column_hit(*columns_, column, row, *next));
      }
    }
  }

  glm::vec3 shade_ground(const Hit& hit, glm::ivec2 pixel, RenderCounts& counts) const {
    const glm::dvec3 normal = scene_.normals == NormalKind::facet
                                  ? scene_.terrain->facet_normal(hit)
                                  : scene_.terrain->smooth_normal(hit);
    if (!frame_.samples.empty())
      frame_.samples.at(pixel.x, pixel.y) = {hit.position_m, glm::vec3(normal),
                                             PixelSample::kGround};
    const VerticalFrame& frame = scene_.terrain->frame();
    const double height_m =
        frame.at(glm::dvec2(hit.position_m)).scene_height_m(hit.position_m.z) / frame.z_scale;
    const glm::vec3 color = scene_.tints.at(height_m);
    const Light& light = scene_.light;
    const glm::dvec3 to_sun = local_direction(frame, hit.position_m, light.towards_sun);
    const double facing = glm::dot(normal, to_sun);
    if (facing <= 0 || to_sun.z <= 0 || in_shadow(hit, counts)) return light.ambient * color;
    return (light.ambient + static_cast<float>(facing) * light.sun) * color;
  }

  bool in_shadow(const Hit& hit, RenderCounts& counts) const {
    if (!scene_.light.casts_shadows) return false;
    ++counts.shadow_rays;
    const glm::dvec3 direction =
        direction_at(scene_.terrain->frame(), hit.position_m, scene_.light.towards_sun);
    return scene_.terrain->occluded(scene_.terrain->leave(hit, direction));
  }

  const Scene& scene_;
  const Camera& camera_;
  Frame& frame_;
  std::optional<ColumnView> columns_;
};

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
  const BlockRenderer renderer(scene, camera, options.coherence, frame);
  const std::vector<Block> blocks = renderer.blocks();
  const int count = static_cast<int>(blocks.size());

  std::vector<RenderCounts> counts(blocks.size());
  std::atomic<int> blocks_done{0};
  parallel_for(count, options.threads, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    counts[i] = renderer.render(blocks[i]);
    const int done = ++blocks_done;
    if (options.progress) options.progress(static_cast<double>(done) / count);
  });
  for (const RenderCounts& block : counts) frame.counts += block;
  return frame;
}

}  // namespace terrview
