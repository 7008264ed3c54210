// The ground under a ray, found the slow way: every crossing of the ray's track with every line of
// the grid, in long double, sorted.
//
// It follows the definition in terrain/terrain.h and shares no code with terrain/: of a Terrain it
// reads the heights, the pieces of the track and the numbers of the vertical frame, and nothing
// else.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "terrain/ray.h"
#include "terrain/terrain.h"

namespace terrview::oracle {

using Real = long double;

// z of a ground point in the view frame, by the formula of terrain/vertical_frame.h.
[[nodiscard]] Real z_m(const VerticalFrame& frame, Real x_m, Real y_m, Real scene_height_m);

// dz/dh there.
[[nodiscard]] Real z_per_height(const VerticalFrame& frame, Real x_m, Real y_m,
                                Real scene_height_m);

// The surface model's scene height at a point of a cell: the bilinear interpolant, or the plane of
// the triangle.
[[nodiscard]] Real scene_height_m(const HeightGrid& grid, SurfaceModel model, glm::ivec2 cell,
                                  Real u, Real v, Real z_scale);

// The ground that a ray sees between two crossings, a chord or a parabola in the ray's vertical
// plane, as a function of the distance t along the ray.
struct Span {
  Real from_t, to_t;
  Real from_z_m, to_z_m;
  Real bulge_m;  // of the parabola over the chord, in the middle
  int layer;
  glm::ivec2 cell;

  [[nodiscard]] Real z_at(Real t) const;
};

// The ray and the ground under it. Where there is no ground there is no span; spans that meet have
// equal ends.
struct Profile {
  Real ray_z_m, ray_slope;  // z of the ray = ray_z_m + ray_slope * t
  Real run;                 // ground metres per metre along the ray
  std::vector<Span> spans;

  // How far the ray is above the ground of a span.
  [[nodiscard]] Real clearance_m(const Span& span, Real t) const;

  // Whether the ground goes on without a gap from the span before.
  [[nodiscard]] bool continues(std::size_t span) const;
};

// `shift_cells` moves the whole track sideways in every grid, to see what rounding might do.
struct Shift {
  Real u = 0;
  Real v = 0;
};

[[nodiscard]] Profile profile(const Terrain& terrain, const Ray& ray, Shift shift_cells = {});

}  // namespace terrview::oracle
