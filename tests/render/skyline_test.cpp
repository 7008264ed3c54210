// Where the sky ends: render/skyline.h.
#include "render/skyline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "render/objects/box.h"
#include "render/objects/make_object_set.h"
#include "render/objects/scene_objects.h"
#include "tests/render/hills.h"

namespace terrview {
namespace {

constexpr int kFewRows = 4;

// By rays through every pixel.
int first_row(const Scene& scene, const Camera& camera, int column) {
  const int rows = camera.options().size_px.y;
  for (int row = 0; row < rows; ++row)
    if (scene.terrain->first_hit(camera.ray({column + 0.5, row + 0.5}))) return row;
  return rows;
}

TEST(Skyline, IsThatOfEveryPixelButForAFewRows) {
  const Scene scene = scene_over(hills_grid(), 620);
  const Camera camera = tilted_camera({203, 101});
  const std::vector<int> rows = skyline_rows(scene, camera, 1);
  ASSERT_EQ(rows.size(), 203U);
  for (int column = 0; column < 203; ++column) {
    // What is beside a column is within a few columns.
    int highest = 101;
    int lowest = 0;
    for (int near = std::max(0, column - 4); near <= std::min(202, column + 4); ++near) {
      highest = std::min(highest, first_row(scene, camera, near));
      lowest = std::max(lowest, first_row(scene, camera, near));
    }
    const int found = rows[static_cast<std::size_t>(column)];
    EXPECT_GT(found, highest - kFewRows) << column;
    EXPECT_LE(found, lowest) << column;
  }
  EXPECT_EQ(rows, skyline_rows(scene, camera, 3));
}

TEST(Skyline, IsThePicturesHeightWhereAllIsSky) {
  for (int height_px = 97; height_px <= 100; ++height_px) {
    const Camera up({.pitch_rad = 60 * kRadians, .fov_rad = 0.05, .size_px = {9, height_px}});
    EXPECT_EQ(skyline_rows(hills_scene(), up, 1), std::vector<int>(9, height_px));
  }
}

TEST(Skyline, RisesOverAnObject) {
  Scene scene = scene_over(make_grid(60, 60, [](int, int) { return 0.0; }), 100);
  const Camera camera = level_camera({120, 80});
  const Box tower{{-50, 1000, -100}, {50, 1050, 300}};
  const auto without = skyline_rows(scene, camera, 1);
  auto objects = std::make_shared<SceneObjects>();
  objects->set = make_object_set({std::make_shared<BoxObject>(tower)});
  objects->looks = {{}};
  scene.objects = objects;
  const auto with = skyline_rows(scene, camera, 1);
  const double top_px = camera.project({0, 1000, 300})->y;
  int columns = 0;
  for (std::size_t column = 0; column < 120; ++column) {
    const double column_px = static_cast<double>(column) + 0.5;
    if (!objects->set->stops(camera.ray({column_px, top_px + 2}))) continue;
    EXPECT_NEAR(with[column], top_px, kFewRows);
    EXPECT_GT(without[column], top_px + 2 * kFewRows);
    ++columns;
  }
  EXPECT_GT(columns, 8);
  EXPECT_EQ(with[10], without[10]);
}

}  // namespace
}  // namespace terrview
