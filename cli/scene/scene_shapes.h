// The bodies of a scene file: primitives and trees of them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/scene/scene_materials.h"
#include "cli/scene/scene_node.h"
#include "render/objects/solids/solid.h"

namespace terrview {

// What a shape of each kind may have, but for `kind`, `material` and transform_keys().
[[nodiscard]] const std::map<std::string, std::vector<std::string>>& shape_keys();

struct SceneShape {
  SolidPtr solid;
  std::vector<MaterialPlan> materials;  // of its primitives, from the left; null: none is named
  int depth = 1;                        // of the tree
};

// Reads shapes. Those of the file's `shapes` go by name.
class SceneShapes {
 public:
  static constexpr int kMostPrimitives = 10'000;    // of one solid
  static constexpr int kMostInAll = 1'000'000;      // of all solids and all named shapes
  static constexpr int kMostTriangles = 4'000'000;  // of all facetted spheres
  static constexpr int kDeepest = 500;              // tree

  // The material plans and the file must outlive it. Throws InputError as read() does.
  SceneShapes(const std::optional<SceneNode>& shapes, const SceneMaterials& materials);

  // `more_keys` may be there, too. Throws InputError for sizes and trees that make no body, names
  // that are not there or lead back to themselves, and more than the above.
  [[nodiscard]] SceneShape read(const SceneNode& node, const std::vector<std::string>& more_keys);

 private:
  struct Named {
    SceneNode node;
    std::optional<SceneShape> shape = {};
    bool is_being_read = false;
  };

  void count(const SceneShape& shape, const SceneNode& node);
  [[nodiscard]] SceneShape read_at(const SceneNode& node, std::vector<std::string> keys, int depth);
  [[nodiscard]] SceneShape untransformed(const SceneNode& node, const std::string& kind, int depth);
  [[nodiscard]] SceneShape combined(const SceneNode& node, const std::string& kind, int depth);
  [[nodiscard]] SceneShape named(const SceneNode& node, int depth);
  [[nodiscard]] const SceneShape& resolved(Named& named, const SceneNode& by, int depth);
  [[nodiscard]] SolidPtr sphere(const SceneNode& node);

  const SceneMaterials& materials_;
  std::map<std::string, Named> named_;
  std::int64_t primitives_ = 0;
  std::int64_t triangles_ = 0;
};

}  // namespace terrview
