#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/occlusion.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "terrain/march.h"
#include "terrain/march_lines-inl.h"
#include "terrain/march_lines.h"
#include "terrain/march_set.h"
#include "terrain/march_tracks.h"
#include "terrain/occlusion.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"
#include "terrain/vector_limits.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// Lines of doubles to sets of floats, eight at a time.
class MarchStart : LineLanes {
 public:
  MarchStart(const Terrain& terrain, MarchLines& lines, MarchSet& set)
      : LineLanes(lines),
        terrain_(terrain),
        frame_(terrain.frame()),
        posts_(*terrain.layers()[0].grid),
        bend_(bend_of(terrain)),
        set_(set) {}

  void run() {
    for (std::size_t i = 0; i < lines_.count; i += hn::Lanes(D())) {
      put_in_cell(i);
      rise(i);
    }
  }

  // Lanes that begin below the ground, as the single ray finds it; the others begin at the
  // beginning of their line.
  void check_starts(Fates& fates) const {
    for (std::size_t i = 0; i < lines_.count; i += hn::Lanes(D())) {
      const V clearance = start_clearance(i);
      const std::uint32_t lanes = lanes_from(i);
      mark(i, bits_of(clearance < of(0)) & lanes, March::stopped, fates);
      mark(i, ~bits_of(clearance == clearance) & lanes, March::undecided, fates);
      mark(i, bits_of(hn::Or(turns_over(i), at_far_border(i))) & lanes, March::undecided, fates);
    }
  }

 private:
  VEC_INLINE void put(MarchSet::Floats& values, std::size_t first, V value) const {
    const hn::Rebind<float, D> floats;
    hn::Store(hn::DemoteTo(floats, value), floats, values.data() + first);
  }
  VEC_INLINE void put(MarchSet::Ints& values, std::size_t first, V value) const {
    const hn::Rebind<std::int32_t, D> ints;
    hn::Store(hn::DemoteTo(ints, value), ints, values.data() + first);
  }

  VEC_INLINE V cell(V uv, int posts) const {
    return hn::Max(of(0), hn::Min(hn::Floor(uv), of(posts - 2)));
  }

  // Whether a line rises or falls by so much of the Earth's radius within a post that its heights
  // there, and so its rise, say nothing of those before.
  VEC_INLINE M turns_over(std::size_t first) const {
    const VerticalFrame& frame = terrain_.frame();
    const double curvature = std::max(frame.north_curvature_per_m, frame.east_curvature_per_m);
    const V rate = hn::Max(hn::Abs(get(lines_.rate_u, first)), hn::Abs(get(lines_.rate_v, first)));
    return hn::Abs(get(lines_.slope, first)) * of(4 * curvature) > rate;
  }

  // Whether single precision may take the beginning of a line for a place on the last column or
  // row of posts, which it would leave at once.
  VEC_INLINE M at_far_border(std::size_t first) const {
    constexpr double kPlace = 0x1p-18;
    const HeightGrid& grid = *terrain_.layers()[0].grid;
    return hn::Or(get(lines_.start_u, first) > of(grid.columns - 1 - kPlace),
                  get(lines_.start_v, first) > of(grid.rows - 1 - kPlace));
  }

  // As GridWalk stands at the beginning of a line; NaN over a hole.
  VEC_INLINE V start_clearance(std::size_t first) const {
    const HeightGrid& grid = *terrain_.layers()[0].grid;
    const V u = get(lines_.start_u, first);
    const V v = get(lines_.start_v, first);
    const V column = cell(u, grid.columns);
    const V row = cell(v, grid.rows);
    const V f_u = hn::Min(hn::Max(u - column, of(0)), of(1));
    const V f_v = hn::Min(hn::Max(v - row, of(0)), of(1));
    const V columns = of(grid.columns);
    const V post = row * columns + column;
    const V nw = posts_.at(post);
    const V ne = posts_.at(post + of(1));
    const V sw = posts_.at(post + columns);
    const V se = posts_.at(post + columns + of(1));
    const V north = nw + f_u * (ne - nw);
    const V south = sw + f_u * (se - sw);
    const V x = get(lines_.x0, first);
    const V y = get(lines_.y0, first);
    return get(lines_.z0, first) - frame_.z(x, y, north + f_v * (south - north));
  }

  VEC_INLINE void put_in_cell(std::size_t first) {
    const HeightGrid& grid = *terrain_.layers()[0].grid;
    const V u = get(lines_.start_u, first);
    const V v = get(lines_.start_v, first);
    const V column = cell(u, grid.columns);
    const V row = cell(v, grid.rows);
    put(set_.column0, first, column);
    put(set_.column, first, column);
    put(set_.row0, first, row);
    put(set_.row, first, row);
    put(set_.u, first, u - column);
    put(set_.v, first, v - row);
    put(set_.rate_u, first, get(lines_.rate_u, first));
    put(set_.rate_v, first, get(lines_.rate_v, first));
    put(set_.metres_u, first, get(lines_.metres_u, first));
    put(set_.metres_v, first, get(lines_.metres_v, first));
    put(set_.end, first, get(lines_.end, first) - get(lines_.begin, first));
    put(set_.g, first, of(0));
  }

