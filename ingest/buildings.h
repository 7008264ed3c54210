// Footprints and trees placed in a view frame.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ingest/footprints.h"
#include "ingest/view_frame.h"
#include "render/objects/scene_objects.h"

namespace terrview {

// The ground under a footprint from which a building's height is counted.
enum class BuildingBase { lowest, mean, highest };

struct BuildingOptions {
  BuildingBase base = BuildingBase::lowest;
  double default_height_m = 6;          // over min_height
  std::optional<glm::vec3> color = {};  // linear, of every building
  bool color_by_height = false;
};

// One feature with something to show.
struct PlacedFeature {
  std::int32_t id;
  std::string kind;  // building or tree
  int number;        // of the feature in its file
  std::string name;
  double height_m;
};

// What became of a file's features.
struct PlacedCounts {
  int features = 0;
  int placed = 0;
  int default_height = 0;  // of those placed
  int without_ground = 0;
  int without_area = 0;  // or without a polygon or point
  int upside_down = 0;   // that begin where they end, or above
};

// Objects as they are collected, with what is known of them.
struct PlacedObjects {
  Objects objects;
  std::vector<ObjectLook> looks;
  std::vector<PlacedFeature> features;
  std::int32_t next_id = 1;

  // Null if there is none.
  [[nodiscard]] std::shared_ptr<const SceneObjects> scene_objects() const;
};

// Buildings stand on `frame`'s ground as BuildingOptions says; their walls reach below it. A file
// without a coordinate reference system, and any file over a DEM without one, is in the first DEM's
// own coordinates. Footprints beside the ground are left out. The ids of a file's features follow
// each other in file order, after those given before. Throws InputError.
PlacedCounts place_buildings(const FootprintFile& file, const ViewFrame& frame,
                             const BuildingOptions& options, PlacedObjects& objects);

// Trees of 10 m, and with crowns 0.6 of their height across that begin at 0.2 of it, where their
// file does not say.
PlacedCounts place_trees(const TreeFile& file, const ViewFrame& frame, PlacedObjects& objects);

}  // namespace terrview
