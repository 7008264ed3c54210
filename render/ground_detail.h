// Level of detail: what the ground looks like where a pixel covers more than a post.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "terrain/mean_heights.h"

namespace terrview {

class GroundDetail {
 public:
  using MeansOfGrids = std::map<const HeightGrid*, std::shared_ptr<const MeanHeights>>;

  // Takes those means that are `known`, and makes the others.
  explicit GroundDetail(const Terrain& terrain, MeansOfGrids known = {});

  struct Ground {
    glm::dvec3 normal;
    double height_m;  // before z_scale
  };

  // What a pixel `width_m` wide sees of the ground at a hit of `ray`: `exact` where it covers no
  // more than a post, the mean over its footprint where it does. A footprint counts by its area on
  // the map.
  [[nodiscard]] Ground seen(const Terrain& terrain, const Ray& ray, const Hit& hit, double width_m,
                            const Ground& exact) const;

 private:
  struct Layer {
    std::shared_ptr<const MeanHeights> means;
    double post_m;
  };
  std::vector<Layer> layers_;
};

}  // namespace terrview
