// Views as lines, against rays: render/lines/wireline.h.
#include "render/lines/wireline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <glm/geometric.hpp>

#include "render/objects/box.h"
#include "render/objects/make_object_set.h"
#include "render/objects/scene_objects.h"
#include "render/water.h"
#include "tests/render/hills.h"

namespace terrview {
namespace {

constexpr glm::ivec2 kSize_px{160, 90};

struct NamedCamera {
  const char* name;
  CameraOptions options;
};

class WirelineViews : public testing::TestWithParam<NamedCamera> {
 protected:
  Scene scene_ = scene_over(hills_grid(), 620);
  Camera camera_{GetParam().options};
  Wireline wireline_ = trace_wireline(scene_, camera_);

  // Infinite where nothing is hit.
  [[nodiscard]] double distance_m(glm::dvec2 at_px) const {
    const auto hit = scene_.terrain->first_hit(camera_.ray(at_px));
    return hit ? hit->distance_m : std::numeric_limits<double>::infinity();
  }

  // The highest outline of the ground that crosses the column, below `row`.
  [[nodiscard]] double first_outline_px(double column, double row) const {
    double first = std::numeric_limits<double>::infinity();
    for (const ViewLine& line : wireline_.lines) {
      if (line.kind != LineKind::silhouette) continue;
      for (std::size_t i = 1; i < line.points_px.size(); ++i) {
        const glm::dvec2 a = line.points_px[i - 1];
        const glm::dvec2 b = line.points_px[i];
        if ((a.x <= column) == (b.x <= column)) continue;
        const double y = a.y + (column - a.x) / (b.x - a.x) * (b.y - a.y);
        if (y >= row) first = std::min(first, y);
      }
    }
    return first;
  }
};

// The skyline of each column, found by rays a hundredth of a pixel apart. Ground that is thinner
// than a pixel, with sky below it, may be missed.
TEST_P(WirelineViews, HaveTheSkylineOfTheRays) {
  int compared = 0;
  int near = 0;
  for (int column = 0; column < kSize_px.x; ++column) {
    const double x = column + 0.5;
    double y = 0;
    while (y < kSize_px.y && std::isinf(distance_m({x, y}))) y += 0.25;
    if (y == 0 || y >= kSize_px.y) continue;
    y -= 0.25;
    while (std::isinf(distance_m({x, y}))) y += 0.01;
    const double found = first_outline_px(x, 0);
    EXPECT_NEAR(found, y, 1) << column;
    ++compared;
    near += std::abs(found - y) < 0.25 ? 1 : 0;
  }
  EXPECT_GT(compared, 100);
  EXPECT_GE(near, 0.96 * compared);
}

// The other way about: nothing is drawn as an outline that is none; but where two outlines are less
// than a pixel apart, one is drawn.
TEST_P(WirelineViews, HaveOutlinesWhereDistancesJump) {
  int points = 0;
  int jumps = 0;
  for (const ViewLine& line : wireline_.lines) {
    if (line.kind != LineKind::silhouette) continue;
    for (std::size_t i = 1; i < line.points_px.size(); ++i) {
      const glm::dvec2 middle = 0.5 * (line.points_px[i] + line.points_px[i - 1]);
      const glm::dvec2 along = line.points_px[i] - line.points_px[i - 1];
      if (glm::length(along) == 0) continue;
      const glm::dvec2 aside = 0.35 * glm::normalize(glm::dvec2(-along.y, along.x));
      const double a_m = distance_m(middle + aside);
      const double b_m = distance_m(middle - aside);
      ++points;
      if (std::max(a_m, b_m) - std::min(a_m, b_m) > 60) ++jumps;
    }
  }
  EXPECT_GT(points, 100);
  EXPECT_GT(jumps, 0.9 * points);
}

// Inner outlines: between two pixels of a column with a wide gap between them.
TEST_P(WirelineViews, HaveAnOutlineWithinAPixelOfEveryWideGap) {
  int gaps = 0;
  int found = 0;
  for (int column = 1; column + 1 < kSize_px.x; ++column) {
    for (int row = 0; row + 1 < kSize_px.y; ++row) {
      const glm::dvec2 upper(column + 0.5, row + 0.5);
      const double near_m = distance_m(upper + glm::dvec2(0, 1));
      const double far_m = distance_m(upper);
      if (std::isinf(near_m) || !(far_m > 1.3 * near_m) || far_m - near_m < 600) continue;
      ++gaps;
      const double y = first_outline_px(upper.x, upper.y - 0.2);
      if (y <= upper.y + 1.2) ++found;
    }
  }
  EXPECT_GT(gaps, 10);
  EXPECT_GE(found, 0.97 * gaps);
}

// On the ground that is seen, u or v is a whole number of posts.
TEST_P(WirelineViews, HaveLinesOfTheGridOnTheGridTheyShow) {
  int points = 0;
  int right = 0;
  for (const ViewLine& line : wireline_.lines) {
    if (line.kind != LineKind::grid) continue;
    for (const glm::dvec2& point : line.points_px) {
      const auto hit = scene_.terrain->first_hit(camera_.ray(point));
      const auto aside = scene_.terrain->first_hit(camera_.ray(point + glm::dvec2(0.3, 0.3)));
      const auto other = scene_.terrain->first_hit(camera_.ray(point + glm::dvec2(-0.3, 0.3)));
      if (!hit || !aside || !other) continue;
      ++points;
      // How far u and v go in half a pixel.
      const glm::dvec2 room =
          1e-3 + glm::max(glm::abs(aside->uv - hit->uv), glm::abs(other->uv - hit->uv));
      const glm::dvec2 off = glm::abs(hit->uv - glm::round(hit->uv));
      if (off.x <= room.x || off.y <= room.y) ++right;
    }
  }
  EXPECT_GT(points, 200);
  EXPECT_GT(right, 0.96 * points);
}

TEST_P(WirelineViews, AreTheSameForAnyNumberOfThreads) {
  const Wireline alone = trace_wireline(scene_, camera_, {.threads = 1});
  const Wireline several = trace_wireline(scene_, camera_, {.threads = 3});
  ASSERT_EQ(alone.lines.size(), several.lines.size());
  EXPECT_EQ(alone.limits_m, several.limits_m);
  for (std::size_t i = 0; i < alone.lines.size(); ++i)
    EXPECT_EQ(alone.lines[i].points_px, several.lines[i].points_px);
}

INSTANTIATE_TEST_SUITE_P(Cameras, WirelineViews,
                         testing::Values(NamedCamera{"Level", {.size_px = kSize_px}},
                                         NamedCamera{"Tilted",
                                                     {.pitch_rad = -3 * kRadians,
                                                      .roll_rad = 5 * kRadians,
                                                      .size_px = kSize_px}},
                                         NamedCamera{"Turn",
                                                     {.projection = Projection::cylindrical,
                                                      .heading_rad = 1,
                                                      .fov_rad = 2 * std::numbers::pi,
                                                      .size_px = {4 * kSize_px.x, kSize_px.y}}},
                                         NamedCamera{"Parallel",
                                                     {.projection = Projection::orthographic,
                                                      .pitch_rad = -8 * kRadians,
                                                      .width_m = 8000,
                                                      .size_px = kSize_px}}),
                         [](const auto& test) { return std::string(test.param.name); });

Scene with_box(Scene scene, const Box& box) {
  auto objects = std::make_shared<SceneObjects>();
  objects->set = make_object_set({std::make_shared<BoxObject>(box)});
  objects->looks = {{}};
  scene.objects = objects;
  return scene;
}

double total_length_px(const Wireline& wireline, LineKind kind) {
  double sum = 0;
  for (const ViewLine& line : wireline.lines)
    if (line.kind == kind) sum += length_px(line.points_px);
  return sum;
}

// Of a box seen over a corner from above nine edges show.
TEST(WirelineObjects, HaveTheEdgesOfABoxThatAreSeen) {
  const Box box{{-40, 300, -100}, {10, 350, -30}};
  const Scene scene =
      with_box(scene_over(make_grid(121, 121, [](int, int) { return 0.0; }), 100), box);
  const Camera camera({.pitch_rad = -10 * kRadians, .size_px = {400, 300}});
  const auto corner = [&](int i) {
    return *camera.project({i & 1 ? box.highest_m.x : box.lowest_m.x,
                            i & 2 ? box.highest_m.y : box.lowest_m.y,
                            i & 4 ? box.highest_m.z : box.lowest_m.z});
  };
  double expected = 0;
  // The eye is over x in [-40, 10]: the south face and the top, seven edges.
  for (const auto& [a, b] : {std::pair(0, 1), {0, 4}, {1, 5}, {4, 5}, {4, 6}, {5, 7}, {6, 7}})
    expected += glm::distance(corner(a), corner(b));
  const double found = total_length_px(trace_wireline(scene, camera), LineKind::object);
  EXPECT_NEAR(found, expected, 0.03 * expected);
}

TEST(WirelineObjects, HideWhatIsBehindThem) {
  const Scene ground = scene_over(hills_grid(), 620);
  const Camera camera({.size_px = kSize_px});
  const Scene screened = with_box(ground, {{-1000, 50, -1000}, {1000, 60, 1000}});
  EXPECT_GT(total_length_px(trace_wireline(ground, camera), LineKind::grid), 500);
  EXPECT_EQ(total_length_px(trace_wireline(screened, camera), LineKind::grid), 0);
}

// The grid under water is not drawn, and the shore is.
TEST(WirelineOfWater, EndsAtItsShore) {
  constexpr double kEye_m = 620;
  constexpr double kLevel_m = 300;
  Scene scene = scene_over(hills_grid(), kEye_m);
  const Camera camera({.pitch_rad = -8 * kRadians, .size_px = kSize_px});
  const auto height_m = [&](glm::dvec2 at_px) {
    const auto hit = scene.terrain->first_hit(camera.ray(at_px));
    return hit ? hit->position_m.z + kEye_m : std::numeric_limits<double>::infinity();
  };
  const auto drowned = [&](const Wireline& wireline) {
    int count = 0;
    for (const ViewLine& line : wireline.lines)
      for (const glm::dvec2& at_px : line.points_px)
        if (line.kind == LineKind::grid && height_m(at_px) < kLevel_m - 5) ++count;
    return count;
  };
  const int dry = drowned(trace_wireline(scene, camera));
  EXPECT_GT(dry, 50);
  scene.water = std::make_shared<const Water>(Water{.level_m = kLevel_m});
  const Wireline wireline = trace_wireline(scene, camera);
  EXPECT_LT(drowned(wireline), dry / 20);
  int shore = 0;
  for (const ViewLine& line : wireline.lines)
    for (const glm::dvec2& at_px : line.points_px)
      if (line.kind == LineKind::silhouette && std::abs(height_m(at_px) - kLevel_m) < 1) ++shore;
  EXPECT_GT(shore, 20);
}

TEST(WirelineOfTheSky, IsEmpty) {
  const Camera camera({.pitch_rad = 80 * kRadians, .size_px = {20, 20}});
  EXPECT_TRUE(trace_wireline(hills_scene(), camera).lines.empty());
}

}  // namespace
}  // namespace terrview
