#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/column_tracer.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "terrain/column_tracer.h"
#include "terrain/column_walk.h"
#include "terrain/tracer.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"
#include "terrain/vector_limits.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
static_assert(kMostLanes == kVectorLanes);

VEC_INLINE V get(const Lanes& lanes) { return hn::Load(D(), lanes.data()); }
VEC_INLINE void set(Lanes& lanes, V value) { hn::Store(value, D(), lanes.data()); }

VEC_INLINE Registers load(const ColumnState& s, std::uint32_t active) {
  Registers r{get(s.column), get(s.row),    get(s.g),        get(s.u),        get(s.v),
              get(s.z),      get(s.begin),  get(s.end),      get(s.start_u),  get(s.start_v),
              get(s.rate_u), get(s.rate_v), get(s.metres_u), get(s.metres_v), get(s.x),
              get(s.y),      get(s.slope)};
  park(r, active);
  return r;
}

// What advancing changes.
VEC_INLINE void store(const Registers& r, ColumnState& s) {
  set(s.column, r.column);
  set(s.row, r.row);
  set(s.g, r.g);
  set(s.u, r.u);
  set(s.v, r.v);
  set(s.z, r.z);
}

// Records the rays of the lanes in `hit`, whose clearance at `next` is `out`.
VEC_INLINE void record(ColumnWalk& walk, const Registers& r, const NextCrossing& next, V out,
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
VEC_INLINE void for_each_lane(std::uint32_t lanes, const Act& act) {
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
      const NextCrossing next = grid_.next_crossing(r, grid_.corners(r));
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
  VEC_INLINE bool settle_rare(Registers& r, const NextCrossing& next, std::uint32_t ground,
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
  VEC_INLINE void trace_span(Registers& r, const NextCrossing& next, std::uint32_t ground) {
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
  VEC_INLINE std::uint32_t leave(Registers& r) {
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

bool has_columns(const Terrain& terrain) { return within_vector_limits(terrain); }

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
  return {hit.g_m * metres_per_g(slope),
          glm::dvec3(ground_line(ray).at(hit.g_m), 0 + slope * hit.g_m), 0, hit.cell, hit.uv};
}

}  // namespace terrview
#endif
