// Still water: render/water.h, and what becomes of it in pictures.
#include "render/water.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "render/objects/level_plane.h"
#include "render/objects/prism.h"
#include "render/objects/scene_objects.h"
#include "terrain/view_transform.h"
#include "tests/render/hills.h"

namespace terrview {
namespace {

constexpr double kLevel_m = 200;
constexpr double kEye_m = 320;
constexpr glm::ivec2 kSize_px{120, 90};

// A deep basin that the eye is over, between hills.
HeightGrid basin_grid() {
  return make_grid(121, 121, [](int column, int row) {
    const double away = std::hypot(column - 60.0, row - 100.0);
    if (away < 45) return -5000.0;
    return 200 + 14 * (away - 44) + 60 * std::sin(column * 0.5) * std::cos(row * 0.4);
  });
}

// Towers on the slopes above the basin.
std::shared_ptr<const SceneObjects> towers(const Terrain& terrain) {
  auto all = std::make_shared<SceneObjects>();
  Objects objects;
  for (int i = -4; i <= 4; ++i) {
    const glm::dvec2 middle_m(500 * i, 4900);
    const Polygon::Ring ring{middle_m + glm::dvec2(-80, -80), middle_m + glm::dvec2(80, -80),
                             middle_m + glm::dvec2(80, 80), middle_m + glm::dvec2(-80, 80)};
    const double ground_m = terrain.ground_at(middle_m)->scene_height_m;
    objects.push_back(std::make_shared<Prism>(
        Polygon({&ring, 1}), PrismShape{.level = level_plane(terrain.frame(), middle_m, ground_m),
                                        .base_m = -30,
                                        .roof = {.eaves_m = 300}}));
    all->looks.push_back({i + 10, {0.7F, 0.2F, 0.6F}, {0.2F, 0.2F, 0.6F}});
  }
  all->set = std::make_shared<ObjectList>(std::move(objects));
  return all;
}

Scene basin(double eye_height_m) {
  const Place place{.eye_uv = {60.3, 100.2}, .spacing_m = {100, 100}, .eye_height_m = eye_height_m};
  Scene scene;
  scene.terrain =
      std::make_shared<Terrain>(make_terrain(basin_grid(), place, SurfaceModel::hyperboloid));
  scene.tints = {.stops = {{200, {0.1F, 0.4F, 0.1F}}, {700, {0.9F, 0.6F, 0.5F}}}};
  scene.light.towards_sun = sun_at(240, 20);
  scene.objects = towers(*scene.terrain);
  return scene;
}

// With black water, that it may be told from what it mirrors.
Scene flooded(Scene scene, double level_m) {
  Water water{.level_m = level_m, .color = {0, 0, 0}};
  Scene reflected = scene;
  reflected.water = std::make_shared<const Water>();
  water.reflected = std::make_shared<const Scene>(reflected);
  scene.water = std::make_shared<const Water>(water);
  return scene;
}

Camera pitched(double pitch_deg) {
  return Camera({.pitch_rad = pitch_deg * kRadians, .size_px = kSize_px});
}

// By the law of sines and tangents.
double mirrored_share(double cosine) {
  const double in = std::acos(cosine);
  const double out = std::asin(std::sin(in) / kWaterIndex);
  const double across = std::sin(in - out) / std::sin(in + out);
  const double along = std::tan(in - out) / std::tan(in + out);
  return (across * across + along * along) / 2;
}

TEST(Water, MirrorsTheSceneAsItIsSeenFromTheMirroredEye) {
  const Scene above = flooded(basin(kEye_m), kLevel_m);
  const Scene below = basin(2 * kLevel_m - kEye_m);
  for (const double pitch_deg : {0.0, -9.0, -18.0}) {
    const Frame seen = render(above, pitched(pitch_deg), {.keep_samples = true});
    const Image mirrored = render(below, pitched(-pitch_deg)).image;
    int water = 0;
    int ground = 0;
    int built = 0;
    int wrong = 0;
    for (int row = 0; row < kSize_px.y; ++row)
      for (int column = 0; column < kSize_px.x; ++column) {
        const PixelSample& sample = seen.samples.at(column, row);
        if (sample.object_id != PixelSample::kGround ||
            std::abs(sample.position_m.z - (kLevel_m - kEye_m)) > 1e-6)
          continue;
        ++water;
        const glm::dvec3 ray = pitched(pitch_deg).ray({column + 0.5, row + 0.5}).direction;
        const auto share = static_cast<float>(mirrored_share(-glm::normalize(ray).z));
        const glm::vec3 expected = share * mirrored.at(column, kSize_px.y - 1 - row);
        if (glm::distance(seen.image.at(column, row), expected) > 1e-4F) ++wrong;
        const Ray from_below{{0, 0, 0}, {ray.x, ray.y, -ray.z}};
        const auto tower = below.objects->set->first_hit(from_below);
        if (below.terrain->first_hit(from_below)) ++ground;
        if (tower) ++built;
      }
    EXPECT_GT(water, 2000);
    EXPECT_GT(ground, 300);
    EXPECT_GT(built, 50);
    // Where the edge of a shadow runs through a ray.
    EXPECT_LE(wrong, water / 500) << pitch_deg;
  }
}

TEST(Water, BeginsWhereTheGroundComesBelowItsLevel) {
  const Scene scene = flooded(basin(kEye_m), kLevel_m);
  const Frame frame = render(scene, pitched(-9), {.keep_samples = true});
  const Frame dry = render(basin(kEye_m), pitched(-9), {.keep_samples = true});
  int shore = 0;
  for (std::size_t i = 0; i < frame.samples.pixels().size(); ++i) {
    const PixelSample& sample = frame.samples.pixels()[i];
    const PixelSample& bed = dry.samples.pixels()[i];
    ASSERT_EQ(sample.object_id, bed.object_id);
    if (bed.object_id != PixelSample::kGround) continue;
    const double bed_m = bed.position_m.z + kEye_m;
    if (bed_m > kLevel_m) {
      EXPECT_EQ(sample.position_m, bed.position_m);
    } else {
      EXPECT_NEAR(sample.position_m.z + kEye_m, kLevel_m, 1e-9);
      EXPECT_EQ(sample.normal, glm::vec3(0, 0, 1));
    }
    shore += std::abs(bed_m - kLevel_m) < 60 ? 1 : 0;
  }
  EXPECT_GT(shore, 50);
}

TEST(Water, CoversGroundThatLiesAtItsVeryLevel) {
  const Scene scene = flooded(scene_over(make_grid(60, 60, [](int, int) { return 7.0; }), 300), 7);
  std::vector<Ray> rays;
  for (int i = 1; i < 200; ++i) rays.push_back({{0, 0, 0}, {0.2, 1, -0.06 - 0.004 * i}});
  RayHits hits;
  for (const Ray& ray : rays) hits.ground.push_back(scene.terrain->first_hit(ray));
  meet_water(scene, rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_TRUE(hits.ground[i]);
    EXPECT_TRUE(hits.meets_water(i));
  }
}

TEST(Water, IsNotSeenFromBesideTheGroundBelowItsLevel) {
  Scene scene = scene_over(make_grid(60, 60, [](int, int) { return 0.0; }), 20);
  scene.terrain = std::make_shared<Terrain>(make_terrain(
      make_grid(60, 60, [](int, int) { return 0.0; }),
      {.eye_uv = {30, 80}, .spacing_m = {100, 100}, .eye_height_m = 20}, SurfaceModel::bilinear));
  scene = flooded(scene, 10);
  // Falls by 10 m before the grid begins, and onto its bed beyond; or onto the water.
  const std::vector<Ray> rays{{{0, 0, 0}, {0, 2300, -20}}, {{0, 0, 0}, {0, 4600, -20}}};
  RayHits hits;
  for (const Ray& ray : rays) hits.ground.push_back(scene.terrain->first_hit(ray));
  ASSERT_TRUE(hits.ground[0]);
  meet_water(scene, rays, hits);
  EXPECT_FALSE(hits.ground[0]);
  ASSERT_TRUE(hits.meets_water(1));
  EXPECT_NEAR(hits.ground[1]->position_m.z, -10, 1e-9);
}

// On a curved Earth, for light that goes straight: by true directions alone.
TEST(WaterMirror, ReflectsAboutThePlumbLineOfThePlace) {
  const VerticalFrame frame{.eye_height_m = 500,
                            .north_curvature_per_m = 1 / 6371000.0,
                            .east_curvature_per_m = 1 / 6371000.0};
  const HeightGrid level = make_grid(400, 400, [](int, int) { return 0.0; });
  const TerrainLayer layer =
      make_layer(level, {.eye_uv = {200, 399}, .spacing_m = {500, 500}, .eye_height_m = 500});
  const Terrain terrain({layer}, frame, SurfaceModel::bilinear);
  for (const double dip : {0.0135, 0.02, 0.1, 0.7}) {
    for (const double aside : {0.0, -0.3, 0.4}) {
      const Ray ray{{0, 0, 0}, {aside, 1, -dip}};
      const auto hit = terrain.first_hit(ray);
      ASSERT_TRUE(hit);
      const MirroredRay mirror = mirrored(terrain, ray, *hit);
      const auto enu = [&](const glm::dvec3& view_m) { return to_true_enu(frame, view_m); };
      const glm::dvec3 place = enu(hit->position_m);
      const glm::dvec3 plumb = glm::normalize(place + glm::dvec3(0, 0, 6371500));
      const glm::dvec3 in = glm::normalize(place);
      const glm::dvec3 out = glm::normalize(
          enu(hit->position_m + 10.0 * glm::normalize(mirror.ray.direction)) - place);
      EXPECT_NEAR(glm::distance(out, in - 2 * glm::dot(in, plumb) * plumb), 0, 3e-5);
      EXPECT_NEAR(mirror.cosine, -glm::dot(in, plumb), 1e-4);
      EXPECT_GE(mirror.ray.origin_m.z, hit->position_m.z);
    }
  }
}

TEST(Water, ShowsItsBodyWhereItIsLookedInto) {
  Scene scene = basin(kEye_m);
  scene.light = {.towards_sun = {0, 0, 1}, .sun = {0, 0, 0}, .ambient = {1, 1, 1}};
  scene.sky = {.horizon = {0, 0, 0}, .zenith = {0, 0, 0}};
  scene = flooded(scene, kLevel_m);
  Water water = *scene.water;
  water.color = {0.1F, 0.2F, 0.3F};
  scene.water = std::make_shared<const Water>(water);
  const Image image =
      render(scene, Camera({.pitch_rad = -90 * kRadians, .fov_rad = 0.01, .size_px = {3, 3}}))
          .image;
  const auto through = static_cast<float>(1 - 0.02037);
  EXPECT_NEAR(glm::distance(image.at(1, 1), through * water.color), 0, 1e-4);
}

TEST(Water, IsTheSameForAnyNumberOfThreadsAndAnyOrderOfRays) {
  Scene scene = flooded(basin(kEye_m), kLevel_m);
  scene.light.sun_radius_rad = 0.004;
  const auto picture = [&](int threads, Coherence coherence) {
    return render(scene, Camera({.pitch_rad = -5 * kRadians, .size_px = {48, 36}}),
                  {.threads = threads, .coherence = coherence, .samples = 0})
        .image.pixels();
  };
  const auto one = picture(1, Coherence::on);
  EXPECT_EQ(one, picture(4, Coherence::on));
  EXPECT_EQ(one, picture(3, Coherence::off));
}

TEST(Water, InALakeEndsAtItsOutline) {
  Scene scene = scene_over(make_grid(60, 60, [](int, int) { return 50.0; }), 3000);
  const std::vector<Polygon::Ring> rings{{{20.3, 40.1}, {36.7, 38.2}, {33.1, 52.9}},
                                         {{28, 42}, {30, 42}, {30, 44}, {28, 44}}};
  const Polygon outline(rings);
  Water water{.color = {1, 0, 0}};
  water.lakes = {std::make_shared<Lakes>(std::vector{outline}, glm::ivec2(60, 60))};
  scene.water = std::make_shared<const Water>(water);
  scene.light = {.towards_sun = {0, 0, 1}, .sun = {0, 0, 0}, .ambient = {1, 1, 1}};
  const Frame frame =
      render(scene, Camera({.pitch_rad = -90 * kRadians, .fov_rad = 1, .size_px = {90, 90}}),
             {.keep_samples = true});
  int wet = 0;
  for (int row = 0; row < 90; ++row)
    for (int column = 0; column < 90; ++column) {
      const PixelSample& sample = frame.samples.at(column, row);
      if (sample.object_id != PixelSample::kGround) continue;
      const glm::dvec2 uv = scene.terrain->ground_at(glm::dvec2(sample.position_m))->uv;
      const bool is_wet = frame.image.at(column, row) == glm::vec3(1, 0, 0);
      EXPECT_EQ(is_wet, outline.contains(uv)) << column << ' ' << row;
      wet += is_wet ? 1 : 0;
    }
  EXPECT_GT(wet, 200);
}

}  // namespace
}  // namespace terrview
