// Means of the heights over blocks of posts, for ground that is seen at less than a post a pixel.
//
// Level L holds the means of blocks of 2^L x 2^L posts. Slopes are those of the means: the mean of
// a slope is the slope of the mean. All levels together take a third of the grid's memory.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/for_each.h"
#include "terrain/terrain.h"

namespace terrview {

class MeanHeights {
 public:
  explicit MeanHeights(const HeightGrid& grid, const ForEach& for_each = one_by_one);

  struct Ground {
    double height_m;     // as the grid's
    glm::dvec2 slope_m;  // dh/du, dh/dv: metres a post
  };

  // The ground about a point of the grid at `level` >= 1, between levels and between the means of a
  // level interpolated; nullopt where a mean that counts has no height. Beyond the coarsest level,
  // that level.
  [[nodiscard]] std::optional<Ground> at(double level, glm::dvec2 uv) const;

  // 0 where the grid is too small for any.
  [[nodiscard]] int last_level() const { return static_cast<int>(levels_.size()); }

 private:
  [[nodiscard]] std::optional<Ground> at_level(int level, glm::dvec2 uv) const;

  std::vector<HeightGrid> levels_;  // from 1
};

// The unit normal, as Terrain's, of ground that rises by `slope_m` a post at a hit.
[[nodiscard]] glm::dvec3 normal_of_slope(const Terrain& terrain, const Hit& hit,
                                         glm::dvec2 slope_m);

// The distance between posts of a layer about the eye, as the square root of a cell's area.
[[nodiscard]] double post_distance_m(const TerrainLayer& layer);

}  // namespace terrview
