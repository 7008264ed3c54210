// What closes a prism from above.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace terrview {

// As OpenStreetMap's roof:shape.
enum class RoofShape { flat, gabled, hipped, pyramidal, skillion, dome };

struct RoofOptions {
  RoofShape shape = RoofShape::flat;
  double eaves_m = 0;  // where it begins
  double top_m = 0;    // its highest point
  // The way water runs off a skillion roof, or off one of the sides of a gabled or hipped one, as
  // x and y of any length; none: the ridge follows the longer side of the footprint.
  std::optional<glm::dvec2> downhill = {};
  bool ridge_across = false;  // without `downhill`: the ridge follows the shorter side
};

// The height is the least of the planes', or that of the dome where it is higher than `eaves_m`.
//
// Gabled, hipped and skillion roofs and domes (half an ellipsoid) lie on the smallest rectangle
// around the footprint, and pyramidal ones on its convex hull: over a footprint of another form
// they are cut off, and its walls rise to where they are.
struct Roof {
  struct Plane {
    double height_m;  // at the middle
    glm::dvec2 slope;
  };
  struct Dome {
    glm::dvec2 along;  // unit length
    double half_length_m;
    double half_width_m;
    double height_m;  // over the eaves
  };

  glm::dvec2 middle{0, 0};
  double eaves_m = 0;
  std::vector<Plane> planes;  // one at least
  std::optional<Dome> dome;

  // Nothing of it is higher.
  double top_m = 0;

  // Over a place within the footprint.
  [[nodiscard]] double height_m(glm::dvec2 ground_m) const;
};

[[nodiscard]] Roof make_roof(std::span<const glm::dvec2> footprint, const RoofOptions& options);

}  // namespace terrview
