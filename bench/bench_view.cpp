#include "bench/bench_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include <glm/matrix.hpp>

#include "terrain/ground_map.h"

namespace terrview {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFov_rad = 60 * kDegree;
constexpr double kSunElevation_rad = 20 * kDegree;
constexpr double kSunAzimuth_rad = 230 * kDegree;
constexpr double kOffCentre_rad = 7 * kDegree;  // keeps headings off the diagonals
// Off the posts and lines of the grid, and exact in a float.
constexpr glm::dvec2 kInsideCell{0.375, 0.625};

enum class Place { summit, floor, post, middle };

struct Recipe {
  const char* name;
  Place place;
  double above_ground_m;
  double extent_share;  // above_ground_m is no more than this share of the extent
  double pitch_rad;
};

constexpr std::array<Recipe, 6> kRecipes{{
    {"horizon", Place::summit, 100, 1.0 / 64, 0},
    {"gridline", Place::post, 100, 1.0 / 64, 0},
    {"valley", Place::floor, 300, 1.0 / 32, -10 * kDegree},
    {"oblique", Place::summit, 1500, 1.0 / 8, -35 * kDegree},
    {"down", Place::middle, 2000, 1.0 / 8, -90 * kDegree},
    {"up", Place::floor, 100, 1.0 / 64, 10 * kDegree},
}};

// The highest or lowest post of a window in the south-west, away from the borders.
glm::ivec2 extreme_post(const HeightGrid& grid, bool highest) {
  const glm::ivec2 first(grid.columns / 8, grid.rows * 5 / 8);
  const glm::ivec2 last(std::max(first.x, grid.columns * 3 / 8),
                        std::max(first.y, grid.rows * 7 / 8));
  glm::ivec2 best = first;
  for (int row = first.y; row <= last.y; ++row)
    for (int column = first.x; column <= last.x; ++column) {
      const float gain_m = grid.at(column, row) - grid.at(best.x, best.y);
      if (highest ? gain_m > 0 : gain_m < 0) best = {column, row};
    }
  return best;
}

glm::dvec2 eye_uv_of(const BenchDem& dem, Place place) {
  const HeightGrid& grid = *dem.grid;
  switch (place) {
    case Place::summit:
      return glm::dvec2(extreme_post(grid, true)) + kInsideCell;
    case Place::floor:
      return glm::dvec2(extreme_post(grid, false)) + kInsideCell;
    case Place::post:
      return {grid.columns / 2, grid.rows * 3 / 4};
    case Place::middle:
      break;
  }
  return dem.middle_uv() + kInsideCell;
}

glm::dvec3 sun_direction() {
  const double level = std::cos(kSunElevation_rad);
  return {std::sin(kSunAzimuth_rad) * level, std::cos(kSunAzimuth_rad) * level,
          std::sin(kSunElevation_rad)};
}

double azimuth_rad(glm::dvec2 towards) { return std::atan2(towards.x, towards.y); }

BenchView follow(const Recipe& recipe, const BenchDem& dem, glm::ivec2 size_px) {
  const glm::dvec2 uv = eye_uv_of(dem, recipe.place);
  const double above_m = std::min(recipe.above_ground_m, recipe.extent_share * dem.extent_m());
  CameraOptions camera{.pitch_rad = recipe.pitch_rad, .fov_rad = kFov_rad, .size_px = size_px};
  if (recipe.place == Place::post) {
    camera.heading_rad = azimuth_rad(-dem.step_m[1]);
  } else if (recipe.place != Place::middle) {
    camera.heading_rad = azimuth_rad(-dem.scene_xy_m(uv)) + kOffCentre_rad;
  }
  return make_view(dem, recipe.name, {uv, dem.height_m(uv) + above_m}, camera);
}

}  // namespace

std::vector<BenchView> six_views(const BenchDem& dem, glm::ivec2 size_px) {
  std::vector<BenchView> views;
  for (const Recipe& recipe : kRecipes) views.push_back(follow(recipe, dem, size_px));
  return views;
}

BenchView make_view(const BenchDem& dem, const std::string& name, const BenchEye& eye,
                    const CameraOptions& camera) {
  const double height_m = std::round(eye.height_m * 16) / 16;
  return {name, Camera(camera), eye.uv, {dem.scene_xy_m(eye.uv), height_m}, sun_direction()};
}

Terrain terrain_of(const BenchDem& dem, const BenchView& view, SurfaceModel model, Search search) {
  const auto map = std::make_shared<const AffineGroundMap>(
      view.eye_uv, glm::inverse(dem.step_m), glm::ivec2(dem.grid->columns, dem.grid->rows));
  return Terrain({{dem.grid, map}}, VerticalFrame{.eye_height_m = view.eye_m.z}, model, search);
}

}  // namespace terrview
