// Successive refinement: render/refine.h.
#include "render/refine.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/render/hills.h"

namespace terrview {
namespace {

// Hills with a needle that the corners of the first blocks miss.
Scene needle_scene() {
  HeightGrid grid = hills_grid();
  grid.heights_m[static_cast<std::size_t>(60 * grid.columns + 61)] = 1100;
  return scene_over(std::move(grid), 700);
}

std::vector<Image> pictures_of(const Scene& scene, const Camera& camera, RenderOptions options) {
  std::vector<Image> pictures;
  options.improved = [&](const Image& image) { pictures.push_back(image); };
  pictures.push_back(render(scene, camera, options).image);
  return pictures;
}

TEST(Refinement, EndsWithTheDirectPictureToTheByte) {
  Scene scene = needle_scene();
  for (const double haze_px_per_m : {0.0, 1.0 / 3000}) {
    scene.air.haze_px_per_m = haze_px_per_m;
    for (const Camera& camera : {level_camera({101, 77}), tilted_camera({101, 77})}) {
      for (const int samples : {0, 1, 3}) {
        const Frame direct = render(scene, camera, {.samples = samples});
        const std::vector<Image> pictures = pictures_of(scene, camera, {.samples = samples});
        ASSERT_GE(pictures.size(), 6U);
        EXPECT_EQ(pictures.back().pixels(), direct.image.pixels());
        EXPECT_EQ(pictures[pictures.size() - 2].pixels(), direct.image.pixels());
      }
    }
  }
}

TEST(Refinement, KeepsTheLayersOfTheDirectPicture) {
  const Scene scene = needle_scene();
  const Camera camera = tilted_camera({50, 40});
  const Frame direct = render(scene, camera, {.keep_samples = true});
  const Frame refined =
      render(scene, camera, {.keep_samples = true, .improved = [](const Image&) {}});
  for (std::size_t i = 0; i < direct.samples.pixels().size(); ++i) {
    EXPECT_EQ(direct.samples.pixels()[i].position_m, refined.samples.pixels()[i].position_m);
    EXPECT_EQ(direct.samples.pixels()[i].object_id, refined.samples.pixels()[i].object_id);
  }
}

TEST(Refinement, ImprovesWithEveryPicture) {
  const Scene scene = hills_scene();
  const Camera camera = tilted_camera({320, 240});
  const Image direct = render(scene, camera).image;
  const std::vector<Image> pictures = pictures_of(scene, camera, {});
  double last_db = 0;
  for (std::size_t i = 0; i + 2 < pictures.size(); ++i) {
    const double db = psnr_db(pictures[i], direct);
    EXPECT_GE(db, last_db) << i;
    last_db = db;
  }
  // Usable from 1 / 64 of the rays.
  EXPECT_GT(psnr_db(pictures.front(), direct), 20);
}

TEST(Refinement, FindsInTheEndWhatItsBlocksMissed) {
  // A plain, and a thin wall edge-on that lies between the corners of the blocks.
  HeightGrid grid = make_grid(120, 120, [](int column, int row) {
    return column == 61 && row >= 100 && row < 102 ? 400.0 : 100.0;
  });
  Scene scene = scene_over(std::move(grid), 300);
  scene.light.casts_shadows = false;
  const Camera camera({.size_px = {160, 120}});
  const Frame preview = render(scene, camera, {.preview = true});
  const std::vector<Image> pictures = pictures_of(scene, camera, {});
  EXPECT_EQ(pictures.back().pixels(), render(scene, camera).image.pixels());
  EXPECT_NE(pictures.front().pixels(), pictures.back().pixels());
  EXPECT_EQ(pictures.front().pixels().size(), preview.image.pixels().size());
}

TEST(Preview, TracesAFractionOfTheRaysAndRefinesAtOutlines) {
  const Scene scene = hills_scene();
  const Camera camera = tilted_camera({320, 240});
  const Frame direct = render(scene, camera);
  const Frame preview = render(scene, camera, {.preview = true});
  EXPECT_LT(preview.counts.rays, direct.counts.rays / 2);
  EXPECT_GT(preview.counts.rays, direct.counts.rays / 64);
  EXPECT_GT(psnr_db(preview.image, direct.image), 28);
}

TEST(Preview, OfEvenGroundIsAllButExactFromOneRayInSixtyFour) {
  Scene scene = scene_over(make_grid(60, 60, [](int, int) { return 100.0; }), 300);
  const Camera down({.projection = Projection::orthographic,
                     .pitch_rad = -90 * kRadians,
                     .width_m = 150,
                     .size_px = {64, 64}});
  const Frame preview = render(scene, down, {.preview = true});
  EXPECT_EQ(preview.counts.rays, 64);
}

TEST(Preview, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = hills_scene();
  const Camera camera = tilted_camera({90, 70});
  const Frame one = render(scene, camera, {.threads = 1, .preview = true});
  const Frame many = render(scene, camera, {.threads = 4, .preview = true});
  EXPECT_EQ(one.image.pixels(), many.image.pixels());
  EXPECT_EQ(one.counts.rays, many.counts.rays);
}

}  // namespace
}  // namespace terrview
