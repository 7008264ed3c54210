#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/sun_map.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>

#include <glm/common.hpp>

#include "terrain/huge_pages.h"
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

SunPart part_of(const SunField& field, const CellRect& cells) {
  const auto turned = [&](glm::ivec2 cell) {
    if (!field.over_rows()) std::swap(cell.x, cell.y);
    if (field.from_last()) cell.y = field.lines() - 2 - cell.y;
    return cell;
  };
  const glm::ivec2 a = turned(cells.first);
  const glm::ivec2 b = turned(cells.last);
  return {glm::min(a, b), glm::max(a, b)};
}

// Whether the strips from `first` on come over `part`.
bool reaches(const SunField& field, int first, const SunPart& part) {
  StripTrack track(field, first);
  bool reaches = false;
  for (int line = 0; line <= part.last.y; line += kSunPanelLines) {
    const int x = std::min(track.x(line), track.x(line + kSunPanelLines));
    const int end = std::max(track.x(line), track.x(line + kSunPanelLines)) + kSunStrips + kSunHalo;
    reaches |= line + kSunPanelLines > part.first.y && x <= part.last.x && end >= part.first.x;
    track.next_panel();
  }
  return reaches;
}

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
      for (const int edge : {line, std::min(line + kSunPanelLines, field.lines())}) {
        span.first = std::min(span.first, start - track.x(edge) - 1);
        span.end = std::max(span.end, field.posts() + start - track.x(edge) + 1);
      }
      track.next_panel();
    }
  }
  return span;
}

// Rays that a cell's heights do not tell of march on over those around it.
constexpr int kAround = 32;

CellRect cells_to_know(const HeightGrid& grid, const CellRect& wanted) {
  const glm::ivec2 last_cell(grid.columns - 2, grid.rows - 2);
  const auto nearest = [&](glm::ivec2 cell) { return glm::clamp(cell, glm::ivec2(0), last_cell); };
  return {nearest(nearest(wanted.first) - kAround),
          nearest(nearest(glm::max(wanted.first, wanted.last)) + kAround)};
}

}  // namespace

std::unique_ptr<const SunMap> SunMap::make(const Terrain& terrain, const glm::dvec3& to_sun,
                                           const ForEach& for_each, const CellRect& wanted) {
  if (terrain.layers().size() != 1 || terrain.model() == SurfaceModel::band ||
      !(terrain.frame().z_scale > 0))
    return nullptr;
  const HeightGrid& grid = *terrain.layers()[0].grid;
  if (static_cast<double>(grid.columns) * grid.rows >= 0x1p30) return nullptr;
  const SunField field(terrain, to_sun);
  if (!field.is_regular()) return nullptr;
  const CellRect cells = cells_to_know(grid, wanted);
  std::unique_ptr<SunMap> map(new SunMap(terrain, field, to_sun, cells));
  map->sweep(terrain, field, for_each);
  return map;
}

SunMap::SunMap(const Terrain& terrain, const SunField& field, const glm::dvec3& to_sun,
               const CellRect& cells)
    : to_sun_(to_sun), cells_(cells), hit_error_(field.track_error()) {
  const SunRates rates = field.rates({0, 0}, {field.posts(), field.lines()});
  codes_.rise_least = rates.rise_least;
  codes_.rise_most = rates.rise_most;
  const glm::dvec2 range = terrain.height_range_m() / terrain.frame().z_scale;
  codes_.low = range.x;
  codes_.per_height = (Codes::kMost - 2) / (range.y - range.x + rates.rise_most);
  codes_.over_rows = field.over_rows();
  codes_.share0 = field.from_last() ? 1 : 0;
  const double share = field.from_last() ? -1 : 1;
  (field.over_rows() ? codes_.share_per_row : codes_.share_per_column) = share;
  words_.reset(static_cast<std::uint32_t*>(std::calloc(bytes(), 1)));
  if (!words_) throw std::bad_alloc();
  prefer_huge_pages(words_.get(), bytes());
}

void SunMap::sweep(const Terrain& terrain, const SunField& field, const ForEach& for_each) {
  const double scale = terrain.frame().z_scale;
  const double slack =
      kSlack * (terrain.height_bound_m() / scale + codes_.rise_most * field.lines());
  const glm::dvec2 range = terrain.height_range_m() / scale;
  const SunPart part = part_of(field, cells_);
  // Ground further towards the sun is lower than all rays from there.
  const double over_all = 1.001 * (range.y - range.x) + 8 * slack + 2 * field.blur();
  const double lead = std::ceil(over_all / codes_.rise_least) + 2;
  const SunSweep sweep{.grid = *terrain.layers()[0].grid,
                       .field = field,
                       .slack = slack,
                       .low = codes_.low,
                       .per_height = codes_.per_height,
                       .highest = range.y,
                       .first_line = static_cast<int>(std::max(0.0, part.first.y - lead)),
                       .part = part,
                       .words = words_.get(),
                       .first_cell = cells_.first,
                       .words_a_row = cells_.size().x};
  const StripSpan strips = strips_over(field);
  for_each((strips.end - strips.first + kSunStrips - 1) / kSunStrips, [&](int i) {
    const int first = strips.first + i * kSunStrips;
    if (reaches(field, first, part)) HWY_DYNAMIC_DISPATCH(sweep_strips)(sweep, first);
  });
}

Sunlight SunMap::at(glm::dvec2 uv, double height) const {
  const glm::dvec2 cell = glm::floor(uv);
  const glm::dvec2 in_cell = uv - cell;
  if (!cells_.holds(cell) || !is_inside(in_cell, kBorder) || height < codes_.low)
    return Sunlight::unknown;
  const std::uint32_t codes = word(glm::ivec2(cell));
  const std::uint32_t free_above = Codes::free_above(codes);
  const double share =
      codes_.share0 + codes_.share_per_column * in_cell.x + codes_.share_per_row * in_cell.y;
  const auto code = [&](double z) { return (z - codes_.low) * codes_.per_height; };
  if (free_above == 0 || (free_above != Codes::kMost &&
                          code(height + share * codes_.rise_least) > free_above + Codes::kRounding))
    return Sunlight::lit;
  return code(height + share * codes_.rise_most) < Codes::stopped_below(codes) - Codes::kRounding
             ? Sunlight::shaded
             : Sunlight::unknown;
}

bool SunMap::lights(const Hit& hit) const {
  return cells_.holds(hit.cell) && is_inside(hit.uv - glm::dvec2(hit.cell), kBorder + hit_error_) &&
         Codes::free_above(word(hit.cell)) == 0;
}

}  // namespace terrview
#endif
