#include "render/view_front.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "terrain/square_sectors.h"
#include "tests/render/hills.h"

namespace terrview {
namespace {

// Pitched, rolled, looking up, down and past the nadir; wide and narrow; all around.
std::vector<Camera> cameras() {
  std::vector<Camera> cameras;
  for (const double pitch : {-90.0, -89.0, -35.0, -10.0, 0.0, 10.0})
    for (const double roll : {0.0, 30.0, 180.0})
      cameras.emplace_back(CameraOptions{.heading_rad = 0.3 + pitch,
                                         .pitch_rad = pitch * kRadians,
                                         .roll_rad = roll * kRadians,
                                         .fov_rad = (pitch == -35 ? 5 : 100) * kRadians,
                                         .size_px = {45, 31}});
  cameras.emplace_back(CameraOptions{
      .projection = Projection::cylindrical, .fov_rad = 360 * kRadians, .size_px = {120, 40}});
  return cameras;
}

TEST(ViewFront, ShowsTheSamePictureAsSingleRays) {
  const Scene scene = hills_scene();
  for (const Camera& camera : cameras()) {
    ASSERT_TRUE(view_front(*scene.terrain, camera));
    const Frame frame = render(scene, camera, {.keep_samples = true, .samples = 1});
    const Frame single =
        render(scene, camera, {.coherence = Coherence::off, .keep_samples = true, .samples = 1});
    EXPECT_EQ(frame.image.pixels(), single.image.pixels()) << camera.options().pitch_rad;
    EXPECT_EQ(frame.counts.hits, single.counts.hits);
    EXPECT_LE(frame.counts.tests, 2 * single.counts.tests);
  }
}

TEST(ViewFront, KnowsTheWedgesThatPixelsLieIn) {
  const Scene scene = hills_scene();
  for (const Camera& small : cameras()) {
    CameraOptions options = small.options();
    options.size_px *= 12;
    const Camera camera(options);
    const auto front = view_front(*scene.terrain, camera);
    const std::vector<int> groups = groups_in_view(*front, camera);
    std::set<int> met;
    int missed = 0;
    for (int row = 0; row < options.size_px.y; ++row)
      for (int column = 0; column < options.size_px.x; ++column) {
        const glm::dvec2 across(camera.ray(glm::dvec2(column, row) + 0.5).direction);
        const int group = sector_of(across, front->wedges_a_side()) / EyeFront::kGroup;
        met.insert(group);
        missed += std::ranges::binary_search(groups, group) ? 0 : 1;
      }
    EXPECT_LT(missed, 0.02 * options.size_px.x * options.size_px.y) << options.pitch_rad;
    EXPECT_LE(groups.size(), met.size());
    for (const int group : groups) EXPECT_TRUE(met.contains(group)) << group;
  }
}

TEST(ViewFront, IsNotMadeForParallelRays) {
  const Scene scene = hills_scene();
  const Camera camera(
      {.projection = Projection::orthographic, .width_m = 1000, .size_px = {20, 20}});
  EXPECT_FALSE(view_front(*scene.terrain, camera));
}

}  // namespace
}  // namespace terrview
