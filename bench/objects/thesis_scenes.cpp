#include "bench/objects/thesis_scenes.h"

#include <algorithm>
#include <iomanip>
#include <memory>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bench/bench_dem.h"
#include "bench/bench_view.h"
#include "bench/objects/object_scene.h"
#include "bench/objects/uniform_random.h"
#include "render/objects/box.h"
#include "render/objects/rectangle_map.h"
#include "render/objects/slab_ray.h"
#include "render/objects/sphere.h"

namespace terrview {
namespace {

constexpr std::uint64_t kSeed = 1984;
constexpr double kLift_m = 1e-6;

std::shared_ptr<const Object> box(const glm::dvec3& low, const glm::dvec3& extent) {
  return std::make_shared<BoxObject>(Box{low, low + extent});
}

Objects spheres() {
  UniformRandom random(kSeed);
  constexpr glm::dvec3 kExtent(100, 100, 50);
  Objects objects;
  while (objects.size() < 200) {
    glm::dvec3 centre;
    for (int axis = 0; axis < 3; ++axis) centre[axis] = random(0, kExtent[axis]);
    const glm::dvec3 room = glm::min(centre, kExtent - centre);
    const double radius = random(0, std::min({room.x, room.y, room.z}));
    objects.push_back(std::make_shared<Sphere>(centre, radius));
  }
  return objects;
}

Objects prisms() {
  UniformRandom random(kSeed);
  Objects objects;
  for (int row = 0; row < 15; ++row)
    for (int column = 0; column < 15; ++column)
      objects.push_back(box({10.0 * column, 10.0 * row, 0}, {6, 6, random(2, 20)}));
  return objects;
}

ThesisScene sphere_scene() {
  const glm::dvec3 to_sun = glm::normalize(glm::dvec3(0.5, -0.6, 0.6));
  ThesisScene scene{"[S] 200 spheres", spheres(), {}, {}, {2.06, 2.55}, {3.77, 3.00}, "497 / 697"};
  scene.primary = view_rays({"S", {50, -90, 90}, {50, 50, 25}, 0.9, {640, 484}});
  scene.secondary = shadow_rays(ObjectList(scene.objects), scene.primary, to_sun, kLift_m);
  return scene;
}

ThesisScene prism_scene() {
  const glm::dvec3 to_sun = glm::normalize(glm::dvec3(0.5, -0.6, 0.6));
  ThesisScene scene{"[P] 225 prisms", prisms(), {}, {}, {1.17, 1.62}, {1.45, 1.85}, "242 / 467"};
  scene.primary = view_rays({"P", {73, -70, 90}, {73, 73, 0}, 0.9, {512, 512}});
  scene.secondary = shadow_rays(ObjectList(scene.objects), scene.primary, to_sun, kLift_m);
  return scene;
}

// Prisms stand where rays of the lower half of the picture meet the ground.
Objects prisms_on(const Terrain& terrain, const Camera& camera) {
  UniformRandom random(kSeed);
  const glm::dvec2 size_px(camera.options().size_px);
  Objects objects;
  while (objects.size() < 15) {
    const double x = random(0, size_px.x);
    const auto hit = terrain.first_hit(camera.ray({x, random(0.5, 1) * size_px.y}));
    if (!hit) continue;
    const double side_m = 0.04 * hit->distance_m;
    const double height_m = random(0.5, 2) * side_m;
    const glm::dvec3 sunk(side_m / 2, side_m / 2, side_m / 2);
    objects.push_back(box(hit->position_m - sunk, {side_m, side_m, height_m + sunk.z}));
  }
  return objects;
}

// The sun is almost overhead, as it was in the thesis.
ThesisScene terrain_scene() {
  const BenchDem dem = thesis_mountains();
  const BenchView view = thesis_valley(dem);
  const Terrain terrain = terrain_of(dem, view, SurfaceModel::hyperboloid, Search::pyramid);
  const glm::dvec3 to_sun = glm::normalize(glm::dvec3(0.1, -0.1, 1));
  ThesisScene scene{"[T] 15 prisms on terrain",
                    prisms_on(terrain, view.camera),
                    {},
                    {},
                    {0.20, 1.95},
                    {0.10, 0.51},
                    "-"};
  const ObjectList all(scene.objects);
  const glm::ivec2 size_px = view.camera.options().size_px;
  for (int y = 0; y < size_px.y; ++y)
    for (int x = 0; x < size_px.x; ++x) {
      const Ray& ray = scene.primary.emplace_back(view.camera.ray({x + 0.5, y + 0.5}));
      const auto ground = terrain.first_hit(ray);
      const auto object = all.first_hit(ray);
      if (object && (!ground || object->surface.distance_m < ground->distance_m)) {
        const auto& surface = object->surface;
        if (glm::dot(surface.normal, to_sun) > 0)
          scene.secondary.push_back({surface.position_m + kLift_m * surface.normal, to_sun});
      } else if (ground) {
        scene.secondary.push_back(terrain.leave(*ground, to_sun));
      }
    }
  return scene;
}

struct Work {
  double tests;
  double changes;
  double tests_per_pierced;  // of the boxes entered before the hit
  bool agrees;               // with testing every object
};

Work primary_work(const RectangleMap& map, const std::vector<Ray>& rays) {
  const ObjectList all(map.objects());
  ObjectCounts counts;
  std::int64_t pierced = 0;
  bool agrees = true;
  for (const Ray& ray : rays) {
    const auto hit = map.first_hit(ray, &counts);
    const auto expected = all.first_hit(ray);
    agrees = agrees && hit.has_value() == expected.has_value() &&
             (!hit || (hit->object == expected->object &&
                       hit->surface.distance_m == expected->surface.distance_m));
    const SlabRay slabs(ray);
    for (const auto& object : map.objects())
      if (slabs.within(object->bounds(), 0, hit ? hit->surface.distance_m : slabs.length_m()))
        ++pierced;
  }
  const auto count = static_cast<double>(rays.size());
  return {static_cast<double>(counts.tests) / count, static_cast<double>(counts.steps) / count,
          static_cast<double>(counts.tests) / static_cast<double>(pierced), agrees};
}

Work secondary_work(const RectangleMap& map, const std::vector<Ray>& rays) {
  const ObjectList all(map.objects());
  ObjectCounts counts;
  bool agrees = true;
  for (const Ray& ray : rays) agrees = map.stops(ray, &counts) == all.stops(ray) && agrees;
  const auto count = static_cast<double>(rays.size());
  return {static_cast<double>(counts.tests) / count, static_cast<double>(counts.steps) / count, 0,
          agrees};
}

}  // namespace

std::vector<ThesisScene> thesis_scenes() {
  std::vector<ThesisScene> scenes;
  scenes.push_back(sphere_scene());
  scenes.push_back(prism_scene());
  scenes.push_back(terrain_scene());
  return scenes;
}

void write_thesis_table(std::ostream& out) {
  out << "| scene | empty / all rectangles | rays, primary / secondary | tests a primary ray | "
         "tests a "
         "secondary ray | changes of rectangle | tests for each box entered before the hit | as "
         "every "
         "object |\n|---|---|---|---|---|---|---|---|\n"
      << std::fixed << std::setprecision(2);
  for (const ThesisScene& scene : thesis_scenes()) {
    const RectangleMap map(scene.objects);
    const Work primary = primary_work(map, scene.primary);
    const Work secondary = secondary_work(map, scene.secondary);
    out << "| " << scene.name << " | " << map.empty_rectangles() << " / " << map.rectangles()
        << " (" << scene.printed_rectangles << ") | " << scene.primary.size() << " / "
        << scene.secondary.size() << " | " << primary.tests << " (" << scene.printed_primary.tests
        << ") | " << secondary.tests << " (" << scene.printed_secondary.tests << ") | "
        << primary.changes << " / " << secondary.changes << " (" << scene.printed_primary.changes
        << " / " << scene.printed_secondary.changes << ") | " << primary.tests_per_pierced << " | "
        << (primary.agrees && secondary.agrees ? "yes" : "NO") << " |\n";
  }
}

}  // namespace terrview
