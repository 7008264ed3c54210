// Bodies, as what a straight line has within them: what constructive solid geometry combines.
//
// A solid is asked about whole lines, so that what lies behind the eye counts too. Each stands in a
// frame of its own, in metres; transformed.h places it, csg.h composes, solid_object.h puts the
// result among the objects of a scene (object.h).
//
// Roth, Ray Casting for Modeling Solids, Computer Graphics and Image Processing 18(2), 1982.
#pragma once

#include <memory>
#include <memory_resource>
#include <vector>

#include <glm/vec3.hpp>

#include "render/objects/object.h"

namespace terrview {

// The points origin_m + t * direction; how far the frames around it have rounded them: at t, by no
// more than origin_error_m + |t| * direction_error.
struct Line {
  glm::dvec3 origin_m;
  glm::dvec3 direction;  // of any length but 0
  double origin_error_m = 0;
  double direction_error = 0;
};

// Where a line passes through the surface.
struct Crossing {
  double t;           // infinite where the solid has no end
  double error;       // the surface is at a t no further off than this
  glm::dvec3 normal;  // unit length, outward; 0 at infinity
  int part;           // the primitive whose surface it is: by its place in the tree, from the left
  bool enters;
};

using Crossings = std::pmr::vector<Crossing>;

// Immutable, so threads may share one.
class Solid {
 public:
  virtual ~Solid() = default;
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;

  // May be infinite; lowest_m > highest_m where there is nothing.
  [[nodiscard]] virtual Box bounds() const = 0;

  // The primitives in it.
  [[nodiscard]] virtual int parts() const { return 1; }

  // Appends the crossings by growing t: entering and leaving by turns, an even number. What a line
  // merely touches may be missing.
  virtual void append_crossings(const Line& line, Crossings& crossings) const = 0;

 protected:
  Solid() = default;
};

using SolidPtr = std::shared_ptr<const Solid>;

}  // namespace terrview
