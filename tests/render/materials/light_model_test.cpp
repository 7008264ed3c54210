// The light of lamps on materials against closed forms.
#include "render/materials/light_model.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "tests/render/materials/studio.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
const glm::vec3 kBody(0.8F, 0.5F, 0.25F);

// A floor of 2 x 2 km whose top is z = 0.
std::shared_ptr<const AlignedBox> floor_block() {
  return std::make_shared<AlignedBox>(glm::dvec3(-1000, -1000, -5), glm::dvec3(1000, 1000, 0));
}

// Straight down on (x, 0, 0).
Ray down_on(double x_m) { return {{x_m, 0, 50}, {0, 0, -1}}; }

Material matte() {
  Material material;
  material.color = constant(kBody);
  material.diffuse = constant(0.5);
  return material;
}

TEST(Lambert, UnderALampFallsWithTheCubeOfTheCosine) {
  Scene scene = studio({{floor_block(), {shared(matte())}}});
  const glm::vec3 lamp_color(1, 0.9F, 0.5F);
  scene.lamps = {{.position_m = {0, 0, 10}, .color = lamp_color, .intensity = 80}};
  for (const double x_m : {0.0, 3.0, 10.0, 40.0}) {
    // I = kd C I0 cos / d^2, d = 10 / cos.
    const double distance_m = std::hypot(10, x_m);
    const double irradiance = 80 * 10 / std::pow(distance_m, 3);
    expect_color(color_along(scene, down_on(x_m)),
                 0.5F * static_cast<float>(irradiance) * kBody * lamp_color);
  }
}

TEST(Lambert, UnderALampWithoutAReferenceIsTheCosineAlone) {
  Scene scene = studio({{floor_block(), {shared(matte())}}});
  scene.lamps = {{.position_m = {0, 0, 10}, .intensity = 0.7, .reference_m = 0}};
  for (const double x_m : {0.0, 3.0, 10.0, 40.0}) {
    const double cosine = 10 / std::hypot(10, x_m);
    expect_color(color_along(scene, down_on(x_m)), static_cast<float>(0.5 * 0.7 * cosine) * kBody);
  }
}

TEST(Lambert, InTheSunIsAsAnObjectWithoutMaterial) {
  Scene with = studio({{floor_block(), {shared(lambert(constant(ObjectLook{}.color)))}}});
  Scene without = studio({{floor_block(), {}}});
  for (Scene* scene : {&with, &without}) {
    scene->light.sun = {0.9F, 0.7F, 0.4F};
    scene->light.ambient = {0.1F, 0.2F, 0.3F};
    scene->light.towards_sun = glm::normalize(glm::dvec3(1, 2, 3));
  }
  expect_color(color_along(with, down_on(20)), color_along(without, down_on(20)));
}

TEST(Spot, FallsWithTheCosineToItsAxisAndEndsAtItsCone) {
  Scene scene = studio({{floor_block(), {shared(matte())}}});
  const glm::dvec3 axis(0.2, 0, -1);
  const double half_angle_rad = 35 * kRadians;
  scene.lamps = {{.position_m = {0, 0, 10},
                  .intensity = 0.9,
                  .reference_m = 0,
                  .spot = Spot{axis, half_angle_rad}}};
  int lit = 0;
  for (int x_m = -20; x_m <= 20; ++x_m) {
    const double distance_m = std::hypot(10, x_m);
    const double cosine = glm::dot(glm::normalize(axis), glm::dvec3(x_m, 0, -10)) / distance_m;
    const bool is_lit = std::acos(cosine) < half_angle_rad;
    lit += is_lit ? 1 : 0;
    const double expected = is_lit ? 0.5 * 0.9 * cosine * 10 / distance_m : 0;
    expect_color(color_along(scene, down_on(x_m)), static_cast<float>(expected) * kBody);
  }
  EXPECT_GT(lit, 5);
  EXPECT_LT(lit, 20);
}

Material glossy(LightModel model) {
  Material material;
  material.color = constant(kBody);
  material.specular = constant(0.4);
  material.exponent = constant(7.0);
  material.model = model;
  return material;
}

