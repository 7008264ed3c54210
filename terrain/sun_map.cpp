#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/sun_map.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include <glm/common.hpp>

#include "terrain/sun_map.h"
#include "terrain/sun_sweep-inl.h"
#include "terrain/sun_sweep.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

void sweep_strips(const SunSweep& sweep, int first_strip) {
  const auto strips = std::make_unique<StripSweep>(sweep, first_strip);
  strips->run();
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(sweep_strips);

namespace {

// Of all numbers from which heights along rays come: more than their rounding, and more than that
// of a ray's clearance in double precision.
constexpr double kSlack = 0x1p-20;

bool is_inside(glm::dvec2 in_cell, double border) {
  return std::min(in_cell.x, in_cell.y) > border && std::max(in_cell.x, in_cell.y) < 1 - border;
}

// The strips over a grid, from the first to before the last.
struct StripSpan {
  int first, end;
};
StripSpan strips_over(const SunField& field) {
  StripSpan span{0, field.posts()};
  for (const int start : {0, field.posts()}) {
    StripTrack track(field, start);
    for (int line = 0; line < field.lines(); line += kSunPanelLines) {
      const int last = std::min(line + kSunPanelLines, field.lines());
      const int moved = std::max(start - track.x(line), start - track.x(last));
      const int back = std::min(start - track.x(line), start - track.x(last));
      span.end = std::max(span.end, field.posts() + moved + 1);
      span.first = std::min(span.first, back - 1);
      track.next_panel();
    }
  }
  return span;
}

}  // namespace

std::unique_ptr<const SunMap> SunMap::make(const Terrain& terrain, const glm::dvec3& to_sun,
                                           double lift_m, const ForEach& for_each) {
  if (terrain.layers().size() != 1 || terrain.model() == SurfaceModel::band ||
      !(terrain.frame().z_scale > 0))
    return nullptr;
  const HeightGrid& grid = *terrain.layers()[0].grid;
  if (static_cast<double>(grid.columns) * grid.rows >= 0x1p30) return nullptr;
  const SunField field(terrain, to_sun);
  if (!field.is_regular()) return nullptr;
  std::unique_ptr<SunMap> map(new SunMap(field, to_sun));
  map->sweep(terrain, field, lift_m, for_each);
  return map;
}

SunMap::SunMap(const SunField& field, const glm::dvec3& to_sun)
    : to_sun_(to_sun), hit_error_(field.track_error()) {
  const int cells_x = field.posts() - 1;
  const int cells_y = field.lines() - 1;
  cells_ = field.over_rows() ? glm::ivec2(cells_x, cells_y) : glm::ivec2(cells_y, cells_x);
  const int step = field.from_last() ? -cells_x : cells_x;
  place_.first = field.from_last() ? (cells_y - 1) * cells_x : 0;
  place_.per_column = field.over_rows() ? 1 : step;
  place_.per_row = field.over_rows() ? step : 1;
  const std::size_t cells = static_cast<std::size_t>(cells_x) * static_cast<std::size_t>(cells_y);
  size_words_ = (cells + sizeof(std::uint32_t) - 1) / sizeof(std::uint32_t);
  words_ = std::make_unique<std::uint32_t[]>(size_words_);
}

Sunlight SunMap::at(glm::dvec2 uv) const {
  const glm::dvec2 cell = glm::floor(uv);
  const bool over_grid = cell.x >= 0 && cell.y >= 0 && cell.x < cells_.x && cell.y < cells_.y;
  return over_grid && is_inside(uv - cell, kBorder) ? at(glm::ivec2(cell)) : Sunlight::unknown;
}

Sunlight SunMap::at(const Terrain& terrain, const Hit& hit) const {
  if (is_inside(hit.uv - glm::dvec2(hit.cell), kBorder + hit_error_)) return at(hit.cell);
  if (hit_error_ == 0) return Sunlight::unknown;
  const Sunlight light = at(terrain.layers()[0].map->to_grid(glm::dvec2(hit.position_m)));
  // The hit may lie as high as the ground of the other cell.
  return light == Sunlight::shaded && at(hit.cell) != light ? Sunlight::unknown : light;
}

void SunMap::sweep(const Terrain& terrain, const SunField& field, double lift_m,
                   const ForEach& for_each) {
  const double scale = terrain.frame().z_scale;
  const double rise = field.rates({0, 0}, {field.posts(), field.lines()}).rise_most;
  const double slack = kSlack * (terrain.height_bound_m() / scale + rise * field.lines());
  const SunSweep sweep{*terrain.layers()[0].grid, field, slack, lift_m / scale,
                       reinterpret_cast<std::uint8_t*>(words_.get())};
  const StripSpan strips = strips_over(field);
  for_each((strips.end - strips.first + kSunStrips - 1) / kSunStrips, [&](int part) {
    HWY_DYNAMIC_DISPATCH(sweep_strips)(sweep, strips.first + part * kSunStrips);
  });
}

}  // namespace terrview
#endif
