// The ground of a benchmark: one height grid, laid flat.
//
// Scene frame: x east, y north, metres, origin at the middle post; z is the height. Steps from post
// to post are rounded so that every post and every eye of a view is exact in single precision:
// contenders that trace in float then see the very surface that the double reference sees.
#pragma once

#include <memory>
#include <string>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "terrain/height_grid.h"

namespace terrview {

struct BenchDem {
  std::string name;
  std::shared_ptr<const HeightGrid> grid;  // every post has a height
  glm::dmat2 step_m{1, 0, 0, -1};          // column 0: one post along u; column 1: along v

  [[nodiscard]] glm::dvec2 middle_uv() const;
  [[nodiscard]] glm::dvec2 scene_xy_m(glm::dvec2 uv) const { return step_m * (uv - middle_uv()); }

  // The longer side of the grid.
  [[nodiscard]] double extent_m() const;

  // The height of the bilinear surface, `uv` over the grid.
  [[nodiscard]] double height_m(glm::dvec2 uv) const;
};

// Rounds the steps by less than a two-hundred-thousandth of the extent, and covers posts without
// data smoothly (cover_voids): Embree's grids cannot have holes of one cell.
[[nodiscard]] BenchDem make_bench_dem(std::string name, HeightGrid grid, const glm::dmat2& step_m);

// Gives every post without a height one between those around it: the mean of what lies around at
// the finest scale that has any. Smooth enough that no cliff stands where nothing is known.
void cover_voids(HeightGrid& grid);

// Mountains of octaves of gradient noise (Perlin, SIGGRAPH 2002), 30 m posts, relief 2000 m.
[[nodiscard]] BenchDem synthetic_mountains(int side_posts);

// A city: flat roofs of 6 to 90 m on a plain, 1 m posts.
[[nodiscard]] BenchDem synthetic_city(int side_posts);

// The project's sample massif cut to the grid of Coquillart 1984, chapter 2: 256 x 256 posts 60 m x
// 90 m apart.
[[nodiscard]] BenchDem thesis_mountains();

// A file; one of geographic coordinates as it lies on the ground around its middle. Throws
// InputError.
[[nodiscard]] BenchDem read_bench_dem(const std::string& path);

}  // namespace terrview
