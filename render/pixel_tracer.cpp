#include "render/pixel_tracer.h"

#include <algorithm>

namespace terrview {
namespace {

constexpr int kStripColumns = 16;

}  // namespace

PixelTracer::PixelTracer(const Terrain& terrain, const Camera& camera, bool coherence,
                         const PixelLattice& lattice)
    : terrain_(terrain), camera_(camera), lattice_(lattice) {
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

std::vector<Ray> PixelTracer::rays(const Block& block) const {
  std::vector<Ray> rays;
  rays.reserve(block.points());
  for (int column = block.first.x; column < block.first.x + block.size.x; ++column) {
    for (int row = block.first.y; row < block.first.y + block.size.y; ++row)
      rays.push_back(camera_.ray(lattice_.at({column, row})));
  }
  return rays;
}

std::vector<std::optional<Hit>> PixelTracer::trace(const Block& block, TraceCounts& counts) const {
  std::vector<std::optional<Hit>> hits;
  hits.reserve(block.points());
  if (columns_) {
    trace_strip(block, hits, counts);
  } else {
    for (const Ray& ray : rays(block)) hits.push_back(terrain_.first_hit(ray, &counts));
  }
  return hits;
}

void PixelTracer::trace_strip(const Block& block, std::vector<std::optional<Hit>>& hits,
                              TraceCounts& counts) const {
  std::vector<ColumnHit> met(block.points());
  trace_columns(terrain_, *columns_, block.first.x, block.size.x, met, counts);
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

}  // namespace terrview
