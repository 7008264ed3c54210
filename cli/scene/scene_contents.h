// What a scene file has beyond the options of a view: solids, lamps, and the light.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cli/parse.h"
#include "cli/scene/scene_materials.h"
#include "cli/scene/scene_node.h"
#include "render/lamp.h"
#include "render/objects/solids/solid.h"

namespace terrview {

struct SceneSolid {
  std::string name;  // may be empty
  Target place;      // of its origin
  double heading_rad = 0;
  SolidPtr solid;                       // x east (turned by the heading), y north, z up
  std::vector<MaterialPlan> materials;  // of its primitives; null: none
};

struct SceneLamp {
  Target place;
  std::optional<Target> towards;  // of a spot's axis
  Lamp lamp;                      // its position, and the axis towards a place, to be filled in
};

struct SceneContents {
  std::string path;                   // of the file
  std::vector<std::string> pictures;  // the files that its textures are read from
  std::vector<SceneSolid> solids;
  std::vector<SceneLamp> lamps;
  // Instead of the daylight's.
  std::optional<glm::vec3> sun;
  std::optional<glm::vec3> ambient;
  std::optional<glm::vec3> background;
  bool display_colors = false;  // SceneColors
};

inline constexpr std::size_t kMostSolids = 100'000;
inline constexpr std::size_t kMostLamps = 1000;

// Of the root of a scene file: these members of it. Names of files are relative to `folder`. Throws
// InputError.
[[nodiscard]] const std::vector<std::string>& contents_keys();
[[nodiscard]] SceneContents read_contents(const SceneNode& root, const std::string& path,
                                          const std::string& folder);

}  // namespace terrview
