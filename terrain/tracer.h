// One ray through the layers of a Terrain, cell by cell in double precision; where the Terrain has
// pyramids, blocks that lie wholly below the ray are skipped, which changes no result.
#pragma once

#include "terrain/ray.h"
#include "terrain/terrain.h"

namespace terrview {

enum class Outcome {
  free,   // the ray meets nothing
  hit,    // from above
  below,  // it begins below the ground, or comes below it over an edge of the ground
};

struct Trace {
  Outcome outcome = Outcome::free;
  Hit hit{};            // where outcome is hit
  double ground_m = 0;  // of the hit, along the ground line
  TraceCounts counts;
};

// Whether a ray moves sideways by less than rounding.
[[nodiscard]] bool is_vertical(const Ray& ray);

// The ground line of a ray that is not vertical, and its slope dz/dg. Rays whose directions have
// equal x and y share the line.
[[nodiscard]] GroundLine ground_line(const Ray& ray);
[[nodiscard]] double ray_slope(const Ray& ray);

// Metres along a ray of this slope, per metre of its ground line.
[[nodiscard]] double metres_per_g(double slope);

// Where `line` leaves the disc of `reach_m` about the eye; negative if it never enters it.
[[nodiscard]] double leaves_disc_m(const GroundLine& line, double reach_m);

// `ceiling_m`: no ground lies above this z. `clear_m`: so far along its ground line the ray is
// known to be above the ground; the spans before are not compared with it. Where that is wrong, a
// ray then below the ground ends there.
[[nodiscard]] Trace trace(const Terrain& terrain, double ceiling_m, const Ray& ray,
                          double clear_m = 0);

}  // namespace terrview
