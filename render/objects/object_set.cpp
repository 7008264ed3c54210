#include "render/objects/object_set.h"

#include <cstddef>

namespace terrview {

std::optional<ObjectHit> ObjectList::first_hit(const Ray& ray, ObjectCounts* counts) const {
  std::optional<ObjectHit> nearest;
  for (std::size_t i = 0; i < objects().size(); ++i) {
    const std::optional<SurfaceHit> hit = objects()[i]->first_hit(ray);
    if (hit && (!nearest || hit->distance_m < nearest->surface.distance_m)) {
      nearest = ObjectHit{*hit, static_cast<int>(i)};
    }
  }
  if (counts != nullptr) counts->tests += static_cast<std::int64_t>(objects().size());
  return nearest;
}

bool ObjectList::stops(const Ray& ray, ObjectCounts* counts) const {
  for (const auto& object : objects()) {
    if (counts != nullptr) ++counts->tests;
    if (object->stops(ray)) return true;
  }
  return false;
}

}  // namespace terrview
