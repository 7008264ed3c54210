// What is to be seen: the ground, what stands on it, its colours, the light and the sky. Immutable
// while rendering.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "render/color_ramp.h"
#include "render/contours.h"
#include "render/ground_detail.h"
#include "render/lamp.h"
#include "render/natural_ground.h"
#include "terrain/sky_view.h"
#include "terrain/terrain.h"

namespace terrview {

// I = ambient * ka + (N . L) * sun * kd, with ka = kd = the ground's colour (Coquillart 1984,
// chapter 1, 2.4).
struct Light {
  glm::dvec3 towards_sun{0, 0, 1};  // true east-north-up at the eye, unit length
  glm::vec3 sun{0.95F, 0.91F, 0.82F};
  glm::vec3 ambient{0.23F, 0.26F, 0.31F};
  bool casts_shadows = true;  // the lamps, too
  double sun_radius_rad = 0;  // of the disc that softens the edges of shadows; 0 = a point
};

// A plain sky: one colour at the horizon, another overhead, and one at the horizon about the sun.
struct SkyGradient {
  glm::vec3 horizon{0.56F, 0.68F, 0.82F};
  glm::vec3 zenith{0.08F, 0.20F, 0.52F};
  std::optional<glm::vec3> sunward = {};  // none: the horizon's all round
};

// The air between: colour <- colour q + air (1 - q), q = exp(-extinction * distance) (Coquillart
// 1984, chapter 1, 6); and the blur of what is far away, of standard deviation haze_px_per_m *
// distance.
struct Air {
  double extinction_per_m = 0;
  double haze_px_per_m = 0;
  std::optional<glm::vec3> color = {};  // none: the sky's at the horizon
  std::optional<glm::vec3> sunward =
      {};  // towards the sun; none: `color`, or the sky's without one
};

// At the visibility a black object keeps 2 percent of its contrast (Koschmieder's law).
inline constexpr double kExtinctionTimesVisibility = 3.912;

enum class NormalKind { smooth, facet };

class Drape;
class PaintedSky;
class SunMap;
struct SceneObjects;
struct Water;

struct Scene {
  std::shared_ptr<const Terrain> terrain;
  ColorRamp tints = altitude_tints();
  std::optional<NaturalGround> natural;  // instead of the tints
  std::shared_ptr<const Drape> drape;    // over the tints; none: the tints alone
  Contours contours;
  NormalKind normals = NormalKind::smooth;
  std::shared_ptr<const GroundDetail> detail;  // none: every pixel sees a point of the ground
  // How much of the sky each layer's posts see, which dims the ambient light; none: all of it.
  std::shared_ptr<const std::vector<SkyView>> sky_views;
  Light light;
  std::shared_ptr<const SunMap> sun_map = {};  // of the terrain and the sun; none: rays tell
  std::vector<Lamp> lamps = {};
  SkyGradient sky;
  std::shared_ptr<const SceneObjects> objects;    // none: the ground alone
  std::shared_ptr<const PaintedSky> painted_sky;  // none: the plain one above
  Air air;
  std::shared_ptr<const Water> water;  // none: the ground is dry
};

}  // namespace terrview
