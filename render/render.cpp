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
#include "terrain/view_transform.h"

namespace terrview {
namespace {

glm::vec3 sky_color(const SkyGradient& sky, const glm::dvec3& direction) {
  // The square root spends most of the gradient near the horizon, as the air does.
  const double height = std::sqrt(std::max(0.0, glm::normalize(direction).z));
  return glm::mix(sky.horizon, sky.zenith, static_cast<float>(height));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Renders rows of one frame. Pixels do not depend on each other, so any thread may take any row.
class RowRenderer {
 public:
  RowRenderer(const Scene& scene, const Camera& camera, Frame& frame)
      : scene_(scene), camera_(camera), frame_(frame) {}

  RenderCounts render_row(int row) const {
    RenderCounts counts;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<std::optional<Hit>> hits = trace_row(row, counts);
    counts.trace_s = seconds_since(start);
    const auto traced = std::chrono::steady_clock::now();
    for (int column = 0; column < frame_.image.width_px(); ++column) {
      const auto& hit = hits[static_cast<std::size_t>(column)];
      frame_.image.at(column, row) = hit ? shade_ground(*hit, {column, row}, counts)
                                         : sky_color(scene_.sky, ray({column, row}).direction);
    }
    counts.shade_s = seconds_since(traced);
    return counts;
  }

 private:
  [[nodiscard]] Ray ray(glm::ivec2 pixel) const { return camera_.ray(glm::dvec2(pixel) + 0.5); }

  std::vector<std::optional<Hit>> trace_row(int row, RenderCounts& counts) const {
    const int width_px = frame_.image.width_px();
    std::vector<std::optional<Hit>> hits(static_cast<std::size_t>(width_px));
    TraceCounts traced;
    for (int column = 0; column < width_px; ++column) {
      auto& hit = hits[static_cast<std::size_t>(column)];
      hit = scene_.terrain->first_hit(ray({column, row}), &traced);
      if (hit) ++counts.hits;
    }
    counts.rays = width_px;
    counts.tests = traced.tests;
    return hits;
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
};

}  // namespace

RenderCounts& RenderCounts::operator+=(const RenderCounts& other) {
  rays += other.rays;
  hits += other.hits;
  tests += other.tests;
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
  const RowRenderer renderer(scene, camera, frame);

  std::vector<RenderCounts> counts(static_cast<std::size_t>(size.y));
  std::atomic<int> rows_done{0};
  parallel_rows(size.y, options.threads, [&](int row) {
    counts[static_cast<std::size_t>(row)] = renderer.render_row(row);
    const int done = ++rows_done;
    if (options.progress) options.progress(static_cast<double>(done) / size.y);
  });
  for (const RenderCounts& row : counts) frame.counts += row;
  return frame;
}

}  // namespace terrview