TEST(Phong, HasALobeOfTheCosineToTheMirroredLight) {
  for (const LightModel model : {LightModel::whitted, LightModel::guitteny}) {
    Scene scene = studio({{floor_block(), {shared(glossy(model))}}});
    const glm::vec3 lamp_color(1, 0.5F, 0.25F);
    scene.lamps = {
        {.position_m = {-10, 0, 10}, .color = lamp_color, .intensity = 0.8, .reference_m = 0}};
    for (const double eye_deg : {-80.0, -50.0, -10.0, 0.0, 20.0, 45.0, 70.0}) {
      // The mirrored light leaves the origin at 45 degrees.
      const glm::dvec3 to_eye(std::sin(eye_deg * kRadians), 0, std::cos(eye_deg * kRadians));
      const double cosine = std::cos((eye_deg - 45) * kRadians);
      double lobe = 0;
      if (cosine > 0)
        lobe =
            model == LightModel::guitteny ? std::pow(0.8 * cosine, 7) : 0.8 * std::pow(cosine, 7);
      expect_color(color_along(scene, {100.0 * to_eye, -to_eye}),
                   static_cast<float>(0.4 * lobe) * lamp_color);
    }
  }
}

TEST(Phong, HasTheExponentFiftyWhereNoneIsNamed) {
  Material material = glossy(LightModel::whitted);
  material.exponent = nullptr;
  Scene scene = studio({{floor_block(), {shared(material)}}});
  scene.lamps = {{.position_m = {0, 0, 10}, .reference_m = 0}};
  const glm::dvec3 to_eye(std::sin(10 * kRadians), 0, std::cos(10 * kRadians));
  expect_color(color_along(scene, {100.0 * to_eye, -to_eye}),
               glm::vec3(static_cast<float>(0.4 * std::pow(to_eye.z, 50))));
}

TEST(Phong, LeavesTheAmbientLightWhatMirrorDiffuseAndSpecularDoNotTake) {
  Scene scene = studio(
      {{floor_block(),
        {shared(phong(constant(kBody), {.mirror = 0.125, .diffuse = 0.25, .specular = 0.125}))}}});
  scene.light.ambient = {0.5F, 1, 0.25F};
  expect_color(color_along(scene, down_on(3)), 0.5F * kBody * scene.light.ambient);
}

TEST(Guitteny, TakesTheColourOfTheSourceForTheHighlightAlone) {
  Material material = glossy(LightModel::guitteny);
  material.diffuse = constant(0.5);
  Scene scene = studio({{floor_block(), {shared(material)}}});
  const glm::vec3 lamp_color(1, 0, 0);
  scene.lamps = {
      {.position_m = {0, 0, 10}, .color = lamp_color, .intensity = 0.5, .reference_m = 0}};
  expect_color(color_along(scene, down_on(0)),
               0.25F * kBody + static_cast<float>(0.4 * std::pow(0.5, 7)) * lamp_color);
}

TEST(Guitteny, HasTheSameAmbientLightOnAllSides) {
  Material material;
  material.color = constant(kBody);
  material.ambient = constant(0.5);
  for (const LightModel model : {LightModel::whitted, LightModel::guitteny}) {
    material.model = model;
    const Scene scene = studio({{std::make_shared<Sphere>(glm::dvec3(0), 10), {shared(material)}}});
    const float from_below = model == LightModel::guitteny ? 1 : 0.5F;
    expect_color(color_along(scene, {{0, 0, -50}, {0, 0, 1}}), 0.5F * from_below * kBody);
    expect_color(color_along(scene, {{0, 0, 50}, {0, 0, -1}}), 0.5F * kBody);
  }
}

// Unit directions that point down, and up.
rc::Gen<glm::dvec3> slanted(double z_sign) {
  const auto share = rc::gen::inRange(-1000, 1001);
  return rc::gen::map(
      rc::gen::tuple(share, share, rc::gen::inRange(1, 1001)),
      [z_sign](const std::tuple<int, int, int>& v) {
        return glm::normalize(glm::dvec3(std::get<0>(v), std::get<1>(v), z_sign * std::get<2>(v)));
      });
}

