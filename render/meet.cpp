#include "render/meet.h"

#include <algorithm>

#include "render/objects/scene_objects.h"
#include "terrain/tracer.h"

namespace terrview {
namespace {

// Whether the ray comes below the ground, over an edge of it, before its end.
bool ends_below_ground(const Terrain& terrain, const Ray& ray) {
  return trace(terrain, terrain.ceiling_m(), ray).outcome == Outcome::below;
}

std::optional<ObjectHit> nearest_object(const Scene& scene, Ray ray, const std::optional<Hit>& hit,
                                        ObjectCounts& counts) {
  if (hit) ray.length_m = std::min(ray.length_m, hit->distance_m);
  auto object = scene.objects->set->first_hit(ray, &counts);
  if (!object || hit || scene.objects->walls_in_ground) return object;
  // What stands behind the edge at which the ray ended is not seen.
  ray.length_m = object->surface.distance_m;
  if (ends_below_ground(*scene.terrain, ray)) object.reset();
  return object;
}

}  // namespace

void meet_objects(const Scene& scene, std::span<const Ray> rays, RayHits& hits,
                  ObjectCounts& counts) {
  if (!scene.objects) return;
  hits.objects.resize(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits.objects[i] = nearest_object(scene, rays[i], hits.ground[i], counts);
    if (hits.objects[i]) hits.ground[i].reset();
  }
}

}  // namespace terrview
