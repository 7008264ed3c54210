#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/eye_tracer.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>

#include "terrain/eye_tracer.h"
#include "terrain/tracer.h"
#include "terrain/vector_ground-inl.h"

#ifndef TERRVIEW_TERRAIN_EYE_TRACER_ONCE
#define TERRVIEW_TERRAIN_EYE_TRACER_ONCE
namespace terrview {

// Rays that wait for free lanes.
struct WaitingRay {
  std::int32_t index;
  std::int32_t ring;
  std::int32_t column;  // of the cell to go on from; negative: the start of the ring
  std::int32_t row;
};

struct RayQueue {
  std::array<WaitingRay, EyeRays::kMost> rays;
  std::size_t count = 0;

  void push(const WaitingRay& ray) { rays[count++] = ray; }
};

// Rays for the single ray's tracer.
struct RescueList {
  std::array<std::int32_t, EyeRays::kMost> rays;
  std::size_t count = 0;
};

}  // namespace terrview
#endif

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

using Ints = hn::Rebind<std::int32_t, D>;
using Floats = hn::Rebind<float, D>;

HWY_INLINE V load(const EyeRays::Values& values, std::size_t first) {
  return hn::Load(D(), values.data() + first);
}
HWY_INLINE void save(EyeRays::Values& values, std::size_t first, V value) {
  hn::Store(value, D(), values.data() + first);
}

// Ground lines, slopes, tracks and wedges, as ground_line(), ray_slope() and track_piece() find
// them.
void prepare_rays(const EyeFront& front, EyeRays& rays) {
  const glm::dmat2 jacobian = *front.terrain().layers()[0].map->linear();
  const int a_side = front.wedges_a_side();
  const auto track = [&](int axis, V x, V y, EyeRays::Values& rates, EyeRays::Values& metres,
                         std::size_t i) HWY_ATTR {
    const V rate = of(jacobian[0][axis]) * x + of(jacobian[1][axis]) * y;
    const V inverse = of(1) / rate;
    const M finite = hn::Abs(inverse) < hn::Inf(D());
    save(rates, i, hn::IfThenElseZero(finite, rate));
    save(metres, i, hn::IfThenElseZero(finite, inverse));
  };
  for (std::size_t i = 0; i < rays.count; i += hn::Lanes(D())) {
    const V across_x = load(rays.direction_x, i);
    const V across_y = load(rays.direction_y, i);
    const V length = hn::Sqrt(across_x * across_x + across_y * across_y);
    const V x = across_x / length;
    const V y = across_y / length;
    save(rays.x, i, x);
    save(rays.y, i, y);
    save(rays.slope, i, load(rays.direction_z, i) / length);
    track(0, x, y, rays.rate_u, rays.metres_u, i);
    track(1, x, y, rays.rate_v, rays.metres_v, i);

    const V far_x = hn::Abs(across_x);
    const V far_y = hn::Abs(across_y);
    const M along_y = far_y >= far_x;
    const V c = hn::IfThenElse(along_y, across_x, across_y) / hn::Max(far_x, far_y);
    const V side =
        hn::IfThenElse(along_y, hn::IfThenElse(across_y > of(0), of(0), of(2 * a_side)),
                       hn::IfThenElse(across_x > of(0), of(a_side), of(3 * a_side)));
    // A vertical ray's NaN becomes wedge 0.
    const V place = hn::Max(hn::Floor((c + of(1)) * of(0.5 * a_side)), of(0));
    const V wedge = side + hn::Min(place, of(a_side - 1));
    hn::StoreU(hn::DemoteTo(Ints(), wedge), Ints(), rays.wedge.data() + i);
  }
}

class EyeLoop {
 public:
  EyeLoop(const EyeFront& front, EyeRays& rays, RescueList& rescues)
      : front_(front),
        grid_(front.terrain()),
        rays_(rays),
        rescues_(rescues),
        rings_(front.rings()) {
    const Terrain& terrain = front.terrain();
    const glm::dvec2 eye_uv = terrain.layers()[0].map->to_grid({0, 0});
    eye_u_ = eye_uv.x;
    eye_v_ = eye_uv.y;
    if (const auto ground = terrain.ground_at({0, 0})) {
      eye_column_ = ground->cell.x;
      eye_row_ = ground->cell.y;
      eye_z_ = terrain.frame().at({0, 0}).z_m(ground->scene_height_m);
    }
  }