RC_GTEST_PROP(Reflection, KeepsTheTangentAndTurnsTheNormalComponent, ()) {
  const glm::dvec3 direction = *slanted(-1);
  const glm::dvec3 mirrored = reflected(direction, {0, 0, 1});
  RC_ASSERT(mirrored == glm::dvec3(direction.x, direction.y, -direction.z));
}

RC_GTEST_PROP(Snell, HoldsAndIsUndoneOnTheWayBack, ()) {
  const glm::dvec3 direction = *slanted(-1);
  const double index = *rc::gen::inRange(20, 300) / 100.0;
  const glm::dvec3 up(0, 0, 1);
  const double sine = glm::length(glm::dvec2(direction)) / index;
  const auto beyond = refracted(direction, up, index);
  RC_ASSERT(beyond.has_value() == (sine <= 1) || std::abs(sine - 1) < 1e-12);
  if (!beyond || sine > 1 - 1e-9) return;
  RC_ASSERT(std::abs(glm::length(*beyond) - 1) < 1e-12);
  RC_ASSERT(std::abs(glm::length(glm::dvec2(*beyond)) - sine) < 1e-9);
  const auto back = refracted(-*beyond, -up, 1 / index);
  RC_ASSERT(back.has_value());
  RC_ASSERT(glm::distance(*back, -direction) < 1e-6);
}

TEST(Lamp, IsHiddenByObjectsAndGroundBeforeItAndByNothingBehind) {
  const auto ball = std::make_shared<Sphere>(glm::dvec3(0, 0, 5), 2);
  const auto far_ball = std::make_shared<Sphere>(glm::dvec3(0, 0, 30), 2);
  Scene scene = studio({{floor_block(), {shared(matte())}}, {ball, {}}, {far_ball, {}}});
  scene.lamps = {{.position_m = {0, 0, 10}, .intensity = 80}};
  // The ball's shadow has the radius of the tangent cone: sin a = 2 / 5.
  const double edge_m = 10 * std::tan(std::asin(0.4));
  const auto from_aside = [](double x_m) { return ray_towards({x_m, 60, 3}, {x_m, 0, 0}); };
  expect_color(color_along(scene, from_aside(edge_m - 0.01)), glm::vec3(0));
  EXPECT_GT(color_along(scene, from_aside(edge_m + 0.01)).x, 0.1F);
  scene.light.casts_shadows = false;
  EXPECT_GT(color_along(scene, from_aside(edge_m - 0.01)).x, 0.1F);
}

TEST(Lamp, LightsGroundAndObjectsWithoutMaterial) {
  Scene scene = studio({{std::make_shared<AlignedBox>(glm::dvec3(-50, 50, kGround_m),
                                                      glm::dvec3(50, 60, kGround_m + 30)),
                         {}}});
  scene.tints = {.stops = {{0, kBody}}};
  scene.light.ambient = glm::vec3(0);
  scene.lamps = {{.position_m = {0, 0, kGround_m + 10}, .intensity = 100}};
  expect_color(color_along(scene, ray_towards({3, 0, 0}, {0, 0, kGround_m})), 1.0F * kBody);
  const double wall = 100 * 50 / std::pow(std::hypot(50, 10), 3);
  expect_color(color_along(scene, ray_towards({0, 0, kGround_m + 60}, {0, 50, kGround_m + 20})),
               static_cast<float>(wall) * glm::vec3(0.6F));
  // Behind the block.
  expect_color(color_along(scene, ray_towards({0, 90, 0}, {0, 90, kGround_m})), glm::vec3(0));
}

