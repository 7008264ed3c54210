// The objects of a scene and what they look like.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "render/objects/object_set.h"

namespace terrview {

struct ObjectLook {
  std::int32_t id = 1;  // above 0; several objects may be one thing
  // Linear: the second is that of part 1 (roofs, trunks).
  glm::vec3 color{0.6F};
  glm::vec3 roof_color{0.6F};
};

struct SceneObjects {
  std::shared_ptr<const ObjectSet> set;
  std::vector<ObjectLook> looks;  // one for each object of the set
  // Walls stand on every edge of the ground: no ray comes below it without meeting one.
  bool walls_in_ground = false;
};

}  // namespace terrview
