// Rays from the eye, many at a time, in any directions.
//
// A view's EyeFront says at which cells a ray need look. Rays go over these in the lanes of a
// vector, in floats with a bound (scouts), and where they meet the ground, or floats cannot tell,
// in doubles with the arithmetic of the single ray: so the hits are the same to the bit under every
// instruction set. What the lanes cannot settle (vertical rays, rays that enter the grid from
// outside or come over the edge of a hole) goes to the single ray's tracer.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "terrain/eye_front.h"
#include "terrain/ray.h"

namespace terrview {

// Up to kMost rays: their directions in, their hits out.
struct EyeRays {
  static constexpr std::size_t kMost = 512;
  // Not a power of two, so that the same element of many arrays has a place in a cache.
  using Values = std::array<double, kMost + 8>;

  std::size_t count = 0;
  // Directions, view frame, of any length but 0.
  alignas(64) Values direction_x, direction_y, direction_z;

  // Where rays follow others over the same ground lines, each at least as steep as the one before
  // it (columns of a level picture, upwards): each is clear up to where the one before it ended.
  // trace() keeps this; infinite: nothing is left to hit.
  bool follows = false;
  alignas(64) Values clear_m;

  // The next rays follow those traced next; up to those, none has.
  void begin_to_follow() {
    follows = true;
    clear_m.fill(0);
  }

  // The ground lines' directions (unit length), and the rays' slopes dz / dg.
  alignas(64) Values x, y, slope;
  // Hits: the distance along the ground line, negative where nothing is hit (of a vertical ray,
  // whose slope is infinite, the distance down); the grid coordinates, and the cell.
  alignas(64) Values ground_m, u, v, column, row;

  void aim(std::size_t i, const glm::dvec3& direction) {
    direction_x[i] = direction.x;
    direction_y[i] = direction.y;
    direction_z[i] = direction.z;
  }
  [[nodiscard]] bool is_hit(std::size_t i) const { return ground_m[i] >= 0; }
  // Along the ray. Only where is_hit().
  [[nodiscard]] double distance_m(std::size_t i) const {
    return std::isinf(slope[i]) ? ground_m[i] : ground_m[i] * std::sqrt(1 + slope[i] * slope[i]);
  }
  // The Hit that Terrain::first_hit() gives. Only where is_hit().
  [[nodiscard]] Hit hit(std::size_t i) const;
};

// Finds the hits of `rays`. Any thread may call, with rays of its own. Adds to `counts`.
void trace(const EyeFront& front, EyeRays& rays, TraceCounts& counts);

// What is seen along rays side by side, as pictures keep it.
struct EyeFacets {
  std::span<double> distance_m;  // along the ray; infinite: a miss
  std::span<std::int32_t> cell;  // row * cells in a row + column; or -1
  // Of the facet's unit normal, which points up, as Terrain::facet_normal() gives it; or 0.
  std::span<float> normal_x, normal_y;
};
// Of as many rays, from `first` on.
void facets(const Terrain& terrain, const EyeRays& rays, std::size_t first,
            const EyeFacets& facets);

}  // namespace terrview
