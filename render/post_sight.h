// From which posts of a grid the eye can be seen: the viewshed of a point.
//
// An observer stands above every post. The eye is seen from there if neither the ground nor an
// object stops the line of sight between the two (terrain/post_sight_lines.h), which is a ray of
// the eye's view frame, with its surface, curved Earth and refraction: what a picture from the eye
// shows of an observer there.
#pragma once

#include <cstdint>
#include <vector>

#include "render/objects/object_set.h"
#include "terrain/terrain.h"

namespace terrview {

struct PostSightOptions {
  double observer_m = 1.6;             // above the ground, not scaled; from 0
  const ObjectSet* objects = nullptr;  // further obstacles, in the eye's view frame
  int threads = 0;                     // 0 = all the processor has
  bool plain = false;                  // a ray a post through Terrain::occluded(): the reference
};

// By post of `grid`, row by row: 1 where the eye is seen, 0 where not or where there is no height.
// Layers of `terrain` that are not of `grid` are obstacles. An eye under the ground is not seen.
[[nodiscard]] std::vector<std::uint8_t> posts_that_see_eye(const Terrain& terrain,
                                                           const HeightGrid& grid,
                                                           const PostSightOptions& options = {});

}  // namespace terrview
