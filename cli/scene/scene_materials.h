// The materials of a scene file.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cli/scene/scene_colors.h"
#include "cli/scene/scene_node.h"
#include "cli/scene/scene_pictures.h"
#include "render/materials/material.h"

namespace terrview {

// A material, made when it is known where the solid that it is on stands.
struct SceneMaterial {
  std::function<Material(const glm::dmat4& to_solid)> make;
  int nodes = 0;             // of its shade trees
  bool has_texture = false;  // none: one makes do for all solids
};

using MaterialPlan = std::shared_ptr<const SceneMaterial>;

// What a material may have; one of glass has `glass` alone.
[[nodiscard]] const std::vector<std::string>& material_keys();

class SceneMaterials {
 public:
  // Reads the file's `materials`. The pictures must outlive it. Throws InputError.
  SceneMaterials(const std::optional<SceneNode>& materials, const SceneColors& colors,
                 ScenePictures& pictures);

  // A material's name, or the material itself. Throws InputError.
  [[nodiscard]] MaterialPlan read(const SceneNode& node) const;

 private:
  [[nodiscard]] MaterialPlan read_material(const SceneNode& node) const;

  SceneColors colors_;
  ScenePictures& pictures_;
  std::map<std::string, MaterialPlan> named_;
};

}  // namespace terrview
