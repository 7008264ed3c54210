// What stands on the ground: anything with bounds and a first hit.
//
// Objects live in the view frame, in metres (docs/frames.md). A surface is seen from both sides; a
// ray that leaves a surface is lifted off it by its caller.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "terrain/ray.h"

namespace terrview {

// Closed; flat in a direction where the object is.
struct Box {
  glm::dvec3 lowest_m;
  glm::dvec3 highest_m;
};

// Where a ray first meets a surface.
struct SurfaceHit {
  double distance_m;      // along the ray
  glm::dvec3 position_m;  // on the ray
  glm::dvec3 normal;      // unit length, outward
  int part;               // of the object: which of its surfaces; its own numbering
};

// Immutable, so threads may share one.
class Object {
 public:
  virtual ~Object() = default;

  // Contains every hit of first_hit(), to the last bit: its distance is one at which slab_ray.h has
  // the ray within the bounds.
  [[nodiscard]] virtual Box bounds() const = 0;

  // The nearest point of the surface at a distance in [0, ray.length_m].
  [[nodiscard]] virtual std::optional<SurfaceHit> first_hit(const Ray& ray) const = 0;

  // Whether first_hit() finds anything.
  [[nodiscard]] virtual bool stops(const Ray& ray) const { return first_hit(ray).has_value(); }

 protected:
  Object() = default;
  Object(const Object&) = default;
  Object& operator=(const Object&) = default;
};

}  // namespace terrview
