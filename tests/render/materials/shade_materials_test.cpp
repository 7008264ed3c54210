// Mirrors and refraction against closed forms, and what it costs to have none.
#include "render/materials/shade_materials.h"

#include <gtest/gtest.h>

#include <numbers>

#include "render/fresnel.h"
#include "tests/render/hills.h"
#include "tests/render/materials/counting.h"
#include "tests/render/materials/studio.h"

namespace terrview {
namespace {

const glm::vec3 kWall(0.25F, 0.5F, 1);

Material mirror_of(double share) {
  Material material;
  material.mirror = gray(constant(share));
  return material;
}

std::shared_ptr<const AlignedBox> block(const glm::dvec3& lowest_m, const glm::dvec3& highest_m) {
  return std::make_shared<AlignedBox>(lowest_m, highest_m);
}

// Mirrors whose faces are x = 10 and x = -10.
std::shared_ptr<const AlignedBox> east_block() { return block({10, -99, -99}, {11, 99, 99}); }
std::shared_ptr<const AlignedBox> west_block() { return block({-11, -99, -99}, {-10, 99, 99}); }

TEST(Mirror, OfAColouredWallShowsTheWallTimesItsIndex) {
  const Scene scene =
      studio({{east_block(), {shared(mirror_of(0.5))}}, {west_block(), {glow(kWall)}}});
  EXPECT_EQ(color_along(scene, {{0, 0, 0}, {1, 0.3, 0.2}}), 0.5F * kWall);
}

TEST(Mirror, ReflectsWhereTheAngleIsTheSame) {
  // A small target where the mirrored ray comes by, and nowhere else.
  const glm::dvec3 mirrored_m(-8, 18 * 0.3 + 10 * 0.3, 28 * 0.2);
  const auto target = std::make_shared<Sphere>(mirrored_m, 0.01);
  const Scene scene = studio({{east_block(), {shared(mirror_of(1))}}, {target, {glow(kWall)}}});
  EXPECT_EQ(color_along(scene, {{0, 0, 0}, {1, 0.3, 0.2}}), kWall);
  EXPECT_EQ(color_along(scene, {{0, 0, 0}, {1, 0.302, 0.2}}), glm::vec3(0));
}

TEST(Mirror, ShowsTheSkyWhereThereIsNothing) {
  Scene scene = studio({{east_block(), {shared(mirror_of(0.5))}}});
  scene.sky = {.horizon = kWall, .zenith = kWall};
  EXPECT_EQ(color_along(scene, {{0, 0, 0}, {1, 0, 0.1}}), 0.5F * kWall);
}

// A mirror with a colour of its own.
Material tinted_mirror(LightModel model) {
  return phong(constant(glm::vec3(1, 0.5F, 0)), {.mirror = 0.5, .diffuse = 0.25}, model);
}

TEST(Guitteny, WeighsAMirrorsOwnColourAndKeepsItBeforeTheBackground) {
  const glm::vec3 own = 0.25F * glm::vec3(1, 0.5F, 0);
  const Thing mirror{east_block(), {shared(tinted_mirror(LightModel::guitteny))}};
  const Thing wall{west_block(), {glow(kWall)}};
  const Ray ray{{0, 0, 0}, {1, 0, 0.1}};
  EXPECT_EQ(color_along(studio({mirror, wall}), ray), 0.5F * own + 0.5F * kWall);
  Scene alone = studio({mirror});
  alone.sky = {.horizon = glm::vec3(1), .zenith = glm::vec3(1)};
  EXPECT_EQ(color_along(alone, ray), own);
}

TEST(Guitteny, MirrorsNothingBrighterThanWhite) {
  const Scene scene = studio({{east_block(), {shared(tinted_mirror(LightModel::guitteny))}},
                              {west_block(), {glow({4, 0.5F, 1})}}});
  EXPECT_EQ(color_along(scene, {{0, 0, 0}, {1, 0, 0.1}}),
            0.125F * glm::vec3(1, 0.5F, 0) + 0.5F * glm::vec3(1, 0.5F, 1));
}

TEST(Mirrors, ThatFaceEachOtherStopAtFiveBounces) {
  // Each adds its ambient 1 to half of what it mirrors.
  Material material = mirror_of(0.5);
  material.ambient = constant(1.0);
  material.model = LightModel::whitted;
  Scene scene = studio({{east_block(), {shared(material)}}, {west_block(), {shared(material)}}});
  const float level = 0.75F;  // of the ambient light on an upright wall
  float expected = level;
  for (int bounce = 0; bounce < kMostBounces; ++bounce) expected = level + 0.5F * expected;
  EXPECT_EQ(kMostBounces, 5);
  EXPECT_EQ(color_along(scene, {{0, 0, 0}, {1, 0, 0}}), glm::vec3(expected));
}

TEST(Mirror, IsDimmedByTheAirOfTheWholeWay) {
  Scene scene = studio({{east_block(), {shared(mirror_of(0.5))}}, {west_block(), {glow(kWall)}}});
  scene.air.extinction_per_m = 0.01;
  scene.air.color = glm::vec3(0);
  const float through = static_cast<float>(std::exp(-0.01 * (10 + 20)));
  expect_color(color_along(scene, {{0, 0, 0}, {1, 0, 0}}), 0.5F * through * kWall);
}

Material clear_solid(double index) {
  Material material;
  material.transparency = constant(glm::vec3(1));
  material.refractive_index = index;
  return material;
}

// Where the ray through a pane comes out, by a target of 2 mm there; the pane is 2 m thick.
TEST(Refraction, ThroughAPaneLeavesTheRayParallelAndAside) {
  for (const double index : {1.33, 1.5, 2.4, 1.0}) {
    for (const double angle : {0.0, 0.3, 0.8, 1.3}) {
      const double inside = std::asin(std::sin(angle) / index);
      const double aside_m = 2 * (std::tan(angle) - std::tan(inside));
      const glm::dvec3 along(std::cos(angle), std::sin(angle), 0);
      const glm::dvec3 target_m = 20.0 * along - glm::dvec3(0, aside_m, 0);
      const auto pane = block({3, -99, -99}, {5, 99, 99});
      const Scene scene = studio({{pane, {shared(clear_solid(index))}},
                                  {std::make_shared<Sphere>(target_m, 1e-3), {glow(kWall)}}});
      EXPECT_EQ(color_along(scene, {{0, 0, 0}, along}), kWall) << index << " " << angle;
      const glm::dvec3 off = along + glm::dvec3(0, 0, 1e-4);
      EXPECT_EQ(color_along(scene, {{0, 0, 0}, off}), glm::vec3(0));
    }
  }
}

TEST(Refraction, IsTotalReflectionBeyondTheCriticalAngle) {
  // From within a block, up to its top, z = 0; a wall within reach of the mirrored ray alone.
  const double critical_rad = std::asin(1 / 1.5);
  const auto target = block({-98, -98, -99}, {98, 98, -98});
  const auto roof = block({-999, -999, 9}, {999, 999, 10});
  const Scene scene =
      studio({{block({-500, -500, -500}, {500, 500, 0}), {shared(clear_solid(1.5))}},
              {target, {glow(kWall)}},
              {roof, {glow({1, 0, 0})}}});
  for (const double off_rad : {-1e-3, 1e-3}) {
    const double angle = critical_rad + off_rad;
    const glm::vec3 seen = color_along(scene, {{0, 0, -10}, {std::sin(angle), 0, std::cos(angle)}});
    EXPECT_EQ(seen, off_rad < 0 ? glm::vec3(1, 0, 0) : kWall);
  }
}

TEST(Refraction, ByABallLensBringsParallelRaysToItsFocus) {
  // f = n R / (2 (n - 1)) from the middle, for rays near the axis.
  const double focus_m = 1.5 * 2 / (2 * 0.5);
  const auto ball = std::make_shared<Sphere>(glm::dvec3(10, 0, 0), 2);
  const auto target = std::make_shared<Sphere>(glm::dvec3(10 + focus_m, 0, 0), 1e-3);
  const Scene scene = studio({{ball, {shared(clear_solid(1.5))}}, {target, {glow(kWall)}}});
  for (const double off_m : {-0.05, -0.02, 0.0, 0.03, 0.05})
    EXPECT_EQ(color_along(scene, {{0, off_m, off_m / 2}, {1, 0, 0}}), kWall) << off_m;
}

TEST(Glass, MirrorsAndLetsThroughByFresnelsLaw) {
  const auto pane = block({10, -99, -99}, {11, 99, 99});
  const Scene scene = studio({{pane, {shared(glass(1.5))}},
                              {block({20, -99, -99}, {21, 99, 99}), {glow({1, 0, 0})}},
                              {west_block(), {glow({0, 1, 0})}}});
  const glm::vec3 seen = color_along(scene, {{0, 0, 0}, {1, 0, 0}});
  // The series of what the two faces send back and forth, as far as the bounces go.
  const float r = static_cast<float>(fresnel_reflectance(1, 1.5));
  const float t = 1 - r;
  expect_color(seen, {t * t * (1 + r * r), r + t * t * r * (1 + r * r), 0});
  EXPECT_NEAR(r, 0.04, 1e-6);
}

TEST(Material, ComputesNothingThatItDoesNotName) {
  Material dark;
  dark.ambient = constant(1.0);
  Scene scene = studio({{east_block(), {shared(dark)}}});
  scene.light.sun = glm::vec3(1);
  scene.light.towards_sun = {-1, 0, 0.1};
  scene.lamps = {{}};
  const Look look = look_along(scene, {{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(look.counts.rays, 0);           // neither light nor shadow
  EXPECT_EQ(look.counts.objects.tests, 1);  // and no ray but the first
}

TEST(Material, AsksForEachNodeOnceAndForNoneOfAPartThatIsNotSeen) {
  const auto seen = std::make_shared<Counting>(0.5);
  const auto unseen = std::make_shared<Counting>(0.5);
  const auto weighed_out = std::make_shared<Counting>(0.5);
  Material front;
  front.ambient = mix(seen, weighed_out, constant(0.0));
  Material back;
  back.ambient = unseen;
  back.diffuse = unseen;
  const Scene scene = studio({{east_block(), {shared(front), shared(back)}}});
  expect_color(color_along(scene, {{0, 0, 0}, {1, 0, 0}}), glm::vec3(0.5F * 0.75F));
  EXPECT_EQ(seen->count, 1);
  EXPECT_EQ(unseen->count, 0);
  EXPECT_EQ(weighed_out->count, 0);
}

TEST(Material, IsThatOfThePartAndTheLastStandsForTheRest) {
  const auto cube = block({10, -1, -1}, {12, 1, 1});
  const std::vector<std::shared_ptr<const Material>> faces{glow({1, 0, 0}), nullptr,
                                                           glow({0, 0, 1})};
  const Scene scene = studio({{cube, faces}});
  EXPECT_EQ(color_along(scene, {{0, 0, 0}, {1, 0, 0}}), glm::vec3(1, 0, 0));
  expect_color(color_along(scene, {{20, 0, 0}, {-1, 0, 0}}), 0.75F * ObjectLook{}.color);
  EXPECT_EQ(color_along(scene, {{11, -9, 0}, {0, 1, 0}}), glm::vec3(0, 0, 1));
  EXPECT_EQ(color_along(scene, {{11, 0, 9}, {0, 0, -1}}), glm::vec3(0, 0, 1));
}

// Spheres of all kinds over hills.
Scene gallery() {
  Scene scene = hills_scene();
  auto objects = std::make_shared<SceneObjects>();
  Objects all;
  const std::vector<Material> materials{
      glass(1.5), mirror_of(0.9), lambert(constant(kWall)),
      phong(constant(kWall), {.mirror = 0.3, .diffuse = 0.3, .specular = 0.3})};
  for (int i = 0; i < 12; ++i) {
    all.push_back(
        std::make_shared<Sphere>(glm::dvec3(100 * (i - 6), 700 + 40 * (i % 5), 20 * (i % 3)), 60));
    objects->looks.push_back({i + 1, {}, {}, {shared(materials[static_cast<std::size_t>(i) % 4])}});
  }
  objects->set = std::make_shared<ObjectList>(std::move(all));
  scene.objects = objects;
  scene.lamps = {{.position_m = {0, 500, 100}, .intensity = 1e5}};
  return scene;
}

TEST(Materials, ThatAreNotSeenChangeNoBitAndNoRay) {
  const Scene plain = [] {
    Scene scene = gallery();
    scene.lamps.clear();
    auto objects = std::make_shared<SceneObjects>(*scene.objects);
    for (ObjectLook& look : objects->looks) look.materials.clear();
    scene.objects = objects;
    return scene;
  }();
  Scene behind = plain;
  auto objects = std::make_shared<SceneObjects>(*plain.objects);
  Objects all = objects->set->objects();
  all.push_back(std::make_shared<Sphere>(glm::dvec3(0, -1e5, 0), 60));
  objects->looks.push_back({99, {}, {}, {shared(glass(1.5))}});
  objects->set = std::make_shared<ObjectList>(std::move(all));
  behind.objects = objects;
  const Frame without = render(plain, level_camera({64, 40}));
  const Frame with = render(behind, level_camera({64, 40}));
  EXPECT_EQ(with.image.pixels(), without.image.pixels());
  EXPECT_EQ(with.counts.shadow_rays, without.counts.shadow_rays);
}

TEST(Materials, MakeTheSamePictureForAnyNumberOfThreadsAndAnyOrderOfRays) {
  const Scene scene = gallery();
  for (const Camera& camera : {level_camera({64, 40}), tilted_camera({64, 40})}) {
    const Image one = render(scene, camera, {.threads = 1}).image;
    for (const int threads : {2, 5})
      EXPECT_EQ(render(scene, camera, {.threads = threads}).image.pixels(), one.pixels());
    EXPECT_EQ(render(scene, camera, {.threads = 2, .coherence = Coherence::off}).image.pixels(),
              one.pixels());
  }
}

}  // namespace
}  // namespace terrview
