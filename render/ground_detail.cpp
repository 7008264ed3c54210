#include "render/ground_detail.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace terrview {
namespace {

// Footprints longer than this many times their width count as so long: further, nothing is seen.
constexpr double kLongest = 256;

}  // namespace

GroundDetail::GroundDetail(const Terrain& terrain, MeansOfGrids known) {
  for (const TerrainLayer& layer : terrain.layers()) {
    auto& means = known[layer.grid.get()];
    if (!means) means = std::make_shared<const MeanHeights>(*layer.grid);
    layers_.push_back({means, post_distance_m(layer)});
  }
}

GroundDetail::Ground GroundDetail::seen(const Terrain& terrain, const Ray& ray, const Hit& hit,
                                        double width_m, const Ground& exact) const {
  const Layer& layer = layers_[static_cast<std::size_t>(hit.grid)];
  // From straight above a pixel covers the same posts whatever the slope.
  const bool plumb = glm::dvec2(ray.direction) == glm::dvec2(0);
  const double facing = plumb ? 1 : std::abs(glm::dot(exact.normal, glm::normalize(ray.direction)));
  const double side_m = width_m / std::sqrt(std::max(facing, 1 / kLongest));
  if (side_m <= layer.post_m) return exact;
  const double level = std::log2(side_m / layer.post_m);
  const auto mean = layer.means->at(level, hit.uv);
  if (!mean) return exact;
  const Ground averaged{normal_of_slope(terrain, hit, mean->slope_m), mean->height_m};
  if (level >= 1) return averaged;
  return {glm::normalize(glm::mix(exact.normal, averaged.normal, level)),
          glm::mix(exact.height_m, averaged.height_m, level)};
}

}  // namespace terrview
