// The shade trees of a scene file.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cli/scene/scene_colors.h"
#include "cli/scene/scene_node.h"
#include "cli/scene/scene_pictures.h"
#include "render/materials/shade_tree.h"
#include "render/materials/texture.h"

namespace terrview {

// What a shade of each kind may have, but for `kind`, and transform_keys() of textures.
[[nodiscard]] const std::map<std::string, std::vector<std::string>>& shade_keys();

// Whether a shade of that kind has a place in its solid.
[[nodiscard]] bool is_texture(const std::string& kind);

// Trees wait for the solid that they are on: `to_solid` takes points of the view frame to its own.
template <class Value>
using ShadePlan = std::function<std::shared_ptr<const Shade<Value>>(const glm::dmat4& to_solid)>;
using ScalarPlan = ShadePlan<double>;
using ColorPlan = ShadePlan<glm::vec3>;

// Reads the shade trees of one material. Where a number is wanted, a colour counts by its
// luminance, and where a colour is, a number is a grey. Everything throws InputError.
class ShadeReader {
 public:
  static constexpr int kMostNodes = 1000;

  // The pictures must outlive it.
  ShadeReader(const SceneColors& colors, ScenePictures& pictures)
      : colors_(colors), pictures_(pictures) {}

  [[nodiscard]] ScalarPlan scalar(const SceneNode& node);
  [[nodiscard]] ColorPlan color(const SceneNode& node);

  // Of all trees read.
  [[nodiscard]] int nodes() const { return nodes_; }
  // Whether any of them has a texture, and so depends on `to_solid`.
  [[nodiscard]] bool has_texture() const { return has_texture_; }

 private:
  void count(const SceneNode& node);
  [[nodiscard]] ScalarPlan scalar_kind(const SceneNode& node, const std::string& kind);
  [[nodiscard]] ColorPlan color_kind(const SceneNode& node, const std::string& kind);
  template <class Value, class Read>
  [[nodiscard]] ShadePlan<Value> combined(const SceneNode& node, const std::string& kind,
                                          const Read& read);
  [[nodiscard]] ScalarPlan checker_plan(const SceneNode& node);
  [[nodiscard]] ColorPlan picture_plan(const SceneNode& node);

  SceneColors colors_;
  ScenePictures& pictures_;
  int nodes_ = 0;
  bool has_texture_ = false;
};

}  // namespace terrview
