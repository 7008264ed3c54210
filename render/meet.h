// What rays meet: the ground, or an object before it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/objects/object_set.h"
#include "render/scene.h"
#include "terrain/ray.h"

namespace terrview {

struct RayHits {
  std::vector<std::optional<Hit>> ground;
  // Empty in a scene without objects. Where an object is met, the ground is not.
  std::vector<std::optional<ObjectHit>> objects = {};
  // Empty in a scene without water. Whether the ground met is water, which then is the hit.
  std::vector<std::uint8_t> water = {};

  [[nodiscard]] bool meets_object(std::size_t i) const { return !objects.empty() && objects[i]; }
  [[nodiscard]] bool meets_water(std::size_t i) const {
    return !water.empty() && water[i] != 0 && ground[i];
  }
};

// Puts the scene's objects before the hits of the ground: of the two the nearer remains. Adds to
// `counts`.
void meet_objects(const Scene& scene, std::span<const Ray> rays, RayHits& hits,
                  ObjectCounts& counts);

}  // namespace terrview
