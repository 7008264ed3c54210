// The light that comes to places straight from the sun and the lamps, past ground and objects.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/scene.h"
#include "render/shadows.h"

namespace terrview {

// A place on a surface, just off it.
struct LitPlace {
  glm::dvec3 position_m;  // view frame
  glm::dvec3 normal;      // unit length, as Terrain's are
};

// A point of a surface lifted off it to the side of `side`, by more than hits are wrong.
[[nodiscard]] glm::dvec3 off_surface(const glm::dvec3& position_m, const glm::dvec3& side);

struct Beam {
  std::size_t place;
  glm::dvec3 towards;  // its source, unit length, in the normal's frame
  glm::vec3 color;     // of the source
  float intensity;     // above 0
};

// The beams that fall on the places' faces: N . L > 0. They are found in the order of the places.
// Light::casts_shadows is for the lamps, too. Adds to `counts`.
[[nodiscard]] std::vector<Beam> sun_beams(const Scene& scene, std::span<const LitPlace> places,
                                          ShadowCounts& counts);

// The same of all lamps, one after the other.
[[nodiscard]] std::vector<Beam> lamp_beams(const Scene& scene, std::span<const LitPlace> places,
                                           ShadowCounts& counts);

// What a Lambert surface at each place has of the lamps: the sum of (N . L) I.
[[nodiscard]] std::vector<glm::vec3> lamplight(const Scene& scene, std::span<const LitPlace> places,
                                               ShadowCounts& counts);

// The intensity of a lamp's light at a point, with nothing between: 0 outside its cone.
[[nodiscard]] double intensity_at(const Lamp& lamp, const glm::dvec3& point_m);

}  // namespace terrview