  // Heights of the ray over its line: a secant over one post.
  VEC_INLINE void rise(std::size_t first) {
    const V begin = get(lines_.begin, first);
    const V slope = get(lines_.slope, first);
    const V rate = hn::Max(hn::Abs(get(lines_.rate_u, first)), hn::Abs(get(lines_.rate_v, first)));
    const V post_m = of(1) / rate;
    const auto x_at = [&](V g)
                          HWY_ATTR { return get(lines_.x0, first) + get(lines_.x, first) * g; };
    const auto y_at = [&](V g)
                          HWY_ATTR { return get(lines_.y0, first) + get(lines_.y, first) * g; };
    const V curvature = frame_.curvature(x_at(begin), y_at(begin));
    const auto height = [&](V g) HWY_ATTR {
      return frame_.height(x_at(g), y_at(g), get(lines_.z0, first) + slope * g, curvature);
    };
    const V start = height(begin);
    const V climb = height(begin + post_m) - start;
    const V bend = of(bend_.most_per_m2) * (of(1) + of(2) * slope * slope);
    put(set_.height, first, start);
    put(set_.rise, first, climb * rate);
    put(set_.bend, first, bend);
    put(set_.slack, first,
        of(0x1p-20) * (hn::Abs(start) + hn::Abs(climb)) + bend * post_m * post_m -
            of(2 * bend_.least_m));
  }

  // VerticalFrame::bend(), in the grid's unit of height.
  static VerticalFrame::Bend bend_of(const Terrain& terrain) {
    const VerticalFrame::Bend bend = terrain.frame().bend(terrain.height_bound_m());
    const double scale = terrain.frame().z_scale;
    return {bend.least_m / scale, bend.most_per_m2 / scale};
  }

  const Terrain& terrain_;
  VectorFrame frame_;
  VectorPosts posts_;
  VerticalFrame::Bend bend_;
  MarchSet& set_;
};

void check_starts(const Terrain& terrain, MarchLines& lines, MarchSet& set, Fates& fates) {
  MarchStart(terrain, lines, set).check_starts(fates);
}

void put_in_set(const Terrain& terrain, MarchLines& lines, MarchSet& set) {
  MarchStart(terrain, lines, set).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(check_starts);
HWY_EXPORT(put_in_set);

namespace {

bool serves(const Terrain& terrain) {
  return within_vector_limits(terrain) && terrain.layers()[0].ceilings &&
         terrain.frame().z_scale > 0 && terrain.frame().is_convex(terrain.reach_m());
}

// Up to kMost rays of a terrain.
class Batch {
 public:
  Batch(const Terrain& terrain, const SunMap* sun, std::span<const Ray> rays)
      : terrain_(terrain), sun_(sun), rays_(rays) {
    fates_.fill(March::on_its_way);
  }

  void run(std::span<std::uint8_t> stopped, TraceCounts& counts) {
    begin();
    HWY_DYNAMIC_DISPATCH(check_starts)(terrain_, lines_, set_, fates_);
    while (take_waiting()) {
      HWY_DYNAMIC_DISPATCH(put_in_set)(terrain_, lines_, set_);
      march(terrain_, sun_, set_, fates_, counts);
      go_on_from_knots();
    }
    for (std::size_t i = 0; i < rays_.size(); ++i)
      stopped[i] = fates_[i] == March::undecided ? terrain_.occluded(rays_[i], &counts)
                                                 : fates_[i] == March::stopped;
  }

 private:
  void begin() {
    for (std::size_t i = 0; i < rays_.size(); ++i) lines_.aim(i, rays_[i]);
    if (terrain_.layers()[0].map->linear()) {
      lay_straight(terrain_, lines_, fates_);
      take_waiting();
      return;
    }
    lay_lines(terrain_, lines_, fates_);
    take_waiting();
    terrain_.layers()[0].map->places({all(lines_.x0), all(lines_.y0)},
                                     {all(lines_.start_u), all(lines_.start_v)});
    lay_pieces(terrain_, lines_, fates_);
    take_waiting();
  }

  [[nodiscard]] std::span<double> all(MarchLines::Doubles& values) const {
    return {values.data(), lines_.count};
  }

  // Packs the lines that are on their way, for a march. False: there are none.
  bool take_waiting() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < lines_.count; ++i)
      if (fates_[static_cast<std::size_t>(lines_.index[i])] == March::on_its_way)
        lines_.move(i, kept++);
    lines_.count = set_.count = kept;
    std::copy_n(lines_.index.begin(), kept, set_.index.begin());
    return kept > 0;
  }

  // Their tracks' next pieces for rays that stand at a knot.
  void go_on_from_knots() {
    for (std::size_t i = 0; i < lines_.count; ++i) {
      March& fate = fates_[static_cast<std::size_t>(lines_.index[i])];
      if (fate != March::at_knot) continue;
      fate = lines_.end[i] < lines_.to[i] ? March::on_its_way : March::undecided;
    }
    if (!take_waiting()) return;
    for (const auto& [from, to] :
         {std::pair(&lines_.end, &lines_.begin), std::pair(&lines_.end_u, &lines_.start_u),
          std::pair(&lines_.end_v, &lines_.start_v)})
      std::copy_n(from->begin(), lines_.count, to->begin());
    lay_pieces(terrain_, lines_, fates_);
  }

  const Terrain& terrain_;
  const SunMap* sun_;
  std::span<const Ray> rays_;
  MarchLines lines_;
  MarchSet set_;
  Fates fates_;
};

}  // namespace

void occluded(const Terrain& terrain, std::span<const Ray> rays, std::span<std::uint8_t> stopped,
              TraceCounts& counts, const SunMap* sun) {
  if (!serves(terrain)) {
    for (std::size_t i = 0; i < rays.size(); ++i)
      stopped[i] = terrain.occluded(rays[i], &counts) ? 1 : 0;
    return;
  }
  for (std::size_t i = 0; i < rays.size(); i += MarchSet::kMost) {
    const std::size_t count = std::min(MarchSet::kMost, rays.size() - i);
    Batch(terrain, sun, rays.subspan(i, count)).run(stopped.subspan(i, count), counts);
  }
}

}  // namespace terrview
#endif
