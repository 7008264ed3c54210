// Still water: a flat mirror over a body of one colour.
//
// It has no waves: the sun's image is a disc and not a glitter. Its surface is level: on a curved
// Earth it follows the Earth's drop, and its normal is the plumb line of the place.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/color_ramp.h"
#include "render/lakes.h"
#include "render/meet.h"
#include "render/scene.h"

namespace terrview {

inline constexpr double kWaterIndex = 1.333;  // of visible light, at 20 degrees C

struct Water {
  // All ground at this scene height (z_scale included) or below lies under water.
  std::optional<double> level_m = {};
  // Of each layer of the terrain, whose posts in and about lakes are at their levels already; a
  // null has none. Empty: no lakes.
  std::vector<std::shared_ptr<const Lakes>> lakes = {};
  glm::vec3 color = from_srgb8(34, 70, 78);  // of the body under a white sky, linear
  // What the surface mirrors: this scene under the sky of the mirrored camera, with water that
  // mirrors nothing. None: no reflection, the body's colour alone.
  std::shared_ptr<const Scene> reflected = {};
};

// Puts the water before the ground under it: where a ray meets water its hit is moved onto the
// surface. A ray that comes below the surface from beside the ground meets nothing.
void meet_water(const Scene& scene, std::span<const Ray> rays, RayHits& hits);

// Where a ray that begins above a level surface first comes down to it, metres along it and at most
// `end_m`; nullopt if it does not, or dips under it by less than 1e-6 m.
[[nodiscard]] std::optional<double> descent_m(const VerticalFrame& frame, const Ray& ray,
                                              double scene_height_m, double end_m);

// The ray that a level mirror makes of `ray` at a hit, and the cosine of their angles to the
// plumb line.
struct MirroredRay {
  Ray ray;
  double cosine;
};
[[nodiscard]] MirroredRay mirrored(const Terrain& terrain, const Ray& ray, const Hit& hit);

}  // namespace terrview
