#include "render/ground_detail.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/drape.h"

namespace terrview {

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
  const double side_m = width_m * std::sqrt(footprint_area(ray.direction, exact.normal));
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
