#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/column_tracer.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "terrain/column_tracer.h"
#include "terrain/column_walk.h"
#include "terrain/tracer.h"
#include "terrain/vertical_math.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, kMostLanes>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

HWY_INLINE V of(double x) { return hn::Set(D(), x); }

HWY_INLINE V series(const std::array<double, 6>& coefficients, V x) {
  V sum = of(coefficients[5]);
  for (std::size_t i = 5; i-- > 0;) sum = of(coefficients[i]) + x * sum;
  return sum;
}

HWY_INLINE std::uint32_t bits_of(M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(D(), mask, bytes);
  return bytes[0];
}

// z of the ground: VerticalFrame::at(line.at(g)).z_m(z_scale * height), lane by lane.
class VectorFrame {
 public:
  explicit VectorFrame(const VerticalFrame& frame)
      : flat_(frame.north_curvature_per_m == 0 && frame.east_curvature_per_m == 0),
        eye_(of(frame.eye_height_m)),
        scale_(of(frame.z_scale)),
        north_(of(frame.north_curvature_per_m)),
        east_(of(frame.east_curvature_per_m)),
        half_refraction_(of(frame.refraction / 2)) {}

  HWY_INLINE V z(V x, V y, V height) const {
    const V scene_height = scale_ * height;
    if (flat_) return scene_height - eye_;
    const V x2 = x * x;
    const V y2 = y * y;
    const V s2 = x2 + y2;
    const V s2_over_r = x2 * east_ + y2 * north_;
    const V curvature = hn::IfThenElse(s2 > of(0), s2_over_r / s2, north_);
    const V gamma2 = s2_over_r * curvature;
    const V drop = s2_over_r * (half_refraction_ - series(kHalfTangent, gamma2));
    const V stretch = series(kInverseSinc, gamma2);
    return drop + stretch * (scene_height - eye_) / (of(1) + curvature * scene_height);
  }

 private:
  bool flat_;
  V eye_;
  V scale_;
  V north_;
  V east_;
  V half_refraction_;
};

// ColumnState in registers.
struct Registers {
  V column, row, g, u, v, z;
  V begin, end, start_u, start_v, rate_u, rate_v, metres_u, metres_v;
  V x, y, slope;
};

HWY_INLINE V get(const Lanes& lanes) { return hn::Load(D(), lanes.data()); }
HWY_INLINE void set(Lanes& lanes, V value) { hn::Store(value, D(), lanes.data()); }

// Lanes that have ended are computed all the same: they stand still in a cell of the grid.
HWY_INLINE void park(Registers& r, std::uint32_t active) {
  const std::uint8_t bits[8] = {static_cast<std::uint8_t>(active)};
  const M moving = hn::LoadMaskBits(D(), bits);
  r.column = hn::IfThenElseZero(moving, r.column);
  r.row = hn::IfThenElseZero(moving, r.row);
  r.rate_u = hn::IfThenElseZero(moving, r.rate_u);
  r.rate_v = hn::IfThenElseZero(moving, r.rate_v);
}

HWY_INLINE Registers load(const ColumnState& s, std::uint32_t active) {
  Registers r{get(s.column), get(s.row),    get(s.g),        get(s.u),        get(s.v),
              get(s.z),      get(s.begin),  get(s.end),      get(s.start_u),  get(s.start_v),
              get(s.rate_u), get(s.rate_v), get(s.metres_u), get(s.metres_v), get(s.x),
              get(s.y),      get(s.slope)};
  park(r, active);
  return r;
}

// What advancing changes.
HWY_INLINE void store(const Registers& r, ColumnState& s) {
  set(s.column, r.column);
  set(s.row, r.row);
  set(s.g, r.g);
  set(s.u, r.u);
  set(s.v, r.v);
  set(s.z, r.z);
}

// The next crossing of every lane, as GridWalk finds it.
struct NextCrossing {
  V g, u, v, z;
  M over_column;
  M has_ground;  // the cell walked to there
};

// The grid under a strip of columns.
class VectorGrid {
 public:
  explicit VectorGrid(const Terrain& terrain)
      : frame_(terrain.frame()),
        heights_m_(terrain.layers()[0].grid->heights_m.data()),
        columns_(of(terrain.layers()[0].grid->columns)),
        rows_(of(terrain.layers()[0].grid->rows)),
        has_holes_(terrain.has_holes()) {}

