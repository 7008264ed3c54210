// The zone agrees with pictures: from a viewpoint in it a picture that is sharp enough shows the
// project, and from one outside it none does.
//
// The zone is found in the frame of each target and the picture in that of the viewpoint, whose
// tracks may differ by a fiftieth of a post: where the line to a target passes nearer to the ground
// than that matters, either may be right. Such viewpoints are those for which the zone of targets
// half a metre higher or lower is another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "ingest/buildings.h"
#include "ingest/zone.h"
#include "render/render.h"
#include "tests/ingest/zone_cases.h"
#include "tests/support/sanitized.h"

namespace terrview {
namespace {

constexpr int kPosts = 200;
constexpr double kSpacing_m = 60;
constexpr double kHouseSide_m = 24;
constexpr double kHouseHeight_m = 25;
constexpr double kObserver_m = 1.6;
const glm::dvec2 kNorthWest{420000, 5230000};
// Amid a cell, in the DEM's coordinates.
const glm::dvec2 kHouse = kNorthWest + kSpacing_m * glm::dvec2(90.5, -110.5);

// The house stands on level ground.
double hill_m(int column, int row) {
  if ((column == 90 || column == 91) && (row == 110 || row == 111)) return 60;
  return 90 * std::sin(column * 0.09) * std::cos(row * 0.07 + 1) +
         25 * std::sin(column * 0.37 + row * 0.29);
}

Dem hills() {
  return cases::laid("EPSG:32632", kNorthWest, kSpacing_m,
                     cases::grid_of({kPosts, kPosts}, hill_m));
}

std::vector<glm::dvec2> corners() {
  constexpr double kHalf_m = kHouseSide_m / 2;
  return {kHouse + glm::dvec2(-kHalf_m, -kHalf_m), kHouse + glm::dvec2(kHalf_m, -kHalf_m),
          kHouse + glm::dvec2(kHalf_m, kHalf_m), kHouse + glm::dvec2(-kHalf_m, kHalf_m)};
}

// The roof's corners and its centre, `raised_m` above it.
Zone zone_of_roof(const Dem& dem, double raised_m) {
  std::vector<glm::dvec2> places = corners();
  places.push_back(kHouse);
  std::vector<EyePlace> targets;
  for (const glm::dvec2 place : places)
    targets.push_back(cases::target_at(place, 60 + kHouseHeight_m + raised_m));
  return visible_zone({dem}, targets, {.observer_m = kObserver_m});
}

std::shared_ptr<const SceneObjects> house_in(const ViewFrame& frame) {
  Footprint footprint;
  footprint.number = 1;
  footprint.polygons = {{corners()}};
  footprint.height_m = kHouseHeight_m;
  FootprintFile file;
  file.file.name = "house";
  file.file.crs_wkt = "EPSG:32632";
  file.file.features = 1;
  file.footprints = {footprint};
  PlacedObjects objects;
  EXPECT_EQ(place_buildings(file, frame, {}, objects).placed, 1);
  return objects.scene_objects();
}

// Pixels of the house in a picture that it fills, from above a post.
int house_pixels(const Dem& dem, glm::dvec2 post) {
  const ViewFrame frame({dem},
                        {.geographic = {},
                         .projected = dem.placement.at(post),
                         .height_m = kObserver_m,
                         .above_ground = true},
                        {});
  const glm::dvec2 ground_m = frame.to_ground_from_projected(kHouse);
  const double away_m = glm::length(ground_m);
  const double middle_m = frame.terrain()->frame().at(ground_m).z_m(60 + kHouseHeight_m / 2);
  CameraOptions camera;
  camera.heading_rad = std::atan2(ground_m.x, ground_m.y);
  camera.pitch_rad = std::atan2(middle_m, away_m);
  camera.fov_rad = 2 * std::atan(0.8 * kHouseSide_m / away_m);
  camera.size_px = {96, 96};
  Scene scene;
  scene.terrain = frame.terrain();
  scene.objects = house_in(frame);
  scene.light.casts_shadows = false;
  RenderOptions options;
  options.keep_samples = true;
  const Frame picture = render(scene, Camera(camera), options);
  const auto& samples = picture.samples.pixels();
  return static_cast<int>(std::count_if(samples.begin(), samples.end(), [](const PixelSample& s) {
    return s.object_id > PixelSample::kGround;
  }));
}

TEST(ZonePictures, ShowTheProjectFromInsideTheZoneAndNotFromOutside) {
  const Dem dem = hills();
  const Zone zone = zone_of_roof(dem, 0);
  const Zone lower = zone_of_roof(dem, -0.5);
  const Zone higher = zone_of_roof(dem, 0.5);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> any(1, kPosts - 2);
  int inside = 0;
  int outside = 0;
  int grazing = 0;
  while (inside + outside + grazing < fewer_if_sanitized(200)) {
    const glm::ivec2 post(any(random), any(random));
    if (glm::distance(dem.placement.at(post), kHouse) < 150) continue;
    const std::size_t at = zone.index(post.x, post.y);
    const bool is_inside = zone.counts[at] > 0;
    const bool is_grazing = (lower.counts[at] > 0) != (higher.counts[at] > 0);
    if (is_grazing) {
      ++grazing;
      continue;
    }
    EXPECT_EQ(house_pixels(dem, post) > 0, is_inside) << post.x << ' ' << post.y;
    ++(is_inside ? inside : outside);
  }
  EXPECT_GE(inside, fewer_if_sanitized(40));
  EXPECT_GE(outside, fewer_if_sanitized(40));
  EXPECT_LE(grazing, 10);
}

// The middle of the line from a target to an observer, found in the frame of the one, lies on that
// of the other: from there it is seen where the target is.
TEST(ZonePictures, LinesOfSightAreTheSameFromBothEnds) {
  const Dem dem = cases::sea("EPSG:32632", {420000, 5280000}, 1000, {100, 100});
  const glm::dvec2 place = dem.placement.at({50.5, 40.3});
  const double height_m = 185;
  const ViewFrame from_target({dem}, cases::target_at(place, height_m), {});
  std::mt19937 random(6);
  std::uniform_int_distribution<int> any(1, 98);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 post = dem.placement.at(glm::dvec2(any(random), any(random)));
    const double observer_m = std::uniform_real_distribution<double>(0, 3000)(random);
    const ViewFrame from_post({dem}, cases::target_at(post, observer_m), {});
    const auto z_m = [](const ViewFrame& frame, glm::dvec2 ground_m, double scene_height_m) {
      return frame.terrain()->frame().at(ground_m).z_m(scene_height_m);
    };
    const glm::dvec2 post_m = from_target.to_ground_from_projected(post);
    const glm::dvec2 middle_m = post_m / 2.0;
    const double middle_height_m = from_target.terrain()->frame().at(middle_m).scene_height_m(
        z_m(from_target, post_m, observer_m) / 2);
    const glm::dvec2 seen_m = from_post.to_ground(from_target.from_ground(middle_m));
    const glm::dvec2 target_m = from_post.to_ground_from_projected(place);
    EXPECT_NEAR(z_m(from_post, seen_m, middle_height_m) / glm::length(seen_m),
                z_m(from_post, target_m, height_m) / glm::length(target_m), 2e-6);
    EXPECT_NEAR(std::atan2(seen_m.x, seen_m.y), std::atan2(target_m.x, target_m.y), 1e-9);
  }
}

}  // namespace
}  // namespace terrview
