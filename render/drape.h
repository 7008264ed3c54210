// A picture laid over the ground, in place of its tints.
#pragma once

#include <memory>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/picture_pyramid.h"
#include "terrain/terrain.h"

namespace terrview {

// From a layer's grid coordinates to pixels of the picture. Immutable.
class PixelMap {
 public:
  virtual ~PixelMap() = default;

  // NaN where the picture's coordinates are not defined.
  [[nodiscard]] virtual glm::dvec2 to_pixels(glm::dvec2 uv) const = 0;

  // Column 0: along u.
  [[nodiscard]] virtual glm::dmat2 jacobian(glm::dvec2 uv) const = 0;
};

class Drape {
 public:
  // A map for each layer of the terrain.
  Drape(PicturePyramid picture, std::vector<std::shared_ptr<const PixelMap>> maps);

  // `color` with the picture over it, as a pixel `width_m` wide sees it at a hit of `ray`: the mean
  // over the pixel's footprint on ground of that normal.
  [[nodiscard]] glm::vec3 over(const glm::vec3& color, const Terrain& terrain, const Ray& ray,
                               const Hit& hit, double width_m, const glm::dvec3& normal) const;

 private:
  PicturePyramid picture_;
  std::vector<std::shared_ptr<const PixelMap>> maps_;
};

// What a square that is 1 wide across a ray covers of a surface of a normal: two sides. A surface
// at a grazing angle counts as 1 : 256.
struct FootprintSides {
  glm::dvec3 across;
  glm::dvec3 up;
};
[[nodiscard]] FootprintSides footprint_sides(const glm::dvec3& ray_direction,
                                             const glm::dvec3& normal);

// The same of the ground, seen from above.
[[nodiscard]] glm::dmat2 footprint(const glm::dvec3& ray_direction, const glm::dvec3& normal);
// And its area there.
[[nodiscard]] double footprint_area(const glm::dvec3& ray_direction, const glm::dvec3& normal);

}  // namespace terrview
