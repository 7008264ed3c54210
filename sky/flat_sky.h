// A random field seen face on, coloured by a table: skies, wood, marble.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "render/image.h"
#include "sky/color_table.h"
#include "sky/random_field.h"

namespace terrview {

struct FlatSkyOptions {
  FieldOptions field;
  ColorTable table;
  glm::ivec2 size_px{1280, 720};
  // Root cells across the picture, and how many pictures it lies east and north of the field's
  // origin: pictures side by side continue each other.
  glm::dvec2 cells{1, 1};
  glm::dvec2 origin{0, 0};
};

// Pixels at the middle get the field's value there, bilinear between vertices, and the table's
// colour for it. Divisions stop when an edge is under one pixel.
class FlatSky {
 public:
  explicit FlatSky(FlatSkyOptions options);

  [[nodiscard]] glm::ivec2 tiles() const;
  // Paints one tile of the picture; any order, any thread.
  void paint(const glm::ivec2& tile, Image& image) const;

 private:
  static constexpr int kTile_px = 128;

  [[nodiscard]] glm::dvec2 lattice_place(int column_px, int row_px) const;

  FlatSkyOptions options_;
  RandomField field_;
  BakedTable colors_;
  float addresses_per_unit_;
};

}  // namespace terrview
