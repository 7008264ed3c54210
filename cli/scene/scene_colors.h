// What the colours of a scene file mean.
#pragma once

#include <glm/vec3.hpp>

#include "cli/scene/scene_node.h"
#include "render/color_ramp.h"

namespace terrview {

// [R, G, B] from 0 to 255. Linear light of sRGB colours; or, where light is added up in the numbers
// of the picture, those numbers themselves.
struct SceneColors {
  bool are_display = false;

  [[nodiscard]] glm::vec3 read(const SceneNode& node) const {
    const glm::vec3 rgb = node.vector({0, 255, "a colour as [180, 200, 220], from 0 to 255"});
    return are_display ? rgb / 255.0F : from_srgb8(rgb.r, rgb.g, rgb.b);
  }
};

}  // namespace terrview