  HWY_INLINE NextCrossing next_crossing(const Registers& r) const {
    V column_line;
    V row_line;
    const V column_g = meets(r, r.column, r.start_u, r.rate_u, r.metres_u, column_line);
    const V row_g = meets(r, r.row, r.start_v, r.rate_v, r.metres_v, row_line);
    NextCrossing next;
    next.over_column = hn::Not(row_g < column_g);
    next.g = hn::IfThenElse(next.over_column, column_g, row_g);

    const V along = next.g - r.begin;
    const V u = clamp(r.start_u + r.rate_u * along, r.column);
    const V v = clamp(r.start_v + r.rate_v * along, r.row);
    const V share = hn::IfThenElse(next.over_column, v - r.row, u - r.column);
    next.u = hn::IfThenElse(next.over_column, column_line, u);
    next.v = hn::IfThenElse(next.over_column, v, row_line);

    const V first_column = hn::IfThenElse(next.over_column, column_line, r.column);
    const V first_row = hn::IfThenElse(next.over_column, r.row, row_line);
    const V post = first_row * columns_ + first_column;
    const V along_edge = hn::IfThenElse(next.over_column, columns_, of(1));
    const V from = gather(post);
    const V to = gather(post + along_edge);
    next.has_ground = from == from;
    if (has_holes_) {
      // To the edge of the cell opposite the one crossed.
      const V stride = hn::IfThenElse(next.over_column, of(1), columns_);
      const M forward = hn::IfThenElse(next.over_column, r.rate_u, r.rate_v) > of(0);
      const V across = hn::IfThenElse(forward, of(0) - stride, stride);
      const V sum = from + to + gather(post + across) + gather(post + across + along_edge);
      next.has_ground = sum == sum;
    }
    next.z = frame_.z(r.x * next.g, r.y * next.g, from + share * (to - from));
    return next;
  }

  HWY_INLINE M is_inside(const Registers& r) const {
    return hn::And(hn::And(r.column >= of(0), r.row >= of(0)),
                   hn::And(r.column < columns_ - of(1), r.row < rows_ - of(1)));
  }

 private:
  HWY_INLINE V gather(V index) const {
    const hn::Rebind<float, D> floats;
    const hn::Rebind<std::int32_t, D> ints;
    return hn::PromoteTo(D(), hn::GatherIndex(floats, heights_m_, hn::DemoteTo(ints, index)));
  }

  // Where a line of the grid is met, never before the last crossing.
  HWY_INLINE V meets(const Registers& r, V cell, V start, V rate, V metres, V& line) const {
    line = hn::IfThenElse(rate > of(0), cell + of(1), cell);
    const V g = hn::Max(r.g, r.begin + (line - start) * metres);
    return hn::IfThenElse(rate == of(0), hn::Inf(D()), g);
  }

  HWY_INLINE V clamp(V value, V cell) const { return hn::Min(hn::Max(value, cell), cell + of(1)); }

  VectorFrame frame_;
  const float* heights_m_;
  V columns_;
  V rows_;
  bool has_holes_;
};

HWY_INLINE void advance(Registers& r, const NextCrossing& next) {
  // Sign by sign, so that a parked lane, whose rate is 0, stays where it is.
  const auto step = [&](V rate) HWY_ATTR {
    return hn::IfThenElseZero(rate > of(0), of(1)) - hn::IfThenElseZero(rate < of(0), of(1));
  };
  r.column = r.column + hn::IfThenElseZero(next.over_column, step(r.rate_u));
  r.row = r.row + hn::IfThenZeroElse(next.over_column, step(r.rate_v));
  r.g = next.g;
  r.u = next.u;
  r.v = next.v;
  r.z = next.z;
}

// Records the rays of the lanes in `hit`, whose clearance at `next` is `out`.
HWY_INLINE void record(ColumnWalk& walk, const Registers& r, const NextCrossing& next, V out,
                       std::uint32_t hit) {
  const V in = r.slope * r.g - r.z;
  const V share = hn::IfThenElseZero(in > of(0), in / (in - out));
  alignas(64) Lanes column;
  alignas(64) Lanes row;
  alignas(64) Lanes g;
  alignas(64) Lanes u;
  alignas(64) Lanes v;
  set(column, r.column);
  set(row, r.row);
  set(g, r.g + share * (next.g - r.g));
  set(u, r.u + share * (next.u - r.u));
  set(v, r.v + share * (next.v - r.v));
  for (; hit != 0; hit &= hit - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(hit));
    walk.record(__builtin_ctz(hit),
                {g[i], {u[i], v[i]}, {static_cast<int>(column[i]), static_cast<int>(row[i])}});
  }
}

template <class Act>
HWY_INLINE void for_each_lane(std::uint32_t lanes, const Act& act) {
  for (; lanes != 0; lanes &= lanes - 1) act(__builtin_ctz(lanes));
}

// The loop over the crossings of one strip.
class ColumnLoop {
 public:
  ColumnLoop(const Terrain& terrain, ColumnWalk& walk)
      : grid_(terrain), walk_(walk), ceiling_(of(terrain.ceiling_m())) {}

