// Which of two viewsheds is right where they differ: brute force, in long double.
#pragma once

#include <cstddef>

#include <glm/vec2.hpp>

#include "terrain/height_grid.h"

namespace terrview {

// A point seen over a flat Earth from observers above the posts of a grid.
struct FlatSight {
  const HeightGrid& grid;
  glm::dvec2 target_uv;
  double target_height_m;
  double observer_m;  // above the ground
};

enum class Ground {
  edges,     // linear on rows and columns: the hyperboloid's, where lines of sight cross them
  bilinear,  // and inside cells, looked at in 16 places of each
};

// The least height of the line of sight to a post above the ground, up to the last row or column
// that it crosses before; infinite where it crosses none.
[[nodiscard]] long double clearance_m(const FlatSight& sight, glm::ivec2 post, Ground ground);

// Of the posts where `other` (0, NaN = hidden) differs from `zone`, as many as 4000, evenly taken.
struct Judgement {
  std::size_t posts = 0;       // with a height
  std::size_t differ = 0;      // of these
  std::size_t judged = 0;      // of those
  std::size_t zone_edges = 0;  // of those judged, as the zone says on that ground
  std::size_t zone_bilinear = 0;
  std::size_t other_shows = 0;  // posts that `other` alone shows
  double median_m = 0;          // of the clearance's size on edges
};
[[nodiscard]] Judgement judge(const FlatSight& sight, const HeightGrid& zone,
                              const HeightGrid& other);

}  // namespace terrview
