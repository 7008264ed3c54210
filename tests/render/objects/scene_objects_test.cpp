// Objects mixed with the ground: render/meet.h, and what becomes of it in pictures.
#include "render/objects/scene_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>

#include "render/drape.h"
#include "render/meet.h"
#include "render/objects/level_plane.h"
#include "render/objects/prism.h"
#include "render/shade.h"
#include "tests/render/hills.h"
#include "tests/support/sanitized.h"

namespace terrview {
namespace {

constexpr glm::ivec2 kSize_px{160, 100};

std::shared_ptr<const Prism> block(const Terrain& terrain, glm::dvec2 middle_m, double side_m,
                                   double height_m) {
  const double ground_m = terrain.ground_at(middle_m)->scene_height_m;
  const glm::dvec2 x(side_m / 2, 0);
  const glm::dvec2 y(0, side_m / 2);
  const Polygon::Ring ring{middle_m - x - y, middle_m + x - y, middle_m + x + y, middle_m - x + y};
  return std::make_shared<Prism>(
      Polygon({&ring, 1}), PrismShape{.level = level_plane(terrain.frame(), middle_m, ground_m),
                                      .base_m = -150,
                                      .roof = {.eaves_m = height_m}});
}

void put(Scene& scene, Objects objects) {
  auto all = std::make_shared<SceneObjects>();
  for (std::size_t i = 0; i < objects.size(); ++i)
    all->looks.push_back(
        {static_cast<std::int32_t>(10 + i), {0.7F, 0.3F, 0.2F}, {0.2F, 0.2F, 0.6F}});
  all->set = std::make_shared<ObjectList>(std::move(objects));
  scene.objects = all;
}

// Blocks about the hills, some of them half behind crests.
Scene village() {
  Scene scene = hills_scene();
  Objects blocks;
  for (int i = 0; i < 60; ++i)
    blocks.push_back(block(*scene.terrain,
                           {std::fmod(i * 379.0, 3000) - 1500, 400 + std::fmod(i * 731.0, 5000)},
                           60 + 10 * (i % 7), 40 + 15 * (i % 5)));
  put(scene, std::move(blocks));
  return scene;
}

Frame picture(const Scene& scene, const Camera& camera, RenderOptions options = {}) {
  options.keep_samples = true;
  return render(scene, camera, options);
}

bool same_bytes(const Frame& a, const Frame& b) {
  if (a.image.pixels() != b.image.pixels()) return false;
  for (std::size_t i = 0; i < a.samples.pixels().size(); ++i) {
    const PixelSample& left = a.samples.pixels()[i];
    const PixelSample& right = b.samples.pixels()[i];
    if (left.object_id != right.object_id || left.position_m != right.position_m) return false;
  }
  return true;
}

TEST(SceneObjects, ShowTheNearerOfGroundAndObjects) {
  const Scene scene = village();
  for (const Camera& camera : {level_camera(kSize_px), tilted_camera(kSize_px)}) {
    const Frame frame = picture(scene, camera);
    int objects = 0;
    int hidden = 0;
    for (int row = 0; row < kSize_px.y; ++row) {
      for (int column = 0; column < kSize_px.x; ++column) {
        const Ray ray = camera.ray({column + 0.5, row + 0.5});
        const auto ground = scene.terrain->first_hit(ray);
        const auto object = scene.objects->set->first_hit(ray);
        const PixelSample& sample = frame.samples.at(column, row);
        const bool shows_object =
            object && (!ground || object->surface.distance_m <= ground->distance_m);
        const std::int32_t expected = shows_object ? 10 + object->object
                                      : ground     ? PixelSample::kGround
                                                   : PixelSample::kNothing;
        ASSERT_EQ(sample.object_id, expected);
        if (shows_object) {
          ++objects;
          EXPECT_EQ(sample.position_m, object->surface.position_m);
        }
        if (object && !shows_object) ++hidden;
      }
    }
    EXPECT_GT(objects, 300);
    EXPECT_GT(hidden, 300);
  }
}

TEST(SceneObjects, GiveTheSameBytesForAnyNumberOfThreadsAndAnyOrderOfRays) {
  Scene scene = village();
  scene.light.sun_radius_rad = kSunRadius_rad;
  scene.air.haze_px_per_m = 2e-3;
  const glm::ivec2 small_px = kSanitized ? glm::ivec2(36, 24) : glm::ivec2(60, 40);
  for (const Camera& camera : {level_camera(small_px), tilted_camera(small_px)}) {
    for (const int samples : {0, 4}) {
      const Frame one = picture(scene, camera, {.threads = 1, .samples = samples});
      EXPECT_TRUE(same_bytes(one, picture(scene, camera, {.threads = 5, .samples = samples})));
      EXPECT_TRUE(same_bytes(
          one,
          picture(scene, camera, {.threads = 2, .coherence = Coherence::off, .samples = samples})));
    }
    const Frame preview = picture(scene, camera, {.threads = 1, .preview = true});
    EXPECT_TRUE(same_bytes(preview, picture(scene, camera, {.threads = 3, .preview = true})));
  }
}

class PictureOfPosts final : public PixelMap {
 public:
  [[nodiscard]] glm::dvec2 to_pixels(glm::dvec2 uv) const override { return uv + 20.0; }
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 /*uv*/) const override { return glm::dmat2(1); }
};

TEST(SceneObjects, KeepTheirColorsWhereTheGroundIsDraped) {
  const auto picture_of = [](bool draped) {
    Scene scene = village();
    scene.light = {.towards_sun = {0, 0, 1}, .sun = {0, 0, 0}, .ambient = {1, 1, 1}};
    if (draped)
      scene.drape = std::make_shared<Drape>(
          PicturePyramid(Raster<glm::u8vec4>(160, 160, glm::u8vec4(0, 0, 255, 255))),
          std::vector<std::shared_ptr<const PixelMap>>{std::make_shared<PictureOfPosts>()});
    return picture(scene, tilted_camera(kSize_px));
  };
  const Frame plain = picture_of(false);
  const Frame draped = picture_of(true);
  int objects = 0;
  int ground = 0;
  for (std::size_t i = 0; i < plain.image.pixels().size(); ++i) {
    const std::int32_t id = draped.samples.pixels()[i].object_id;
    ASSERT_EQ(id, plain.samples.pixels()[i].object_id);
    const glm::vec3 color = draped.image.pixels()[i];
    if (id == PixelSample::kGround) {
      ++ground;
      EXPECT_NEAR(glm::distance(color, {0, 0, 1}), 0, 1e-5);
    } else {
      objects += id == PixelSample::kNothing ? 0 : 1;
      EXPECT_EQ(color, plain.image.pixels()[i]);
    }
  }
  EXPECT_GT(objects, 300);
  EXPECT_GT(ground, 3000);
}

// Level ground with a step up, a block before it, and the sun behind one of them.
Scene yard(double step_m) {
  Scene scene = scene_over(
      make_grid(60, 60, [=](int, int row) { return row < 30 ? 100 + step_m : 100.0; }), 400);
  scene.terrain = std::make_shared<Terrain>(scene.terrain->layers(), scene.terrain->frame(),
                                            SurfaceModel::bilinear);
  return scene;
}

// The light of the sun at a point seen from above.
bool is_lit(const Scene& scene, glm::dvec2 ground_m) {
  const Ray down{{ground_m, 900}, {0, 0, -1}};
  RayHits hits{{scene.terrain->first_hit(down)}};
  ObjectCounts objects;
  meet_objects(scene, {&down, 1}, hits, objects);
  ShadowCounts counts;
  const auto lit = shade(scene, {}, {&down, 1}, hits, counts).front();
  Scene dark = scene;
  dark.light.sun = glm::vec3(0);
  return lit.clear != shade(dark, {}, {&down, 1}, hits, counts).front().clear;
}

TEST(SceneObjects, ShadeTheGroundAndEachOther) {
  Scene scene = yard(0);
  scene.light.towards_sun = sun_at(90, 45);
  const glm::dvec2 middle_m(0, 1000);
  put(scene, {block(*scene.terrain, middle_m, 100, 80),
              block(*scene.terrain, middle_m - glm::dvec2(110, 0), 40, 30)});
  EXPECT_TRUE(is_lit(scene, middle_m)) << "the roof of the high block";
  EXPECT_FALSE(is_lit(scene, middle_m - glm::dvec2(60, 0))) << "its shadow on the ground";
  EXPECT_FALSE(is_lit(scene, middle_m - glm::dvec2(95, 0))) << "its shadow on the low roof";
  EXPECT_TRUE(is_lit(scene, middle_m - glm::dvec2(110, 0))) << "the rest of the low roof";
  EXPECT_TRUE(is_lit(scene, middle_m - glm::dvec2(175, 0))) << "beyond both shadows";
  EXPECT_TRUE(is_lit(scene, middle_m + glm::dvec2(60, 0))) << "towards the sun";
}

TEST(SceneObjects, AreShadedByTheGround) {
  Scene scene = yard(300);
  scene.light.towards_sun = sun_at(0, 30);
  const glm::dvec2 near_m(0, 2600);
  const glm::dvec2 far_m(0, 2000);
  put(scene, {block(*scene.terrain, near_m, 20, 60), block(*scene.terrain, far_m, 20, 250)});
  EXPECT_FALSE(is_lit(scene, near_m));
  EXPECT_TRUE(is_lit(scene, far_m)) << "as high as the shadow's edge and more";
}

TEST(SceneObjects, HalfHideASunThatTheirEdgeCuts) {
  Scene scene = yard(0);
  scene.light.towards_sun = sun_at(90, 45);
  scene.light.sun_radius_rad = kSunRadius_rad;
  const glm::dvec2 middle_m(0, 1000);
  put(scene, {block(*scene.terrain, middle_m, 400, 80)});
  const auto share = [&](double past_m) {
    const Hit point =
        *scene.terrain->first_hit({{middle_m - glm::dvec2(280 + past_m, 0), 900}, {0, 0, -1}});
    ShadowCounts counts;
    return sun_shares({*scene.terrain, scene.objects->set.get()}, scene.light, {&point, 1},
                      counts)[0];
  };
  EXPECT_NEAR(share(0), 0.5, 0.1);
  EXPECT_EQ(share(-2), 0);
  EXPECT_EQ(share(2), 1);
}

TEST(SceneObjects, DoNotShowThroughAnEdgeUnderTheGround) {
  Scene scene = yard(0);
  put(scene, {block(*scene.terrain, {0, 5750}, 100, 30)});
  // From outside, under the northern edge of the ground, towards the block's foundations.
  const Ray ray{{0, 6200, -330}, {0, -1, 0}};
  ASSERT_TRUE(scene.objects->set->first_hit(ray));
  RayHits hits{{scene.terrain->first_hit(ray)}};
  ObjectCounts counts;
  meet_objects(scene, {&ray, 1}, hits, counts);
  EXPECT_FALSE(hits.meets_object(0));
}

TEST(SceneObjects, CostNothingWhereThereAreNone) {
  const Frame frame = picture(hills_scene(), level_camera(kSize_px));
  EXPECT_EQ(frame.counts.objects.tests, 0);
  EXPECT_EQ(frame.counts.shadow_objects.tests, 0);
}

}  // namespace
}  // namespace terrview
