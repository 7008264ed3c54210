#include "render/cells_in_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "render/shadows.h"
#include "tests/render/hills.h"

namespace terrview {
namespace {

// Of more cells than it takes for a part to be worth looking for.
Scene wide_scene() {
  return scene_over(make_grid(1200, 1100,
                              [](int column, int row) {
                                return 160 * std::sin(column * 0.35) * std::cos(row * 0.22) +
                                       40 * std::sin(column * 0.9 + row * 0.7) + 300;
                              }),
                    900);
}

Camera camera(double heading_deg, double pitch_deg, double fov_deg, glm::ivec2 size_px) {
  return Camera({.heading_rad = heading_deg * kRadians,
                 .pitch_rad = pitch_deg * kRadians,
                 .fov_rad = fov_deg * kRadians,
                 .size_px = size_px});
}

std::vector<Hit> ground_in(const Scene& scene, const Camera& camera) {
  std::vector<Hit> hits;
  for (int row = 0; row < camera.options().size_px.y; ++row)
    for (int column = 0; column < camera.options().size_px.x; ++column)
      if (const auto hit = scene.terrain->first_hit(camera.ray(glm::dvec2(column, row) + 0.5)))
        hits.push_back(*hit);
  return hits;
}

TEST(CellsInView, HoldNearlyAllOfTheGroundThatIsSeen) {
  const Scene scene = wide_scene();
  for (const Camera& seen : {camera(0, -3, 60, {210, 120}), camera(30, -20, 50, {100, 190}),
                             camera(200, -90, 70, {150, 90}), camera(290, -6, 20, {64, 1})}) {
    const CellRect cells = cells_in_view(*scene.terrain, seen, 2);
    const std::vector<Hit> hits = ground_in(scene, seen);
    ASSERT_FALSE(hits.empty());
    std::size_t held = 0;
    glm::ivec2 first = hits[0].cell;
    glm::ivec2 last = first;
    for (const Hit& hit : hits) {
      if (cells.holds(hit.cell)) ++held;
      first = glm::min(first, hit.cell);
      last = glm::max(last, hit.cell);
    }
    EXPECT_GT(held, 0.95 * static_cast<double>(hits.size()));
    const glm::ivec2 around = (last - first) / 8 + 2;
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(cells.first, glm::max(first - around, 0))));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(cells.last, glm::min(last + around, {1198, 1098}))));
  }
}

TEST(CellsInView, AreOneCellWhereNoGroundIsSeen) {
  const Scene scene = wide_scene();
  const CellRect cells = cells_in_view(*scene.terrain, camera(0, 60, 40, {30, 20}), 1);
  EXPECT_EQ(cells.size(), glm::ivec2(1));
}

// Of a large DEM the map is made of the part that a picture shows; shadows beyond it are the same.
TEST(CellsInView, AreThoseOfAPicturesMapOfTheSun) {
  Scene scene = wide_scene();
  scene.light.towards_sun = sun_at(250, 8);
  const Camera close = camera(20, -50, 40, {160, 100});
  const Camera far = camera(0, -3, 70, {600, 300});
  const Scene mapped = with_sun_map(scene, close, 2);
  ASSERT_TRUE(mapped.sun_map);
  EXPECT_LT(mapped.sun_map->bytes(), 1199 * 1099 * 4 / 8);
  EXPECT_FALSE(with_sun_map(scene, 600, 2).sun_map);
  for (const Camera& seen : {close, far}) {
    const std::vector<Hit> hits = ground_in(scene, seen);
    ShadowCounts counts;
    const auto with = sun_shares(shadow_casters(mapped), scene.light, hits, counts);
    EXPECT_EQ(with, sun_shares(shadow_casters(scene), scene.light, hits, counts));
    const auto lit = std::count(with.begin(), with.end(), 1.0F);
    EXPECT_GT(lit, 1000);
    EXPECT_LT(lit, static_cast<std::ptrdiff_t>(hits.size()) - 300);
  }
}

}  // namespace
}  // namespace terrview