  std::int64_t run() {
    for (std::size_t i = 0; i < rays_.count; i += hn::Lanes(D())) place(i);
    for (std::size_t i = 0; i < rays_.count; i += hn::Lanes(D())) start(i);
    while (waiting_.count > 0) {
      const RayQueue queue = waiting_;
      waiting_.count = 0;
      for (std::size_t i = 0; i < queue.count; i += hn::Lanes(D())) go_on(queue, i);
    }
    return tests_;
  }

 private:
  // The lanes of one walk.
  struct Walk {
    Registers r;
    V ring;
    V ring_end;
    V wedge_base;  // of the wedge's bounds
    alignas(64) std::array<double, kVectorLanes> index;
    std::uint32_t active;
  };

  HWY_INLINE V bound(V base, V ring) const {
    return hn::PromoteTo(D(), hn::GatherIndex(Floats(), front_.bounds(),
                                              hn::DemoteTo(Ints(), base + ring * of(kGroup))));
  }

  // The first ring from `ring` on whose bound reaches the slope.
  HWY_INLINE V search(V ring, V slope, V wedge_base, V coarse_base, std::uint32_t active) const {
    constexpr int kStride = EyeFront::kStride;
    while (true) {
      const M below = bound(wedge_base, ring) < slope;
      if ((bits_of(below) & active) == 0) return ring;
      const V block = hn::Floor(ring * of(1.0 / kStride));
      const V coarse = hn::PromoteTo(
          D(), hn::GatherIndex(Floats(), front_.coarse_bounds(),
                               hn::DemoteTo(Ints(), coarse_base + block * of(kGroup))));
      const M leap = hn::And(block * of(kStride) == ring, coarse < slope);
      ring = ring + hn::IfThenElseZero(below, hn::IfThenElse(leap, of(kStride), of(1)));
    }
  }

  // Puts lanes into the cells where their rings begin.
  HWY_INLINE M seat(Registers& r, V ring) const {
    const V ring_m = ring_at(ring);
    const V start_m = hn::Max(ring_m - of(front_.margin_m()), of(0));
    const V u = r.start_u + r.rate_u * start_m;
    const V v = r.start_v + r.rate_v * start_m;
    const V last_column = grid_.columns() - of(2);
    const V last_row = grid_.rows() - of(2);
    r.column = hn::Min(hn::Max(hn::Floor(u), of(0)), last_column);
    r.row = hn::Min(hn::Max(hn::Floor(v), of(0)), last_row);
    return hn::And(hn::And(u >= of(0), v >= of(0)),
                   hn::And(u <= last_column + of(1), v <= last_row + of(1)));
  }

  HWY_INLINE V ring_at(V ring) const {
    const hn::Rebind<std::int64_t, D> longs;
    return hn::GatherIndex(D(), front_.ring_m().data(), hn::ConvertTo(longs, ring));
  }

  HWY_INLINE Registers registers(V x, V y, V slope, V rate_u, V rate_v, V metres_u,
                                 V metres_v) const {
    Registers r;
    r.x = x;
    r.y = y;
    r.slope = slope;
    r.rate_u = rate_u;
    r.rate_v = rate_v;
    r.metres_u = metres_u;
    r.metres_v = metres_v;
    r.begin = of(0);
    r.end = of(front_.terrain().reach_m());
    r.start_u = of(eye_u_);
    r.start_v = of(eye_v_);
    return r;
  }

  HWY_INLINE V wedge_base(V wedge, int rings) const {
    const V group = hn::Floor(wedge * of(1.0 / kGroup));
    return group * of(1.0 * rings * kGroup) + (wedge - group * of(kGroup));
  }

