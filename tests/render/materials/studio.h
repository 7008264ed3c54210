// Scenes whose light is known in closed form: objects of given materials over black ground far
// below, in the dark but for what a test adds.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/materials/material.h"
#include "render/meet.h"
#include "render/objects/object_set.h"
#include "render/objects/scene_objects.h"
#include "render/objects/sphere.h"
#include "render/render.h"
#include "render/shade.h"
#include "tests/support/scenes.h"

namespace terrview {

inline constexpr double kGround_m = -1000;

// A box with its sides along the axes, each face a part: -x, +x, -y, +y, -z, +z.
class AlignedBox final : public Object {
 public:
  AlignedBox(const glm::dvec3& lowest_m, const glm::dvec3& highest_m) : box_{lowest_m, highest_m} {}

  [[nodiscard]] Box bounds() const override { return box_; }
  [[nodiscard]] std::optional<SurfaceHit> first_hit(const Ray& ray) const override {
    const glm::dvec3 along = glm::normalize(ray.direction);
    std::optional<SurfaceHit> nearest;
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      const double plane_m = (face % 2 == 0 ? box_.lowest_m : box_.highest_m)[axis];
      const double distance_m = (plane_m - ray.origin_m[axis]) / along[axis];
      if (!(distance_m >= 0 && distance_m <= ray.length_m)) continue;
      if (nearest && nearest->distance_m <= distance_m) continue;
      glm::dvec3 at_m = ray.origin_m + distance_m * along;
      at_m[axis] = plane_m;
      if (glm::clamp(at_m, box_.lowest_m, box_.highest_m) != at_m) continue;
      glm::dvec3 normal(0);
      normal[axis] = face % 2 == 0 ? -1 : 1;
      nearest = SurfaceHit{distance_m, at_m, normal, face};
    }
    return nearest;
  }

 private:
  Box box_;
};

struct Thing {
  std::shared_ptr<const Object> object;
  std::vector<std::shared_ptr<const Material>> materials;
};

[[nodiscard]] inline std::shared_ptr<const Material> shared(Material material) {
  return std::make_shared<const Material>(std::move(material));
}

// Shows one colour, whatever the light: under an ambient light of 1, seen level.
[[nodiscard]] inline std::shared_ptr<const Material> glow(const glm::vec3& color) {
  Material material;
  material.color = constant(color);
  material.ambient = constant(1.0);
  material.model = LightModel::guitteny;
  return shared(material);
}

// Without sun and sky; the ambient light is 1.
[[nodiscard]] inline Scene studio(const std::vector<Thing>& things) {
  Scene scene;
  scene.terrain = std::make_shared<Terrain>(
      make_terrain(make_grid(3, 3, [](int, int) { return kGround_m; }),
                   {.eye_uv = {1, 1}, .spacing_m = {5000, 5000}}, SurfaceModel::triangles));
  scene.tints = {.stops = {{0, glm::vec3(0)}}};
  scene.light.sun = glm::vec3(0);
  scene.light.ambient = glm::vec3(1);
  scene.light.towards_sun = {0, 0, 1};
  scene.sky = {.horizon = glm::vec3(0), .zenith = glm::vec3(0)};
  auto objects = std::make_shared<SceneObjects>();
  Objects all;
  for (const Thing& thing : things) {
    all.push_back(thing.object);
    ObjectLook look;
    look.id = static_cast<std::int32_t>(all.size());
    look.materials = thing.materials;
    objects->looks.push_back(look);
  }
  objects->set = std::make_shared<ObjectList>(std::move(all));
  scene.objects = objects;
  return scene;
}

struct Look {
  ShadedRay shaded;
  ShadowCounts counts;
};

// What one ray shows.
[[nodiscard]] inline Look look_along(const Scene& scene, const Ray& ray,
                                     const PixelWidth& pixel = {}) {
  RayHits hits{{scene.terrain->first_hit(ray)}};
  Look look;
  meet_objects(scene, {&ray, 1}, hits, look.counts.objects);
  look.shaded = shade(scene, {pixel}, {&ray, 1}, hits, look.counts).front();
  return look;
}

[[nodiscard]] inline glm::vec3 color_along(const Scene& scene, const Ray& ray) {
  return look_along(scene, ray).shaded.color;
}

inline void expect_color(const glm::vec3& color, const glm::vec3& expected,
                         double tolerance = 1e-6) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], expected[i], tolerance) << i;
}

}  // namespace terrview
