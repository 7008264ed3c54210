#include "sky/flat_sky.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>

#include "sky/field_part.h"

namespace terrview {
namespace {

// As many divisions as leave an edge of at least one pixel, and one more.
int visible_levels(int levels, double pixels_per_cell) {
  const int visible = static_cast<int>(std::ceil(std::log2(std::max(1.0, pixels_per_cell))));
  return std::min(levels, visible);
}

FieldOptions visible_field(const FlatSkyOptions& options) {
  FieldOptions field = options.field;
  const glm::dvec2 cell_px = glm::dvec2(options.size_px) / options.cells;
  field.levels = {visible_levels(field.levels.x, cell_px.x),
                  visible_levels(field.levels.y, cell_px.y)};
  return field;
}

std::int64_t floor_index(double x) { return static_cast<std::int64_t>(std::floor(x)); }

}  // namespace

FlatSky::FlatSky(FlatSkyOptions options)
    : options_(std::move(options)),
      field_(visible_field(options_)),
      colors_(options_.table),
      addresses_per_unit_(static_cast<float>(options_.table.window.width /
                                             RandomField(options_.field).expected_deviation())) {}

glm::ivec2 FlatSky::tiles() const { return (options_.size_px + (kTile_px - 1)) / kTile_px; }

glm::dvec2 FlatSky::lattice_place(int column_px, int row_px) const {
  const glm::dvec2 size(options_.size_px);
  const glm::dvec2 share((column_px + 0.5) / size.x, (size.y - row_px - 0.5) / size.y);
  const glm::ivec2 levels = field_.options().levels;
  const glm::dvec2 root = (options_.origin + share) * options_.cells;
  return {std::ldexp(root.x, levels.x), std::ldexp(root.y, levels.y)};
}

void FlatSky::paint(const glm::ivec2& tile, Image& image) const {
  const glm::ivec2 first = tile * kTile_px;
  const glm::ivec2 end = glm::min(first + kTile_px, options_.size_px);
  const glm::dvec2 north_west = lattice_place(first.x, first.y);
  const glm::dvec2 south_east = lattice_place(end.x - 1, end.y - 1);
  LatticeRectangle part{floor_index(north_west.x), floor_index(south_east.y), 0, 0};
  part.columns = floor_index(south_east.x) + 2 - part.column;
  part.rows = floor_index(north_west.y) + 2 - part.row;
  const std::vector<float> values = field_part(field_, part);

  const auto noise = static_cast<float>(options_.table.noise);
  const KeyedRandom white(options_.field.seed ^ 0x77686974U, Law::gaussian);
  const auto middle = static_cast<float>(options_.table.window.middle);
  for (int row = first.y; row < end.y; ++row) {
    const std::uint64_t noise_key = white.row_key(0, row);
    for (int column = first.x; column < end.x; ++column) {
      const glm::dvec2 place = lattice_place(column, row);
      const std::int64_t i = floor_index(place.x);
      const std::int64_t j = floor_index(place.y);
      const auto s = static_cast<float>(place.x - static_cast<double>(i));
      const auto t = static_cast<float>(place.y - static_cast<double>(j));
      const float* south =
          &values[static_cast<std::size_t>((j - part.row) * part.columns + (i - part.column))];
      const float* north = south + part.columns;
      const float below = south[0] + s * (south[1] - south[0]);
      const float above = north[0] + s * (north[1] - north[0]);
      float address = middle + addresses_per_unit_ * (below + t * (above - below));
      if (noise > 0) address += noise * white.first(KeyedRandom::bits(noise_key, column));
      image.at(column, row) = colors_.at(address);
    }
  }
}

}  // namespace terrview