  // Finds the first cells of rays first, first + 1, ...
  HWY_INLINE void place(std::size_t first) {
    const std::uint32_t lanes = (1U << std::min(hn::Lanes(D()), rays_.count - first)) - 1;
    save(rays_.ground_m, first, of(-1));
    const V rise = hn::Abs(load(rays_.direction_z, first));
    const V across_x = load(rays_.direction_x, first);
    const V across_y = load(rays_.direction_y, first);
    const V run2 = across_x * across_x + across_y * across_y;
    // As is_vertical(), but for rounding: those near it go the sure way. NaN too.
    const M slanted = run2 > of(4e-24) * rise * rise;

    const V slope = load(rays_.slope, first);
    const V bin = hn::Floor((slope / (of(1) + hn::Abs(slope)) + of(1)) *
                            of(EyeFront::kStartBins / 2));
    const V wedge = hn::PromoteTo(D(), hn::LoadU(Ints(), rays_.wedge.data() + first));
    const V at = wedge * of(EyeFront::kStartBins) +
                 hn::IfThenElseZero(bin >= of(0), hn::Min(bin, of(EyeFront::kStartBins - 1)));
    V ring = hn::PromoteTo(D(),
                           hn::GatherIndex(Ints(), front_.starts(), hn::DemoteTo(Ints(), at)));
    const V base = wedge_base(wedge, rings_ + 1);
    // The bin's first ring may be one or two too near.
    for (int i = 0; i < 2; ++i)
      ring = ring + hn::IfThenElseZero(bound(base, ring) < slope, of(1));
    const M reached = bound(base, ring) >= slope;
    const M missed = ring >= of(rings_);

    Registers r = registers(of(0), of(0), slope, load(rays_.rate_u, first),
                            load(rays_.rate_v, first), of(0), of(0));
    ring = hn::Min(ring, of(rings_ - 1));
    const M seated = seat(r, ring);
    save(ring_, first, ring);
    save(rays_.column, first, r.column);
    save(rays_.row, first, r.row);

    const std::uint32_t live = lanes & ~bits_of(missed);
    const std::uint32_t lost = live & ~(bits_of(slanted) & (bits_of(seated) | ~bits_of(reached)));
    for (std::uint32_t left = lanes & (~bits_of(slanted) | lost); left != 0; left &= left - 1)
      rescues_.rays[rescues_.count++] = static_cast<std::int32_t>(first) + __builtin_ctz(left);
    const std::uint32_t ready = live & ~lost;
    ready_[first / hn::Lanes(D())] = static_cast<std::uint8_t>(ready & bits_of(reached));
    for (std::uint32_t left = ready & ~bits_of(reached); left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctz(left)) + first;
      waiting_.push({static_cast<std::int32_t>(i), static_cast<std::int32_t>(ring_[i]), -1, -1});
    }
  }

  // The first crossings of rays first, first + 1, ...
  HWY_INLINE void start(std::size_t first) {
    Walk w;
    w.active = ready_[first / hn::Lanes(D())];
    if (w.active == 0) return;
    w.r = registers(load(rays_.x, first), load(rays_.y, first), load(rays_.slope, first),
                    load(rays_.rate_u, first), load(rays_.rate_v, first),
                    load(rays_.metres_u, first), load(rays_.metres_v, first));
    w.r.column = load(rays_.column, first);
    w.r.row = load(rays_.row, first);
    hn::Store(hn::Iota(D(), static_cast<double>(first)), D(), w.index.data());
    w.ring = load(ring_, first);
    w.wedge_base =
        wedge_base(hn::PromoteTo(D(), hn::LoadU(Ints(), rays_.wedge.data() + first)), rings_ + 1);
    walk<true>(w, first, false);
  }

  // Moves lanes on to the next ring that reaches them; those without any have missed.
  HWY_INLINE void find_ring(Walk& w, V wedge, std::uint32_t lanes) {
    const M looking = mask_of(lanes);
    const V from = hn::IfThenElse(looking, w.ring, of(rings_));
    const V found = search(from, w.r.slope, w.wedge_base,
                           wedge_base(wedge, front_.coarse_rings()), lanes);
    w.ring = hn::IfThenElse(looking, found, w.ring);
    w.active &= ~(lanes & bits_of(found >= of(rings_)));
    w.ring = hn::Min(w.ring, of(rings_ - 1));
  }

  // Rays that waited.
  HWY_INLINE void go_on(const RayQueue& queue, std::size_t first) {
    const std::size_t count = std::min(hn::Lanes(D()), queue.count - first);
    alignas(64) std::array<double, kVectorLanes> field[11];
    for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane) {
      const WaitingRay& ray = queue.rays[first + std::min(lane, count - 1)];
      const auto i = static_cast<std::size_t>(ray.index);
      field[0][lane] = rays_.x[i];
      field[1][lane] = rays_.y[i];
      field[2][lane] = rays_.slope[i];
      field[3][lane] = rays_.rate_u[i];
      field[4][lane] = rays_.rate_v[i];
      field[5][lane] = rays_.metres_u[i];
      field[6][lane] = rays_.metres_v[i];
      field[7][lane] = rays_.wedge[i];
      field[8][lane] = ray.ring;
      field[9][lane] = ray.column;
      field[10][lane] = ray.row;
    }
    const auto get = [&](int i) HWY_ATTR { return hn::Load(D(), field[i].data()); };
    Walk w;
    w.r = registers(get(0), get(1), get(2), get(3), get(4), get(5), get(6));
    for (std::size_t lane = 0; lane < count; ++lane)
      w.index[lane] = queue.rays[first + lane].index;
    w.active = (1U << count) - 1;
    w.ring = get(8);
    w.wedge_base = wedge_base(get(7), rings_ + 1);
    const M searching = get(9) < of(0);
    const std::uint32_t search = bits_of(searching) & w.active;
    if (search != 0) find_ring(w, get(7), search);
    const std::uint32_t seated = bits_of(seat(w.r, w.ring)) | ~search;
    w.r.column = hn::IfThenElse(searching, w.r.column, get(9));
    w.r.row = hn::IfThenElse(searching, w.r.row, get(10));
    rescue(w, w.active & ~seated);
    w.active &= seated;
    walk<false>(w, 0, queue.count <= hn::Lanes(D()));
  }

  HWY_INLINE void rescue(const Walk& w, std::uint32_t lanes) {
    for (; lanes != 0; lanes &= lanes - 1)
      rescues_.rays[rescues_.count++] = static_cast<std::int32_t>(
          w.index[static_cast<std::size_t>(__builtin_ctz(lanes))]);
  }

  // Where the lanes came into their cells. True: as the single ray's walk does.
  HWY_INLINE M enter(Registers& r) const {
    const M at_eye = hn::And(r.column == of(eye_column_), r.row == of(eye_row_));
    const M entered = grid_.enter_cell(r);
    r.g = hn::IfThenElse(at_eye, of(0), r.g);
    r.u = hn::IfThenElse(at_eye, of(eye_u_), r.u);
    r.v = hn::IfThenElse(at_eye, of(eye_v_), r.v);
    r.z = hn::IfThenElse(at_eye, of(eye_z_), r.z);
    return hn::Or(entered, at_eye);
  }

  // Walks until the rays are settled or, unless `to_the_end`, half the lanes stand idle. With
  // kInOrder lane i is ray first + i.
  template <bool kInOrder>
  HWY_INLINE void walk(Walk& w, std::size_t first, bool to_the_end) {
    Registers& r = w.r;
    const std::uint32_t entered = bits_of(enter(r));
    rescue(w, w.active & ~entered);
    w.active &= entered;
    park(r, w.active);
    w.ring_end = ring_at(w.ring + of(1));
    const int idle = to_the_end ? 0 : static_cast<int>(hn::Lanes(D())) / 2;
    while (w.active != 0) {
      const std::uint32_t active = w.active;
      const NextCrossing next = grid_.next_crossing(r);
      const V in = r.slope * r.g - r.z;
      const V out = r.slope * next.g - next.z;
      const std::uint32_t ground = bits_of(next.has_ground) & w.active;
      tests_ += __builtin_popcount(ground);
      const std::uint32_t lost =
          ((bits_of(in < of(0)) & ground) | bits_of(next.g > r.end)) & w.active;
      const std::uint32_t hit =
          bits_of(hn::And(out <= of(0), next.g > r.g)) & ground & ~lost;
      if (lost != 0) rescue(w, lost);
      if (hit != 0) record<kInOrder>(w, next, in, out, hit, first);
      w.active &= ~(hit | lost);
      advance(r, next);
      w.active &= bits_of(grid_.is_inside(r));
      const std::uint32_t over = bits_of(r.g >= w.ring_end) & w.active;
      if (over != 0) next_ring(w, over);
      if (__builtin_popcount(w.active) <= idle) break;
      if (w.active != active) park(r, w.active);
    }
    for (std::uint32_t left = w.active; left != 0; left &= left - 1) wait(w, __builtin_ctz(left));
  }

  HWY_INLINE void next_ring(Walk& w, std::uint32_t over) {
    w.ring = w.ring + hn::IfThenElseZero(mask_of(over), of(1));
    const std::uint32_t reached = bits_of(bound(w.wedge_base, w.ring) >= w.r.slope);
    const std::uint32_t past = bits_of(w.ring >= of(rings_)) & over;
    rescue(w, past);
    w.active &= ~past;
    w.ring = hn::Min(w.ring, of(rings_ - 1));
    w.ring_end = ring_at(w.ring + of(1));
    for (std::uint32_t left = over & ~reached & ~past; left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(left);
      w.active &= ~(1U << lane);
      alignas(64) std::array<double, kVectorLanes> ring;
      hn::Store(w.ring, D(), ring.data());
      const auto i = static_cast<std::size_t>(lane);
      waiting_.push({static_cast<std::int32_t>(w.index[i]), static_cast<std::int32_t>(ring[i]),
                     -1, -1});
    }
  }

  HWY_INLINE void wait(const Walk& w, int lane) {
    alignas(64) std::array<double, kVectorLanes> ring;
    alignas(64) std::array<double, kVectorLanes> column;
    alignas(64) std::array<double, kVectorLanes> row;
    hn::Store(w.ring, D(), ring.data());
    hn::Store(w.r.column, D(), column.data());
    hn::Store(w.r.row, D(), row.data());
    const auto i = static_cast<std::size_t>(lane);
    waiting_.push({static_cast<std::int32_t>(w.index[i]), static_cast<std::int32_t>(ring[i]),
                   static_cast<std::int32_t>(column[i]), static_cast<std::int32_t>(row[i])});
  }

  template <bool kInOrder>
  HWY_INLINE void record(const Walk& w, const NextCrossing& next, V in, V out, std::uint32_t hit,
                         std::size_t first) {
    const Registers& r = w.r;
    const V share = hn::IfThenElseZero(in > of(0), in / (in - out));
    const V g = r.g + share * (next.g - r.g);
    const V u = r.u + share * (next.u - r.u);
    const V v = r.v + share * (next.v - r.v);
    if constexpr (kInOrder) {
      const M mask = mask_of(hit);
      hn::BlendedStore(g, mask, D(), rays_.ground_m.data() + first);
      hn::BlendedStore(u, mask, D(), rays_.u.data() + first);
      hn::BlendedStore(v, mask, D(), rays_.v.data() + first);
      hn::BlendedStore(r.column, mask, D(), rays_.column.data() + first);
      hn::BlendedStore(r.row, mask, D(), rays_.row.data() + first);
      return;
    }
    alignas(64) std::array<double, kVectorLanes> lanes[5];
    hn::Store(g, D(), lanes[0].data());
    hn::Store(u, D(), lanes[1].data());
    hn::Store(v, D(), lanes[2].data());
    hn::Store(r.column, D(), lanes[3].data());
    hn::Store(r.row, D(), lanes[4].data());
    for (; hit != 0; hit &= hit - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(hit));
      const auto i = static_cast<std::size_t>(w.index[lane]);
      rays_.ground_m[i] = lanes[0][lane];
      rays_.u[i] = lanes[1][lane];
      rays_.v[i] = lanes[2][lane];
      rays_.column[i] = lanes[3][lane];
      rays_.row[i] = lanes[4][lane];
    }
  }

  static constexpr int kGroup = EyeFront::kGroup;

  const EyeFront& front_;
  VectorGrid grid_;
  EyeRays& rays_;
  RescueList& rescues_;
  int rings_;
  double eye_u_ = 0;
  double eye_v_ = 0;
  // Where the eye is not over ground, no cell is its cell.
  double eye_column_ = -2;
  double eye_row_ = -2;
  double eye_z_ = 0;
  RayQueue waiting_;
  alignas(64) EyeRays::Values ring_;
  std::array<std::uint8_t, EyeRays::kMost> ready_;
  std::int64_t tests_ = 0;
};

