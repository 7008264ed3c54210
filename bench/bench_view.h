// The views of the benchmark, and the double-precision ground that they see.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "bench/bench_dem.h"
#include "render/camera.h"
#include "terrain/terrain.h"

namespace terrview {

struct BenchView {
  std::string name;
  Camera camera;
  glm::dvec2 eye_uv;
  glm::dvec3 eye_m;   // in the scene frame, exact in single precision
  glm::dvec3 to_sun;  // true direction at the eye, unit length
};

// horizon and oblique from a summit, valley and up from a valley floor, gridline from a post along
// its column, down over the middle; perspective, 60 degrees wide, the sun 20 degrees high. Heights
// above the ground are those named here or a share of the extent where the DEM is small:
// horizon and gridline 100 m, valley 300 m, oblique 1500 m, down 2000 m, up 100 m.
[[nodiscard]] std::vector<BenchView> six_views(const BenchDem& dem, glm::ivec2 size_px);

// After photos 2 and 3 of Coquillart 1984: along a valley, and the whole massif from above (view
// "oblique"). Where the author stood is not known; here the camera is tilted until as many rays
// meet the ground as met it there: 54 %.
[[nodiscard]] BenchView thesis_valley(const BenchDem& dem);
[[nodiscard]] BenchView thesis_top(const BenchDem& dem);

// Where the eye of a view is.
struct BenchEye {
  glm::dvec2 uv;
  double height_m;
};

// A view from `eye`, whose height is rounded so that a float holds it.
[[nodiscard]] BenchView make_view(const BenchDem& dem, const std::string& name, const BenchEye& eye,
                                  const CameraOptions& camera);

// `dem` in the view frame of `view`, on a flat Earth.
[[nodiscard]] Terrain terrain_of(const BenchDem& dem, const BenchView& view, SurfaceModel model,
                                 Search search);

}  // namespace terrview
