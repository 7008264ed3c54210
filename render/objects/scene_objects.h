// The objects of a scene and what they look like.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "render/objects/object_set.h"

namespace terrview {

struct Material;

struct ObjectLook {
  std::int32_t id = 1;  // above 0; several objects may be one thing
  // Linear: the second is that of part 1 (roofs, trunks).
  glm::vec3 color{0.6F};
  glm::vec3 roof_color{0.6F};
  // By SurfaceHit::part, the last one for all further parts. Null or empty: the colours above.
  std::vector<std::shared_ptr<const Material>> materials = {};
};

// Null: the look's colours.
[[nodiscard]] inline const Material* material_of(const ObjectLook& look, int part) {
  if (look.materials.empty()) return nullptr;
  return look.materials[std::min(static_cast<std::size_t>(part), look.materials.size() - 1)].get();
}

struct SceneObjects {
  std::shared_ptr<const ObjectSet> set;
  std::vector<ObjectLook> looks;  // one for each object of the set
  // Those that cast shadows; none: all of the set.
  std::shared_ptr<const ObjectSet> casters = {};
  // Walls stand on every edge of the ground: no ray comes below it without meeting one.
  bool walls_in_ground = false;
};

}  // namespace terrview
