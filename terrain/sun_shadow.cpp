#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/sun_shadow.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "terrain/grid_points.h"
#include "terrain/march.h"
#include "terrain/march_set.h"
#include "terrain/occlusion.h"
#include "terrain/sun_shadow.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"
#include "terrain/vector_limits.h"
#include "terrain/view_transform.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// Looks points up in a map, lane by lane as SunMap::at() does. Where the map of the ground is
// linear it finds their places; else these are given.
void look_up(const Terrain& terrain, const SunMap& map, GridPoints& points) {
  const glm::dmat2* jacobian = terrain.layers()[0].map->linear();
  const glm::dvec2 eye_uv = terrain.layers()[0].map->to_grid({0, 0});
  const VectorFrame frame(terrain.frame());
  const SunMap::Codes& codes = map.codes();
  const V last_column = of(terrain.layers()[0].grid->columns - 2);
  const V last_row = of(terrain.layers()[0].grid->rows - 2);
  const hn::Rebind<std::int32_t, D> ints;
  const hn::Rebind<std::uint32_t, D> words;
  const V first_column = of(map.cells().first.x);
  const V first_row = of(map.cells().first.y);
  const V columns = of(map.cells().size().x);
  const V rows = of(map.cells().size().y);
  points.unknown.count = points.nowhere.count = 0;
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(D())) {
    const V x = hn::Load(D(), points.x_m.data() + i);
    const V y = hn::Load(D(), points.y_m.data() + i);
    V u;
    V v;
    if (jacobian) {
      const glm::dmat2& j = *jacobian;
      u = of(eye_uv.x) + (of(j[0][0]) * x + of(j[1][0]) * y);
      v = of(eye_uv.y) + (of(j[0][1]) * x + of(j[1][1]) * y);
    } else {
      u = hn::Load(D(), points.u.data() + i);
      v = hn::Load(D(), points.v.data() + i);
    }
    const V column = hn::Floor(u);
    const V row = hn::Floor(v);
    const V in_column = u - column;
    const V in_row = v - row;
    const V least = hn::Min(in_column, in_row);
    const V most = hn::Max(in_column, in_row);
    M sure = hn::And(least > of(SunMap::kBorder), most < of(1 - SunMap::kBorder));
    const V z = hn::Load(D(), points.z_m.data() + i);
    const V height = frame.height(x, y, z, frame.curvature(x, y));
    sure = hn::And(sure, height >= of(codes.low));
    const V place_u = column - first_column;
    const V place_v = row - first_row;
    const M among =
        hn::And(hn::Min(place_u, place_v) >= of(0), hn::And(place_u < columns, place_v < rows));
    const M has_word = hn::And(sure, among);
    const V index = place_u + place_v * columns;
    const auto word = hn::BitCast(
        words, hn::GatherIndex(ints, reinterpret_cast<const std::int32_t*>(map.words()),
                               hn::DemoteTo(ints, hn::IfThenElseZero(has_word, index))));
    const V free_above =
        of(SunMap::Codes::kMost) -
        hn::PromoteTo(D(), hn::BitCast(ints, hn::And(word, hn::Set(words, SunMap::Codes::kMost))));
    const V stopped_below = hn::PromoteTo(D(), hn::BitCast(ints, hn::ShiftRight<16>(word)));

    const V share = of(codes.share0) + of(codes.share_per_column) * in_column +
                    of(codes.share_per_row) * in_row;
    const V least_code =
        (height + share * of(codes.rise_least) - of(codes.low)) * of(codes.per_height);
    const V most_code =
        (height + share * of(codes.rise_most) - of(codes.low)) * of(codes.per_height);
    const M above = hn::And(least_code > free_above + of(SunMap::Codes::kRounding),
                            free_above < of(SunMap::Codes::kMost));
    const M lit = hn::Or(above, free_above == of(0));
    const M below = most_code < stopped_below - of(SunMap::Codes::kRounding);
    const V known = hn::IfThenElseZero(below, of(1));
    const hn::Rebind<std::uint8_t, D> bytes;
    hn::StoreU(hn::DemoteTo(bytes, hn::DemoteTo(ints, hn::IfThenZeroElse(lit, known))), bytes,
               points.shaded.data() + i);
    const std::uint32_t decided = bits_of(hn::And(has_word, hn::Or(lit, below)));
    std::uint32_t others = ~decided & lanes_below(points.count, i);
    const M over_grid =
        hn::And(hn::Min(column, row) >= of(0), hn::And(column <= last_column, row <= last_row));
    const std::uint32_t sure_bits = others == 0 ? 0 : bits_of(hn::And(sure, over_grid));
    for (; others != 0; others &= others - 1) {
      const auto lane = static_cast<std::uint32_t>(__builtin_ctz(others));
      auto& list = (sure_bits >> lane & 1) != 0 ? points.unknown : points.nowhere;
      list.add(i + lane);
    }
    hn::Store(height, D(), points.height.data() + i);
    hn::Store(in_column, D(), points.u.data() + i);
    hn::Store(in_row, D(), points.v.data() + i);
    hn::Store(hn::DemoteTo(ints, column), ints, points.column.data() + i);
    hn::Store(hn::DemoteTo(ints, row), ints, points.row.data() + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(look_up);

namespace {

// Points a few at a time; what the map does not know of them, together.
class Shading {
 public:
  Shading(const Terrain& terrain, const SunMap& map, std::span<const glm::dvec3> points_m,
          std::span<std::uint8_t> shaded, TraceCounts& counts)
      : terrain_(terrain),
        map_(map),
        points_m_(points_m),
        shaded_(shaded),
        counts_(counts),
        is_parallel_(terrain.frame().is_flat() && terrain.layers()[0].map->linear()),
        can_march_(within_vector_limits(terrain) && terrain.layers()[0].ceilings) {
    if (is_parallel_ && can_march_) aim();
  }

  void run() {
    for (std::size_t first = 0; first < points_m_.size(); first += GridPoints::kMost) {
      take(first);
      HWY_DYNAMIC_DISPATCH(look_up)(terrain_, map_, points_);
      std::copy_n(points_.shaded.begin(), points_.count,
                  shaded_.begin() + static_cast<std::ptrdiff_t>(first));
      for (const std::int32_t i : points_.nowhere.indices())
        ask(first + static_cast<std::size_t>(i));
      for (const std::int32_t i : points_.unknown.indices())
        find_out(first, static_cast<std::size_t>(i));
    }
    march_waiting();
    trace_apart();
  }

 private:
  void take(std::size_t first) {
    points_.count = std::min(GridPoints::kMost, points_m_.size() - first);
    for (std::size_t i = 0; i < points_.count; ++i) {
      const glm::dvec3& point_m = points_m_[first + i];
      points_.x_m[i] = point_m.x;
      points_.y_m[i] = point_m.y;
      points_.z_m[i] = point_m.z;
    }
    const GroundMap& ground = *terrain_.layers()[0].map;
    const auto all = [this](auto& values) { return std::span(values.data(), points_.count); };
    if (!ground.linear())
      ground.places({all(points_.x_m), all(points_.y_m)}, {all(points_.u), all(points_.v)});
  }

  // What parallel rays share.
  void aim() {
    const glm::dvec3 to_sun = map_.to_sun();
    const glm::dvec2 line = glm::dvec2(to_sun) / glm::length(glm::dvec2(to_sun));
    const glm::dvec2 rate = *terrain_.layers()[0].map->linear() * line;
    const double rise = to_sun.z / glm::length(glm::dvec2(to_sun)) / terrain_.frame().z_scale;
    climb_ = rise / std::max(std::abs(rate.x), std::abs(rate.y));
    const auto metres = [](double posts_per_m) {
      const double inverse = 1 / posts_per_m;
      return static_cast<float>(std::isfinite(inverse) ? inverse : 0);
    };
    set_.rate_u.fill(static_cast<float>(rate.x));
    set_.rate_v.fill(static_cast<float>(rate.y));
    set_.metres_u.fill(metres(rate.x));
    set_.metres_v.fill(metres(rate.y));
    set_.rise.fill(static_cast<float>(rise));
    set_.bend.fill(0);
    set_.end.fill(std::numeric_limits<float>::infinity());
    set_.g.fill(0);
  }

  void find_out(std::size_t first, std::size_t i) {
    if (!is_parallel_)
      apart_.push_back(first + i);
    else if (can_march_)
      wait(first + i, i);
    else
      ask(first + i);
  }

  [[nodiscard]] Ray ray_from(std::size_t point) const {
    return {points_m_[point], direction_at(terrain_.frame(), points_m_[point], map_.to_sun())};
  }

  void ask(std::size_t point) {
    shaded_[point] = terrain_.occluded(ray_from(point), &counts_) ? 1 : 0;
  }

  void wait(std::size_t point, std::size_t i) {
    if (set_.count == MarchSet::kMost) march_waiting();
    const std::size_t slot = set_.count++;
    const double height = points_.height[i];
    waiting_[slot] = point;
    set_.index[slot] = static_cast<std::int32_t>(slot);
    set_.column[slot] = set_.column0[slot] = points_.column[i];
    set_.row[slot] = set_.row0[slot] = points_.row[i];
    set_.u[slot] = static_cast<float>(points_.u[i]);
    set_.v[slot] = static_cast<float>(points_.v[i]);
    set_.height[slot] = static_cast<float>(height);
    set_.slack[slot] = static_cast<float>(0x1p-20 * (std::abs(height) + climb_));
    set_.g[slot] = 0;
  }

  void march_waiting() {
    const std::size_t count = set_.count;
    if (count == 0) return;
    fates_.fill(March::on_its_way);
    march(terrain_, &map_, set_, fates_, counts_);
    for (std::size_t slot = 0; slot < count; ++slot) {
      if (fates_[slot] == March::undecided)
        ask(waiting_[slot]);
      else
        shaded_[waiting_[slot]] = fates_[slot] == March::stopped ? 1 : 0;
    }
    set_.count = 0;
  }

  void trace_apart() {
    std::vector<glm::dvec3> from_m;
    from_m.reserve(apart_.size());
    for (const std::size_t point : apart_) from_m.push_back(points_m_[point]);
    std::vector<glm::dvec3> directions(from_m.size());
    directions_at(terrain_.frame(), from_m, map_.to_sun(), directions);
    std::vector<Ray> rays;
    rays.reserve(from_m.size());
    for (std::size_t i = 0; i < from_m.size(); ++i) rays.push_back({from_m[i], directions[i]});
    std::vector<std::uint8_t> stopped(rays.size());
    occluded(terrain_, rays, stopped, counts_, &map_);
    for (std::size_t i = 0; i < apart_.size(); ++i) shaded_[apart_[i]] = stopped[i];
  }

  const Terrain& terrain_;
  const SunMap& map_;
  std::span<const glm::dvec3> points_m_;
  std::span<std::uint8_t> shaded_;
  TraceCounts& counts_;
  bool is_parallel_;  // rays, all in one direction, over a map that is linear
  bool can_march_;
  double climb_ = 0;  // over a post
  GridPoints points_;
  // Rays that wait to march, if parallel, or to be traced, if not.
  MarchSet set_;
  std::array<std::size_t, MarchSet::kMost> waiting_;
  Fates fates_;
  std::vector<std::size_t> apart_;
};

}  // namespace

void shaded(const Terrain& terrain, const SunMap& map, std::span<const glm::dvec3> points_m,
            std::span<std::uint8_t> shaded, TraceCounts& counts) {
  if (within_series_limit(terrain)) {
    Shading(terrain, map, points_m, shaded, counts).run();
    return;
  }
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    const Ray ray{points_m[i], direction_at(terrain.frame(), points_m[i], map.to_sun())};
    shaded[i] = terrain.occluded(ray, &counts) ? 1 : 0;
  }
}

}  // namespace terrview
#endif