std::int64_t run_eye_loop(const EyeFront& front, EyeRays& rays, RescueList& rescues) {
  return EyeLoop(front, rays, rescues).run();
}

void affine_normals(const Terrain& terrain, const EyeRays& rays, EyeNormals& normals) {
  const HeightGrid& grid = *terrain.layers()[0].grid;
  const glm::dmat2 jacobian = *terrain.layers()[0].map->linear();
  const VectorPosts posts(grid);
  const V columns = of(grid.columns);
  const V z_scale = of(terrain.frame().z_scale);
  for (std::size_t i = 0; i < rays.count; i += hn::Lanes(D())) {
    const M hit = load(rays.ground_m, i) >= of(0);
    const V column = hn::IfThenElseZero(hit, load(rays.column, i));
    const V row = hn::IfThenElseZero(hit, load(rays.row, i));
    const V f_u = hn::Min(hn::Max(load(rays.u, i) - column, of(0)), of(1));
    const V f_v = hn::Min(hn::Max(load(rays.v, i) - row, of(0)), of(1));
    const V post = row * columns + column;
    const V nw = posts.at(post);
    const V ne = posts.at(post + of(1));
    const V sw = posts.at(post + columns);
    const V se = posts.at(post + columns + of(1));
    // glm::mix(x, y, a) = x * (1 - a) + y * a.
    const V g_u = (ne - nw) * (of(1) - f_v) + (se - sw) * f_v;
    const V g_v = (sw - nw) * (of(1) - f_u) + (se - ne) * f_u;
    const V slope_x = z_scale * (of(jacobian[0][0]) * g_u + of(jacobian[0][1]) * g_v);
    const V slope_y = z_scale * (of(jacobian[1][0]) * g_u + of(jacobian[1][1]) * g_v);
    const V inverse = of(1) / hn::Sqrt(slope_x * slope_x + slope_y * slope_y + of(1));
    save(normals.x, i, hn::Neg(slope_x) * inverse);
    save(normals.y, i, hn::Neg(slope_y) * inverse);
    save(normals.z, i, inverse);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(prepare_rays);
HWY_EXPORT(run_eye_loop);
HWY_EXPORT(affine_normals);

namespace {

// Lanes past the last ray are computed all the same.
void pad(EyeRays& rays) {
  const std::size_t padded = (rays.count + 7) / 8 * 8;
  for (std::size_t i = rays.count; i < padded; ++i) {
    rays.direction_x[i] = rays.direction_x[0];
    rays.direction_y[i] = rays.direction_y[0];
    rays.direction_z[i] = rays.direction_z[0];
  }
}

void make_front(const EyeFront& front, const EyeRays& rays) {
  int made = -1;
  for (std::size_t i = 0; i < rays.count; ++i) {
    const int group = rays.wedge[i] / EyeFront::kGroup;
    if (group == made) continue;
    front.make(group);
    made = group;
  }
}

}  // namespace

Hit EyeRays::hit(std::size_t i) const {
  const glm::ivec2 cell(static_cast<int>(column[i]), static_cast<int>(row[i]));
  if (std::isinf(slope[i]))
    return {ground_m[i], glm::dvec3(0, 0, -ground_m[i]), 0, cell, {u[i], v[i]}};
  const GroundLine line{{0, 0}, {x[i], y[i]}};
  const double g_m = ground_m[i];
  return {g_m * metres_per_g(slope[i]),
          glm::dvec3(line.at(g_m), 0 + slope[i] * g_m),
          0,
          cell,
          {u[i], v[i]}};
}

void trace(const EyeFront& front, EyeRays& rays, TraceCounts& counts) {
  if (rays.count == 0) return;
  pad(rays);
  HWY_DYNAMIC_DISPATCH(prepare_rays)(front, rays);
  make_front(front, rays);
  RescueList rescues;
  counts.tests += HWY_DYNAMIC_DISPATCH(run_eye_loop)(front, rays, rescues);
  const Terrain& terrain = front.terrain();
  for (std::size_t j = 0; j < rescues.count; ++j) {
    const auto i = static_cast<std::size_t>(rescues.rays[j]);
    const Ray ray{{0, 0, 0}, {rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]}};
    const Trace found = trace(terrain, terrain.ceiling_m(), ray);
    counts.tests += found.counts.tests;
    counts.nodes += found.counts.nodes;
    rays.ground_m[i] = found.outcome == Outcome::hit ? found.ground_m : -1;
    if (found.outcome == Outcome::hit && is_vertical(ray)) {
      rays.slope[i] = -std::numeric_limits<double>::infinity();
      rays.ground_m[i] = found.hit.distance_m;
    }
    rays.u[i] = found.hit.uv.x;
    rays.v[i] = found.hit.uv.y;
    rays.column[i] = found.hit.cell.x;
    rays.row[i] = found.hit.cell.y;
  }
}

void facet_normals(const Terrain& terrain, const EyeRays& rays, EyeNormals& normals) {
  if (rays.count > 0) HWY_DYNAMIC_DISPATCH(affine_normals)(terrain, rays, normals);
}

}  // namespace terrview
#endif
