#include <cmath>
#include <numbers>

#include "bench/bench_view.h"

namespace terrview {
namespace {

constexpr glm::ivec2 kSize_px{640, 512};
constexpr glm::ivec2 kProbe_px{64, 51};
constexpr double kFov_rad = std::numbers::pi / 3;
constexpr double kShareOfGround = 0.5425;  // 169 079 of 310 554 rays, and 147 923 of 273 600
constexpr double kSteepest_rad = 0.6;

double azimuth_rad(glm::dvec2 towards) { return std::atan2(towards.x, towards.y); }

double share_of_ground(const Terrain& terrain, CameraOptions options) {
  options.size_px = kProbe_px;
  const Camera camera(options);
  int hits = 0;
  for (int row = 0; row < kProbe_px.y; ++row)
    for (int column = 0; column < kProbe_px.x; ++column)
      if (terrain.first_hit(camera.ray({column + 0.5, row + 0.5}))) ++hits;
  return static_cast<double>(hits) / (kProbe_px.x * kProbe_px.y);
}

// Tilts the camera up from `lowest_rad` until no more than kShareOfGround of the rays meet ground.
BenchView tilted_view(const BenchDem& dem, const char* name, const BenchEye& eye,
                      double lowest_rad) {
  CameraOptions options{.heading_rad = azimuth_rad(-dem.scene_xy_m(eye.uv)),
                        .fov_rad = kFov_rad,
                        .size_px = kSize_px};
  const Terrain terrain = terrain_of(dem, make_view(dem, name, eye, options),
                                     SurfaceModel::hyperboloid, Search::pyramid);
  double low_rad = lowest_rad;
  double high_rad = kSteepest_rad;
  for (int halving = 0; halving < 12; ++halving) {
    options.pitch_rad = (low_rad + high_rad) / 2;
    (share_of_ground(terrain, options) > kShareOfGround ? low_rad : high_rad) = options.pitch_rad;
  }
  return make_view(dem, name, eye, options);
}

}  // namespace

BenchView thesis_valley(const BenchDem& dem) {
  const glm::dvec2 uv(dem.grid->columns / 4 + 0.375, dem.grid->rows * 25 / 32 + 0.625);
  return tilted_view(dem, "valley", {uv, dem.height_m(uv) + dem.extent_m() / 64}, -kSteepest_rad);
}

BenchView thesis_top(const BenchDem& dem) {
  const glm::dvec2 uv(dem.grid->columns / 2, dem.grid->rows * 1.2);
  const BenchEye eye{uv, dem.extent_m() / 4};
  const glm::dvec2 away_m = dem.scene_xy_m(uv);
  return tilted_view(dem, "oblique", eye,
                     std::atan2(-eye.height_m, std::hypot(away_m.x, away_m.y)));
}

}  // namespace terrview
