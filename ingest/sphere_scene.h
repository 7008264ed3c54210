// Scenes of spheres in the XML of F. Guitteny, E. Le Goff & M. Lahuec, "Lancer de rayon".
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace terrview {

// In its frame: x to the right of the picture, y down, z towards the eye. Colours from 0 to 255.
struct SphereScene {
  enum class Surface { perfect, meridians, equator };

  struct Sphere {
    glm::dvec3 centre;
    glm::dvec3 color;
    double radius;
    // Shares of light; what they leave of 1 is the ambient light's.
    double mirror;
    double diffuse;
    double specular;
    double exponent;
    Surface surface;
    int facets;  // meridians, or rings of the equator's disc
  };

  struct Lamp {
    glm::dvec3 position;
    glm::dvec3 color;
    double intensity;
  };

  std::vector<Sphere> spheres;
  std::vector<Lamp> lamps;
  double eye_z = 0;           // on the z axis
  glm::dvec3 window{0};       // its upper left corner, before the eye
  glm::ivec2 window_size{0};  // also in pixels
};

inline constexpr int kMostSpheres = 10'000;
inline constexpr int kMostSphereLamps = 100;
inline constexpr int kMostFacets = 1000;

// Throws InputError, `name:line: path: what: how to mend it`, for what is no such scene, names what
// the format has not, says something twice, or has a DOCTYPE (whose entities nothing expands).
[[nodiscard]] SphereScene parse_sphere_scene(const std::string& text, const std::string& name);

}  // namespace terrview
