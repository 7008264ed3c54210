// What tells the surface models apart: whether the ground moves when the eye does, and how far each
// is from heights that it was not given.
#pragma once

#include <iosfwd>
#include <vector>

#include "bench/bench_dem.h"
#include "bench/bench_view.h"

namespace terrview {

// The height over `point_uv` of the surface in the vertical plane of a ray from `eye_uv`.
[[nodiscard]] double height_seen_m(const BenchDem& dem, SurfaceModel model, glm::dvec2 eye_uv,
                                   glm::dvec2 point_uv);

// Of many values: what half of them and 99 % do not exceed, and the largest.
struct Spread {
  double p50 = 0;
  double p99 = 0;
  double most = 0;
};

// What the ground under fixed points does while the eye goes sideways, a metre a frame, over one
// cell: the points that the view shows, one for each pixel of a coarse picture.
struct Motion {
  Spread height_m;   // from frame to frame
  Spread screen_px;  // the same as a picture 1920 wide shows it
  double sweep_px;   // over the whole path, largest
};
[[nodiscard]] Motion ground_motion(const BenchDem& dem, const BenchView& view, SurfaceModel model);

// Of the heights at the posts that a grid loses when every second post is dropped.
struct HeightErrors {
  double rms_m = 0;
  double p99_m = 0;
  double most_m = 0;
};
// In the middle of the cells that are left, where most models differ; or on their edges, where the
// band alone differs from the others.
enum class DroppedPosts { in_cells, on_edges };
// Over eight azimuths.
[[nodiscard]] HeightErrors errors_at_dropped_posts(const BenchDem& dem, SurfaceModel model,
                                                   DroppedPosts which);

// The view of someone who stands on a valley's floor, the eye 2 m above it.
[[nodiscard]] BenchView walkers_view(const BenchDem& dem, glm::ivec2 size_px);

// All of it, for that view and some of six_views(), with the time of a primary ray on one thread.
void print_surface_study(std::ostream& out, const BenchDem& dem, glm::ivec2 size_px);

}  // namespace terrview