TEST(Lamp, ShinesThroughWhatIsLeftOutOfTheCasters) {
  const auto ball = std::make_shared<Sphere>(glm::dvec3(0, 0, 5), 2);
  const auto other_ball = std::make_shared<Sphere>(glm::dvec3(5, 0, 5), 1);
  Scene scene = studio({{floor_block(), {shared(matte())}},
                        {ball, {shared(matte()), shared(glass(1.5))}},
                        {other_ball, {shared(matte())}}});
  scene.lamps = {{.position_m = {0, 0, 10}, .intensity = 80}};
  scene.light.sun = glm::vec3(1);
  const Ray below = ray_towards({0, 60, 3}, {0, 0, 0});
  const Ray below_other = ray_towards({10, 60, 3}, {10, 0, 0});
  expect_color(color_along(scene, below), glm::vec3(0));
  SceneObjects objects = *scene.objects;
  objects.casters = std::make_shared<ObjectList>(opaque_objects(objects));
  EXPECT_EQ(objects.casters->objects().size(), 2);
  scene.objects = std::make_shared<const SceneObjects>(objects);
  expect_color(color_along(scene, below), (0.5F * 0.8F + 0.5F) * kBody);
  // The other ball hides the lamp, but not the sun overhead.
  expect_color(color_along(scene, below_other), 0.5F * kBody);
}

// The studio on a round Earth, under an eye 1500 m high, its ground at height 0.
Scene round_studio(const std::vector<Thing>& things) {
  Scene scene = studio(things);
  const VerticalFrame earth{.eye_height_m = 1500,
                            .north_curvature_per_m = 1 / 6371000.0,
                            .east_curvature_per_m = 1 / 6371000.0,
                            .refraction = 0.13};
  const TerrainLayer layer = make_layer(make_grid(3, 260, [](int, int) { return 0.0; }),
                                        {.eye_uv = {1, 250}, .spacing_m = {300, 300}});
  scene.terrain = std::make_shared<Terrain>(std::vector{layer}, earth, SurfaceModel::triangles);
  scene.tints = {.stops = {{0, kBody}}};
  scene.light.ambient = glm::vec3(0);
  return scene;
}

constexpr double kAway_m = 60000;  // where level ground slopes by half a degree in the view frame

TEST(Lamp, StandsUprightOnARoundEarth) {
  Scene scene = round_studio({});
  const VerticalFrame& frame = scene.terrain->frame();
  const Ray ray{{0, 0, 0}, {0, kAway_m, frame.at({0, kAway_m}).z_m(0)}};
  const glm::dvec2 seen_m(scene.terrain->first_hit(ray).value().position_m);
  ASSERT_NEAR(seen_m.y, kAway_m, 1);
  for (const double aside_m : {-20.0, 20.0}) {
    const glm::dvec2 foot_m = seen_m + glm::dvec2(0, aside_m);
    scene.lamps = {{.position_m = {foot_m, frame.at(foot_m).z_m(20)}, .reference_m = 0}};
    expect_color(color_along(scene, ray), static_cast<float>(std::sqrt(0.5)) * kBody, 2e-4);
  }
}

TEST(Lambert, InTheSunIsAsAnObjectWithoutMaterialOnARoundEarth) {
  const auto ball = std::make_shared<Sphere>(glm::dvec3(0, kAway_m, -300), 100);
  Scene with = round_studio({{ball, {shared(lambert(constant(ObjectLook{}.color)))}}});
  Scene without = round_studio({{ball, {}}});
  for (Scene* scene : {&with, &without}) {
    scene->light.sun = glm::vec3(1);
    scene->light.towards_sun = glm::normalize(glm::dvec3(0.2, -1, 0.3));
  }
  for (const double x_m : {-60.0, 0.0, 60.0}) {
    const Ray ray = ray_towards({0, 0, 0}, {x_m, kAway_m - 50, -300});
    const glm::vec3 seen = color_along(with, ray);
    EXPECT_GT(seen.x, 0.3F);
    expect_color(seen, color_along(without, ray));
  }
}

TEST(Bump, OfAConstantChangesNoBit) {
  const ShadingPoint point{.position_m = {3, 4, 5}, .width_m = 0.1};
  for (const glm::dvec3& direction : {glm::dvec3(0, 0, 1), glm::dvec3(1, 2, -3)}) {
    const glm::dvec3 normal = glm::normalize(direction);
    EXPECT_EQ(bumped_normal(constant(7.25), point, normal), normal);
  }
}

ScalarShade linear(const glm::dvec3& gradient) {
  return shade_node<double>(
      [gradient](const ShadingPoint& point) { return glm::dot(gradient, point.position_m); });
}

