#include "sky/cloud_shadows.h"

#include <algorithm>
#include <cmath>

#include "sky/field_cell.h"

namespace terrview {
namespace {

constexpr double kFinest_m = 50;

FieldOptions coarse(FieldOptions field, double cell_m) {
  const int enough = static_cast<int>(std::ceil(std::log2(std::max(1.0, cell_m / kFinest_m))));
  field.levels = glm::ivec2(std::min(field.levels.x, enough));
  return field;
}

template <FieldKind kKind>
float value_at(const RandomField& field, const glm::dvec2& place) {
  CellPlace at{0, static_cast<std::int64_t>(std::floor(place.x)),
               static_cast<std::int64_t>(std::floor(place.y))};
  auto cell = FieldCell<kKind>::root(field, at);
  glm::dvec2 share = place - glm::dvec2(at.column, at.row);
  while (at.level < field.levels()) {
    const int k = (share.x >= 0.5 ? 1 : 0) + (share.y >= 0.5 ? 2 : 0);
    cell = cell.divided(field, at)[static_cast<std::size_t>(k)];
    at = at.child(k);
    share = 2.0 * share - glm::dvec2(k & 1, k >> 1);
  }
  const auto corner = cell.corners();
  const auto s = static_cast<float>(share.x);
  const auto t = static_cast<float>(share.y);
  const float south = corner[0] + s * (corner[1] - corner[0]);
  const float north = corner[2] + s * (corner[3] - corner[2]);
  return south + t * (north - south);
}

float value_at(const RandomField& field, const glm::dvec2& place) {
  switch (field.options().kind) {
    case FieldKind::midpoint:
      return value_at<FieldKind::midpoint>(field, place);
    case FieldKind::displaced:
      return value_at<FieldKind::displaced>(field, place);
    case FieldKind::smooth:
      break;
  }
  return value_at<FieldKind::smooth>(field, place);
}

}  // namespace

CloudShadows::CloudShadows(const Clouds& clouds, const glm::dvec3& towards_sun)
    : layer_(clouds.layer),
      table_(clouds.table),
      towards_sun_(towards_sun),
      field_(coarse(clouds.field, clouds.layer.cell_m)),
      addresses_per_unit_(clouds.table.window.width /
                          RandomField(clouds.field).expected_deviation()) {
  towards_sun_.z = std::max(towards_sun_.z, std::sin(kLowest_rad));
}

float CloudShadows::share(const glm::dvec3& point_m) const {
  // The shell over the point is flat as far as its shadow reaches.
  const glm::dvec3 above_m = layer_.point_m(layer_.field_place(glm::dvec2(point_m)));
  const double rise_m = above_m.z - point_m.z;
  if (rise_m <= 0) return 1;
  const glm::dvec3 met_m = point_m + towards_sun_ * (rise_m / towards_sun_.z);
  const float value = value_at(field_, layer_.field_place(glm::dvec2(met_m)));
  const double cover =
      table_.cover(table_.window.middle + addresses_per_unit_ * static_cast<double>(value));
  return std::lerp(1.0F, kDarkest, static_cast<float>(cover));
}

}  // namespace terrview
