#include "cli/impact/picture_change.h"

#include "render/color_ramp.h"

namespace terrview {
namespace {

bool same_bytes(const glm::vec3& a, const glm::vec3& b) {
  if (a == b) return true;
  return to_srgb8(a.x) == to_srgb8(b.x) && to_srgb8(a.y) == to_srgb8(b.y) &&
         to_srgb8(a.z) == to_srgb8(b.z);
}

int horizon_row(const Raster<PixelSample>& samples, int column) {
  int row = 0;
  while (row < samples.height_px() && samples.at(column, row).object_id == PixelSample::kNothing)
    ++row;
  return row;
}

void compare_horizons(const Raster<PixelSample>& without, const Raster<PixelSample>& with,
                      PictureChange& change) {
  const auto is_shown = [&](int row) { return row > 0 && row < without.height_px(); };
  for (int column = 0; column < without.width_px(); ++column) {
    const int before_row = horizon_row(without, column);
    const int after_row = horizon_row(with, column);
    if (!is_shown(before_row) && !is_shown(after_row)) continue;
    ++change.horizon_columns;
    if (before_row != after_row) ++change.changed_columns;
  }
}

}  // namespace

PictureChange picture_change(const Frame& without, const Frame& with, std::int32_t before,
                             std::int32_t last) {
  const glm::vec3 project(1);
  const glm::vec3 other = from_srgb8(128, 128, 128);
  PictureChange change{.mask = Image(with.image.width_px(), with.image.height_px())};
  for (int row = 0; row < with.image.height_px(); ++row) {
    for (int column = 0; column < with.image.width_px(); ++column) {
      const std::int32_t id = with.samples.at(column, row).object_id;
      const bool shows_project = id > before && id <= last;
      if (shows_project) ++change.building_px[id];
      if (same_bytes(without.image.at(column, row), with.image.at(column, row))) continue;
      ++change.changed_px;
      change.mask.at(column, row) = shows_project ? project : other;
    }
  }
  compare_horizons(without.samples, with.samples, change);
  return change;
}

}  // namespace terrview