  std::int64_t run() {
    Registers r = load(walk_.state, walk_.active());
    // Lanes whose last span was ground; where a lane enters the grid its rays below are dropped.
    std::uint32_t on_ground = walk_.active();
    while (walk_.active() != 0) {
      const NextCrossing next = grid_.next_crossing(r);
      const std::uint32_t ground = bits_of(next.has_ground);
      if (settle_rare(r, next, ground, on_ground)) continue;
      on_ground = ground;
      const std::uint32_t active = walk_.active();
      trace_span(r, next, ground);
      advance(r, next);
      if (walk_.active() != active) park(r, walk_.active());
      on_ground |= leave(r);
    }
    return tests_;
  }

 private:
  // Ends rays above everything, loads track pieces, and drops rays that come over an edge of the
  // ground below it. True if there was anything of the kind.
  HWY_INLINE bool settle_rare(Registers& r, const NextCrossing& next, std::uint32_t ground,
                              std::uint32_t& on_ground) {
    const std::uint32_t entering = ground & ~on_ground;
    const M cut = next.g > r.end;
    const M above = hn::And(r.slope >= of(0), r.slope * r.g > ceiling_);
    if (((bits_of(hn::Or(cut, above)) | entering) & walk_.active()) == 0) return false;
    store(r, walk_.state);
    for_each_lane(bits_of(above) & walk_.active(), [&](int lane) { walk_.finish(lane); });
    for_each_lane(bits_of(cut) & walk_.active(), [&](int lane) { walk_.next_piece(lane); });
    // Where the piece ends, the ground ahead is that of the next one.
    const std::uint32_t entered = entering & ~bits_of(cut);
    for_each_lane(entered & walk_.active(), [&](int lane) { walk_.drop_rays_below(lane); });
    on_ground |= entered;
    r = load(walk_.state, walk_.active());
    return true;
  }

  // Records every ray that meets the ground before `next`.
  HWY_INLINE void trace_span(Registers& r, const NextCrossing& next, std::uint32_t ground) {
    // A span of no length, through a post, holds no hit.
    const std::uint32_t open = ground & bits_of(next.g > r.g);
    tests_ += __builtin_popcount(ground & walk_.active());
    while (true) {
      const V out = r.slope * next.g - next.z;
      const std::uint32_t hit = bits_of(out <= of(0)) & open & walk_.active();
      if (hit == 0) return;
      tests_ += __builtin_popcount(hit);
      record(walk_, r, next, out, hit);
      r.slope = get(walk_.state.slope);
    }
  }

  // Lets lanes that have walked out of the grid enter it again. Returns the lanes.
  HWY_INLINE std::uint32_t leave(Registers& r) {
    const std::uint32_t outside = ~bits_of(grid_.is_inside(r)) & walk_.active();
    if (outside == 0) return 0;
    store(r, walk_.state);
    for_each_lane(outside, [&](int lane) { walk_.leave_grid(lane); });
    r = load(walk_.state, walk_.active());
    return outside;
  }

  VectorGrid grid_;
  ColumnWalk& walk_;
  V ceiling_;
  std::int64_t tests_ = 0;
};

int lane_count() { return static_cast<int>(hn::Lanes(D())); }

std::int64_t run_columns(const Terrain& terrain, ColumnWalk& walk) {
  return ColumnLoop(terrain, walk).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(lane_count);
HWY_EXPORT(run_columns);

bool has_columns(const Terrain& terrain) {
  if (terrain.layers().size() != 1 || terrain.model() != SurfaceModel::hyperboloid) return false;
  const HeightGrid& grid = *terrain.layers()[0].grid;
  const VerticalFrame& frame = terrain.frame();
  const double gamma =
      terrain.reach_m() * std::max(frame.north_curvature_per_m, frame.east_curvature_per_m);
  constexpr double kMostPosts = 1 << 30;  // gathers index with 32 bits
  return gamma * gamma < kSeriesLimit && static_cast<double>(grid.columns) * grid.rows < kMostPosts;
}

void trace_columns(const Terrain& terrain, const ColumnView& view, int first, int count,
                   std::span<ColumnHit> hits, TraceCounts& counts) {
  const int lanes = HWY_DYNAMIC_DISPATCH(lane_count)();
  for (int done = 0; done < count; done += lanes) {
    const int width = std::min(lanes, count - done);
    const std::size_t rows = view.rise.size();
    ColumnWalk walk(terrain, view, first + done, width,
                    hits.subspan(static_cast<std::size_t>(done) * rows,
                                 static_cast<std::size_t>(width) * rows));
    counts.tests += HWY_DYNAMIC_DISPATCH(run_columns)(terrain, walk);
  }
}

Hit column_hit(const ColumnView& view, int column, int row, const ColumnHit& hit) {
  const Ray ray{
      {0, 0, 0},
      {view.across[static_cast<std::size_t>(column)], view.rise[static_cast<std::size_t>(row)]}};
  const double slope = ray_slope(ray);
  return {hit.g_m * std::hypot(1.0, slope),
          glm::dvec3(ground_line(ray).at(hit.g_m), 0 + slope * hit.g_m), 0, hit.cell, hit.uv};
}

}  // namespace terrview
#endif
