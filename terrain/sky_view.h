// How much of the sky the posts of a grid see.
//
// The sky view of a post is the light that an evenly bright sky sends it past the ground about it,
// over that of a level plain: 1 on a plain, (1 + cos(slope)) / 2 on an endless slope, 1 / 2 in a
// hemispherical bowl. Along each of a number of azimuths evenly spread, the horizon is found by one
// sweep over all posts: the points of a line that a post may see form a convex hull, which the next
// post changes at its near end alone, so that a post costs a few steps whatever the size of the
// grid (J. Dozier, J. Bruno & P. Downey, Computers & Geosciences 7(2), 1981). A post lies between
// two parallel lines of the sweep; its horizon is mixed of those that it sees along either.
//
// The Earth's curvature is left out: it lowers a horizon 30 km away by 0.13 degrees. Beyond the
// grid there is sky down to the level horizon, and none below it.
#pragma once

#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "terrain/height_grid.h"

namespace terrview {

struct SkyView {
  int columns = 0;
  int rows = 0;
  std::vector<float> shares;  // row by row; 1 where the grid has no height

  // Between posts, bilinear.
  [[nodiscard]] float at(glm::dvec2 uv) const;
};

// What a post's normal turns into its sky view: sums over the azimuths, h the horizon.
struct SkySum {
  float level = 0;       // of cos^2 h
  glm::vec2 tilt{0, 0};  // of (pi / 2 - h - sin h cos h) times the azimuth's east and north
};

// Usage: for each step in order, every part (in any order, by any threads), then result().
class SkyViewSweep {
 public:
  // `jacobian` is d(u, v) / d(x, y), x east and y north, metres.
  SkyViewSweep(const HeightGrid& grid, const glm::dmat2& jacobian, double z_scale, int azimuths);

  [[nodiscard]] int steps() const { return static_cast<int>(azimuths_.size()); }
  [[nodiscard]] int parts(int step) const;
  void sweep(int step, int part);

  [[nodiscard]] SkyView result() const;

 private:
  // An azimuth in the axes of the grid that it sweeps: the transposed one, where it follows columns
  // more nearly than rows.
  struct Azimuth {
    glm::vec2 towards;  // east and north
    bool transposed;
    int forward;    // 1 or -1: the way of the azimuth along a row
    double drift;   // rows a column
    double step_m;  // a column, along the azimuth
  };

  class LineSweep;

  [[nodiscard]] const HeightGrid& grid_of(const Azimuth& azimuth) const {
    return azimuth.transposed ? transposed_ : grid_;
  }
  [[nodiscard]] int first_line(const Azimuth& azimuth) const;
  [[nodiscard]] int last_line(const Azimuth& azimuth) const;

  const HeightGrid& grid_;
  glm::dmat2 jacobian_;
  double z_scale_;
  HeightGrid transposed_;
  std::vector<Azimuth> azimuths_;
  std::vector<SkySum> sums_;             // as grid_
  std::vector<SkySum> transposed_sums_;  // as transposed_
};

}  // namespace terrview