TEST(Bump, TiltsTheNormalAgainstTheSlope) {
  const ShadingPoint point{.position_m = {3, 4, 5}, .width_m = 0.1};
  // z = 0.5 x: the normal of that plane, whatever the gradient across the surface.
  for (const double across : {0.0, 9.0}) {
    const glm::dvec3 normal = bumped_normal(linear({0.5, 0, across}), point, {0, 0, 1});
    EXPECT_LT(glm::distance(normal, glm::normalize(glm::dvec3(-0.5, 0, 1))), 1e-9);
  }
}

// Beside the kink of |x|, a quarter of a pixel from it: (|0.75| - |-0.25|) / 1.
TEST(Bump, IsTheSlopeOverAPixelsWidth) {
  const ScalarShade ridge =
      shade_node<double>([](const ShadingPoint& point) { return std::abs(point.position_m.x); });
  const ShadingPoint point{.position_m = {0.25, 0, 0}, .width_m = 1};
  const glm::dvec3 normal = bumped_normal(ridge, point, {0, 0, 1});
  EXPECT_LT(glm::distance(normal, glm::normalize(glm::dvec3(-0.5, 0, 1))), 1e-9);
}

TEST(Bump, TurnsWithWhatItIsOn) {
  const glm::dvec3 gradient(0.3, -0.2, 0.1);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, 0.4, 1));
  const ShadingPoint point{.position_m = {1, 2, 3}, .width_m = 0.01};
  const glm::dvec3 still = bumped_normal(linear(gradient), point, normal);
  for (const double angle : {0.4, 1.7, 2.9, 4.4}) {
    const auto turned = [angle](const glm::dvec3& v) {  // about x
      return glm::dvec3(v.x, std::cos(angle) * v.y - std::sin(angle) * v.z,
                        std::sin(angle) * v.y + std::cos(angle) * v.z);
    };
    ShadingPoint there = point;
    there.position_m = turned(point.position_m);
    const glm::dvec3 bumped = bumped_normal(linear(turned(gradient)), there, turned(normal));
    EXPECT_LT(glm::distance(bumped, turned(still)), 1e-9);
  }
}

// The normal (1, 0, 2) / sqrt 5 faces away from an eye so low in the west: what is nearest to it of
// all that the eye can see lights the floor.
TEST(Bump, IsSeenEdgeOnWhereItWouldFaceAway) {
  Material material = matte();
  material.bump_m = linear({-0.5, 0, 0});
  Scene scene = studio({{floor_block(), {shared(material)}}});
  scene.lamps = {{.position_m = {0, 0, 10}, .reference_m = 0}};
  const glm::dvec3 to_eye = glm::normalize(glm::dvec3(-60, 0, 3));
  const glm::dvec3 away = glm::normalize(glm::dvec3(1, 0, 2));
  ASSERT_LT(glm::dot(away, to_eye), 0);
  const glm::dvec3 edge_on = glm::normalize(away - glm::dot(away, to_eye) * to_eye);
  expect_color(color_along(scene, {60.0 * to_eye, -to_eye}),
               0.5F * static_cast<float>(edge_on.z) * kBody);
}

TEST(Bump, LightsAFloorAsTheSlopeItPretendsToBe) {
  Material material = matte();
  material.bump_m = linear({0.75, 0, 0});
  Scene scene = studio({{floor_block(), {shared(material)}}});
  scene.lamps = {{.position_m = {0, 0, 10}, .reference_m = 0}};
  expect_color(color_along(scene, down_on(0)), 0.5F * 0.8F * kBody);
  // N = (-3, 0, 4) / 5, L = (-8, 0, 10) / |.| at x = 8, and beyond its edge at x = -40.
  const double facing = (3 * 8 + 4 * 10) / 5.0 / std::hypot(8, 10);
  expect_color(color_along(scene, down_on(8)), 0.5F * static_cast<float>(facing) * kBody);
  expect_color(color_along(scene, down_on(-40)), glm::vec3(0));
}

}  // namespace
}  // namespace terrview
