// Footprints of buildings, and trees, from vector files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "ingest/vector_file.h"
#include "render/objects/polygon.h"
#include "render/objects/roof.h"

namespace terrview {

struct FootprintOptions {
  std::string height_field;  // empty = those that are known
  std::string color_field;
};

// One feature. Its coordinates are those of the file, x to the east.
struct Footprint {
  int number = 0;  // in file order, from 1
  std::string name;
  std::vector<std::vector<Polygon::Ring>> polygons;  // the outline first
  std::optional<double> height_m;                    // with the roof; none: the file does not say
  double min_height_m = 0;                           // of the lowest part over the ground
  std::optional<double> roof_height_m;
  RoofShape roof = RoofShape::flat;
  std::optional<double> roof_azimuth_deg;  // the way down
  bool ridge_across = false;
  std::optional<glm::vec3> color;  // linear
  std::optional<glm::vec3> roof_color;
};

struct FootprintFile {
  VectorFile file;
  std::vector<Footprint> footprints;  // of every feature that has a polygon
  int without_polygon = 0;            // features
  int unread_heights = 0;             // attributes that are no height
  int unknown_roofs = 0;              // made flat
};

// Throws InputError.
[[nodiscard]] FootprintFile read_footprints(const std::string& path,
                                            const FootprintOptions& options);

struct Tree {
  int number = 0;
  std::string name;
  glm::dvec2 place{0, 0};
  std::optional<double> height_m;
  std::optional<double> crown_m;  // across
  std::optional<double> trunk_m;  // around; 0 = none
  double min_height_m = 0;        // where the crown begins
  std::optional<glm::vec3> color;
};

struct TreeFile {
  VectorFile file;
  std::vector<Tree> trees;  // of every point
  int without_point = 0;
  int unread_heights = 0;
};

// Throws InputError.
[[nodiscard]] TreeFile read_trees(const std::string& path);

}  // namespace terrview
