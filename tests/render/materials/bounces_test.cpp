// Where mirrored and refracted rays go, and how wide pixels are there.
#include <gtest/gtest.h>

#include <numbers>

#include "render/materials/shade_materials.h"
#include "tests/render/materials/studio.h"

namespace terrview {
namespace {

const glm::vec3 kWall(0.25F, 0.5F, 1);

ScalarShade linear(const glm::dvec3& gradient) {
  return shade_node<double>(
      [gradient](const ShadingPoint& point) { return glm::dot(gradient, point.position_m); });
}

Thing target_at(const glm::dvec3& middle_m, double radius_m) {
  return {std::make_shared<Sphere>(middle_m, radius_m), {glow(kWall)}};
}

// A block whose top is z = 0.
Thing floor_of(const Material& material) {
  return {std::make_shared<AlignedBox>(glm::dvec3(-500, -500, -500), glm::dvec3(500, 500, 0)),
          {shared(material)}};
}

TEST(Bounces, SeePixelsAsWideAsTheirWholeWayMakesThem) {
  std::vector<double> widths_m;
  Material material;
  material.mirror = constant(glm::vec3(1));
  material.ambient = shade_node<double>([&](const ShadingPoint& point) {
    widths_m.push_back(point.width_m);
    return 1.0;
  });
  const auto wall = [&](double x_m) {
    return Thing{
        std::make_shared<AlignedBox>(glm::dvec3(x_m - 1, -99, -99), glm::dvec3(x_m, 99, 99)),
        {shared(material)}};
  };
  const Scene scene = studio({wall(-10), wall(11)});
  static_cast<void>(look_along(scene, {{0, 0, 0}, {1, 0, 0}}, {.rad = 0.01}));
  ASSERT_EQ(widths_m.size(), static_cast<std::size_t>(kMostBounces) + 1);
  for (std::size_t i = 0; i < widths_m.size(); ++i)
    EXPECT_NEAR(widths_m[i], 0.01 * (10 + 20 * static_cast<double>(i)), 1e-4);
}

TEST(Bounces, OfAShareOfNothingSendNoRay) {
  Material material;
  material.mirror = constant(glm::vec3(0));
  material.transparency = constant(glm::vec3(0));
  const Scene scene = studio({floor_of(material)});
  EXPECT_EQ(look_along(scene, {{0, 0, 10}, {1, 0, -1}}).counts.objects.tests, 1);
}

// The bump's normal, edge-on to the ray, would send it on into the floor.
TEST(Bounces, OfAMirrorLeaveItWhateverItsBumps) {
  Material material;
  material.mirror = constant(glm::vec3(1));
  material.bump_m = linear({-0.5, 0, 0});
  const Scene scene = studio({floor_of(material), target_at({50, 0, 5}, 0.5)});
  EXPECT_EQ(color_along(scene, {{-50, 0, 5}, {1, 0, -0.1}}), kWall);
}

// From within glass, at 3 degrees to its top, which a bump makes 56: Snell's law sends the ray out
// of the bump, but back into the glass. Without the bump it is beyond the critical angle, and the
// bump mirrors it down.
TEST(Bounces, ThroughASurfaceGoThroughItWhateverItsBumps) {
  Material material;
  material.transparency = constant(glm::vec3(1));
  material.refractive_index = 1.5;
  material.bump_m = linear({-4.0 / 3, 0, 0});  // the normal (4, 0, 3) / 5
  const glm::dvec3 along = glm::normalize(glm::dvec3(1, 0, 0.05));
  const glm::dvec3 normal(0.8, 0, 0.6);
  const glm::dvec3 mirrored = along - 2 * glm::dot(along, normal) * normal;
  ASSERT_LT(mirrored.z, 0);
  const Scene scene = studio({floor_of(material), target_at(20.0 * mirrored, 0.1)});
  EXPECT_EQ(color_along(scene, {-20.0 * along, along}), kWall);
}

// A level surface far away on a round Earth, by its slope in the view frame.
class FarFloor final : public Object {
 public:
  FarFloor(const glm::dvec3& at_m, double slope) : at_m_(at_m), slope_(slope) {}
  [[nodiscard]] Box bounds() const override { return {at_m_ - 500.0, at_m_ + 500.0}; }
  [[nodiscard]] std::optional<SurfaceHit> first_hit(const Ray& ray) const override {
    const glm::dvec3 along = glm::normalize(ray.direction);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0, -slope_, 1));
    const double distance_m = glm::dot(at_m_ - ray.origin_m, normal) / glm::dot(along, normal);
    if (!(distance_m >= 0 && distance_m <= ray.length_m)) return std::nullopt;
    return SurfaceHit{distance_m, ray.origin_m + distance_m * along, normal, 0};
  }

 private:
  glm::dvec3 at_m_;
  double slope_;
};

TEST(Bounces, AreThoseOfALevelMirrorOnARoundEarth) {
  constexpr double kAway_m = 60'000;
  constexpr double kHeight_m = 100;
  Scene scene = studio({});
  const VerticalFrame earth{.eye_height_m = 1500,
                            .north_curvature_per_m = 1 / 6371000.0,
                            .east_curvature_per_m = 1 / 6371000.0};
  scene.terrain = std::make_shared<Terrain>(
      std::vector{make_layer(make_grid(3, 260, [](int, int) { return 0.0; }),
                             {.eye_uv = {1, 250}, .spacing_m = {300, 300}})},
      earth, SurfaceModel::triangles);
  const auto level_z_m = [&](double y_m) { return earth.at({0, y_m}).z_m(kHeight_m); };
  const double slope = (level_z_m(kAway_m + 1) - level_z_m(kAway_m - 1)) / 2;
  ASSERT_LT(slope, -0.009);
  const glm::dvec3 at_m(0, kAway_m, level_z_m(kAway_m));
  // Down and back up at 45 degrees to what is level there.
  const glm::dvec3 down(0, 1, slope - 1);
  const glm::dvec3 up(0, 1, slope + 1);
  Material material;
  material.mirror = constant(glm::vec3(1));
  const std::vector<Thing> things{{std::make_shared<FarFloor>(at_m, slope), {shared(material)}},
                                  target_at(at_m + 50.0 * up, 0.1)};
  scene.objects = studio(things).objects;
  EXPECT_EQ(color_along(scene, {at_m - 50.0 * down, down}), kWall);
}

}  // namespace
}  // namespace terrview
