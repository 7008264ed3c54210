#include "render/pixel_tracer.h"

#include <algorithm>
#include <memory>

#include "terrain/eye_tracer.h"

namespace terrview {
namespace {

constexpr int kStripColumns = 32;

}  // namespace

PixelTracer::PixelTracer(const Terrain& terrain, const Camera& camera, bool coherence,
                         const EyeFront* front, const PixelLattice& lattice)
    : terrain_(terrain), camera_(camera), front_(front), lattice_(lattice) {
  if (coherence && has_columns(terrain)) columns_ = column_view(camera, lattice);
}

std::vector<Block> PixelTracer::blocks() const {
  const glm::ivec2 count = lattice_.count;
  std::vector<Block> blocks;
  if (columns_) {
    for (int column = 0; column < count.x; column += kStripColumns)
      blocks.push_back({{column, 0}, {std::min(kStripColumns, count.x - column), count.y}});
  } else {
    for (int row = 0; row < count.y; ++row) blocks.push_back({{0, row}, {count.x, 1}});
  }
  return blocks;
}

std::vector<glm::ivec2> PixelTracer::points(
    const Block& block, const std::function<bool(glm::ivec2 point)>& wanted) const {
  std::vector<glm::ivec2> points;
  points.reserve(block.points());
  for (int column = block.first.x; column < block.first.x + block.size.x; ++column) {
    for (int row = block.first.y; row < block.first.y + block.size.y; ++row)
      if (wanted({column, row})) points.emplace_back(column, row);
  }
  return points;
}

std::vector<Ray> PixelTracer::rays(std::span<const glm::ivec2> points) const {
  std::vector<Ray> rays;
  rays.reserve(points.size());
  for (const glm::ivec2& point : points) rays.push_back(camera_.ray(lattice_.at(point)));
  return rays;
}

std::vector<std::optional<Hit>> PixelTracer::trace(const Block& block,
                                                   std::span<const glm::ivec2> points,
                                                   TraceCounts& counts) const {
  if (points.empty()) return {};
  if (columns_) return trace_strip(block, points, counts);
  return trace_rays(terrain_, front_, rays(points), counts);
}

std::vector<std::optional<Hit>> PixelTracer::trace_strip(const Block& block,
                                                         std::span<const glm::ivec2> points,
                                                         TraceCounts& counts) const {
  // Rays begin where those below them ended, so leaving out points of a column would spare little.
  std::vector<ColumnHit> met(block.points());
  if (front_)
    trace_columns(*front_, *columns_, block.first.x, block.size.x, met, counts);
  else
    trace_columns(terrain_, *columns_, block.first.x, block.size.x, met, counts);
  std::vector<std::optional<Hit>> hits;
  hits.reserve(points.size());
  for (const glm::ivec2& point : points) {
    const glm::ivec2 at = point - block.first;
    const ColumnHit& hit = met[static_cast<std::size_t>(at.x * block.size.y + at.y)];
    if (hit.g_m < 0)
      hits.emplace_back();
    else
      hits.emplace_back(column_hit(*columns_, point.x, point.y, hit));
  }
  return hits;
}

std::vector<std::optional<Hit>> trace_rays(const Terrain& terrain, const EyeFront* front,
                                           std::span<const Ray> rays, TraceCounts& counts) {
  std::vector<std::optional<Hit>> hits;
  hits.reserve(rays.size());
  if (front) {
    const auto batch = std::make_unique<EyeRays>();
    for (std::size_t first = 0; first < rays.size(); first += EyeRays::kMost) {
      batch->count = std::min(EyeRays::kMost, rays.size() - first);
      for (std::size_t i = 0; i < batch->count; ++i) batch->aim(i, rays[first + i].direction);
      terrview::trace(*front, *batch, counts);
      for (std::size_t i = 0; i < batch->count; ++i)
        hits.push_back(batch->is_hit(i) ? std::optional(batch->hit(i)) : std::nullopt);
    }
    return hits;
  }
  for (const Ray& ray : rays) hits.push_back(terrain.first_hit(ray, &counts));
  return hits;
}

}  // namespace terrview
