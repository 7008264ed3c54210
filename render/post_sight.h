// From which posts of a grid the eye can be seen: the viewshed of a point.
//
// An observer stands above every post, on the ground as on a floor. The eye is seen from there if
// neither the ground nor an object stops the straight line between the two, which is bent by
// refraction and over the curved Earth as all rays of the eye's view frame are: what a picture from
// the eye shows of an observer there. The line ends kStep_cells before the post, so that the ground
// on which the observer stands, known no better than that where tracks bend, does not hide him.
//
// Seen from the post, in a view frame of its own, the eye lies in the same direction to 2e-5 rad up
// to 100 km (tests/ingest/zone_pictures_test.cpp).
#pragma once

#include <cstdint>
#include <vector>

#include "render/objects/object_set.h"
#include "terrain/terrain.h"

namespace terrview {

struct PostSightOptions {
  double observer_m = 1.6;             // above the ground, not scaled
  const ObjectSet* objects = nullptr;  // further obstacles, in the eye's view frame
  int threads = 0;                     // 0 = all the processor has
};

// Where a line of sight ends before a post.
inline constexpr double kStep_cells = 0.05;

// By post of `grid`, row by row: 1 where the eye is seen, 0 where not or where there is no height.
// Layers of `terrain` that are not of `grid` are obstacles. An eye under the ground is not seen.
[[nodiscard]] std::vector<std::uint8_t> posts_that_see_eye(const Terrain& terrain,
                                                           const HeightGrid& grid,
                                                           const PostSightOptions& options = {});

// The same, a ray a post through the single ray's tracer: the reference.
[[nodiscard]] std::vector<std::uint8_t> posts_that_see_eye_plainly(
    const Terrain& terrain, const HeightGrid& grid, const PostSightOptions& options = {});

}  // namespace terrview
