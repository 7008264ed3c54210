// The walk of a batch of rays from the eye, in vectors. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_EYE_LOOP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_EYE_LOOP_INL_H_
#undef TERRVIEW_TERRAIN_EYE_LOOP_INL_H_
#else
#define TERRVIEW_TERRAIN_EYE_LOOP_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "terrain/eye_front.h"
#include "terrain/eye_tracer.h"
#include "terrain/eye_tracks.h"
#include "terrain/grid_walk.h"
#include "terrain/ray_set.h"
#include "terrain/vector_ground-inl.h"

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

// Where the tracks of a terrain bend, kBent.
template <bool kBent>
class EyeLoop {
 public:
  EyeLoop(const EyeFront& front, EyeRays& rays, RaySet& set, RescueList& rescues)
      : front_(front),
        grid_(front.terrain()),
        rays_(rays),
        set_(set),
        rescues_(rescues),
        rings_(front.rings()),
        tracks_(front.terrain().layers()[0].map->eye_tracks()) {
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
    constexpr int kFirstSteps = 2;
    constexpr int kSteps = 4;
    const std::size_t lanes = hn::Lanes(D());
    for (std::size_t i = 0; i < set_.count; i += lanes) place(i);
    for (std::size_t i = 0; i < set_.count; i += lanes) step<true>(i);
    for (int j = 1; j < kFirstSteps; ++j)
      for (std::size_t i = 0; i < set_.count; i += lanes) step<false>(i);
    pack();
    while (set_.count > 0) {
      for (std::size_t i = 0; i < set_.count; i += lanes) look_ahead(i);
      for (int j = 0; j < kSteps; ++j)
        for (std::size_t i = 0; i < set_.count; i += lanes) step<false>(i);
      pack();
    }
    return tests_;
  }

 private:
  HWY_INLINE std::uint8_t& walking(std::size_t first) {
    return set_.walking[first / hn::Lanes(D())];
  }

  HWY_INLINE std::uint32_t lanes_from(std::size_t first) const {
    return (1U << std::min(hn::Lanes(D()), set_.count - first)) - 1;
  }

  HWY_INLINE V ring_at(V ring) const {
    const hn::Rebind<std::int64_t, D> longs;
    return hn::GatherIndex(D(), front_.ring_m().data(), hn::ConvertTo(longs, ring));
  }

  HWY_INLINE V floats_at(const float* values, V index) const {
    return hn::PromoteTo(D(), hn::GatherIndex(Floats(), values, hn::DemoteTo(Ints(), index)));
  }

  // The walk as it stands at rays first, first + 1, ... of the set.
  HWY_INLINE Registers ray_lines(std::size_t first) const {
    Registers r;
    r.x = load(set_.x, first);
    r.y = load(set_.y, first);
    r.slope = load(set_.slope, first);
    r.rate_u = load(set_.rate_u, first);
    r.rate_v = load(set_.rate_v, first);
    r.metres_u = load(set_.metres_u, first);
    r.metres_v = load(set_.metres_v, first);
    if constexpr (kBent) {
      r.begin = load(set_.begin, first);
      r.end = load(set_.end, first);
      r.start_u = load(set_.start_u, first);
      r.start_v = load(set_.start_v, first);
    } else {
      r.begin = of(0);
      r.end = of(front_.terrain().reach_m());
      r.start_u = of(eye_u_);
      r.start_v = of(eye_v_);
    }
    return r;
  }

  // Loads the pieces of the tracks that distances lie on, of the wanted lanes.
  HWY_INLINE void load_pieces(std::size_t first, V from_m, M wanted) {
    const std::vector<double>& knots_m = tracks_->knots_m();
    V piece = of(0);
    for (std::size_t i = 1; i + 1 < knots_m.size(); ++i)
      piece = piece + hn::IfThenElseZero(from_m >= of(knots_m[i]), of(1));
    const V sector = load(set_.sector, first);
    const hn::Rebind<std::int64_t, D> longs;
    const auto at = hn::ConvertTo(
        longs, (sector * of(tracks_->pieces()) + piece) * of(EyeTracks::kCoefficients));
    const V x = load(set_.x, first);
    const V y = load(set_.y, first);
    const auto along = [&](int i) HWY_ATTR {
      const double* c = tracks_->coefficients().data() + i;
      return hn::GatherIndex(D(), c, at) * x + hn::GatherIndex(D(), c + 1, at) * y;
    };
    const auto put = [&](EyeRays::Values& values, V value) HWY_ATTR {
      save(values, first, hn::IfThenElse(wanted, value, load(values, first)));
    };
    const auto knots = hn::ConvertTo(longs, piece);
    put(set_.piece, piece);
    put(set_.begin, hn::GatherIndex(D(), knots_m.data(), knots));
    put(set_.end, hn::GatherIndex(D(), knots_m.data() + 1, knots));
    put(set_.start_u, of(eye_u_) + along(0));
    put(set_.start_v, of(eye_v_) + along(2));
    const auto put_rate = [&](EyeRays::Values& rates, EyeRays::Values& metres, V rate) HWY_ATTR {
      const V inverse = of(1) / rate;
      const M finite = hn::Abs(inverse) < hn::Inf(D());
      put(rates, hn::IfThenElseZero(finite, rate));
      put(metres, hn::IfThenElseZero(finite, inverse));
    };
    put_rate(set_.rate_u, set_.metres_u, along(4));
    put_rate(set_.rate_v, set_.metres_v, along(6));
  }

  HWY_INLINE void load_walk(Registers& r, std::size_t first) const {
    r.column = load(set_.column, first);
    r.row = load(set_.row, first);
    r.g = load(set_.g, first);
    r.u = load(set_.u, first);
    r.v = load(set_.v, first);
    r.z = load(set_.z, first);
  }

  HWY_INLINE void save_walk(const Registers& r, std::size_t first) {
    save(set_.column, first, r.column);
    save(set_.row, first, r.row);
    save(set_.g, first, r.g);
    save(set_.u, first, r.u);
    save(set_.v, first, r.v);
    save(set_.z, first, r.z);
  }

  // Puts rays into their cells at a distance. False: that is not over the grid.
  HWY_INLINE M seat(Registers& r, V start_m) const {
    const V u = r.start_u + r.rate_u * (start_m - r.begin);
    const V v = r.start_v + r.rate_v * (start_m - r.begin);
    const V last_column = grid_.columns() - of(2);
    const V last_row = grid_.rows() - of(2);
    // Lanes without a ray may hold NaN.
    r.column = hn::IfThenElseZero(u >= of(0), hn::Min(hn::Floor(u), last_column));
    r.row = hn::IfThenElseZero(v >= of(0), hn::Min(hn::Floor(v), last_row));
    return hn::And(hn::And(u >= of(0), v >= of(0)),
                   hn::And(u <= last_column + of(1), v <= last_row + of(1)));
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

  // Puts the wanted lanes into the cells where they are at a distance, or a little before. Those
  // returned are there as the single ray's walk is.
  HWY_INLINE M settle(std::size_t first, V start_m, M wanted) {
    if constexpr (kBent) load_pieces(first, start_m, wanted);
    Registers r = ray_lines(first);
    const M seated = seat(r, start_m);
    M settled = hn::And(seated, enter(r));
    if constexpr (kBent) {
      // A cell that was entered on the piece before is too late to begin with.
      const M early = hn::And(hn::And(wanted, seated), hn::And(hn::Not(settled), r.begin > of(0)));
      if (bits_of(early) != 0) {
        const V before_m = hn::Max(r.begin - of(front_.step_back_m()), of(0));
        load_pieces(first, before_m, early);
        Registers back = ray_lines(first);
        const M back_seated = seat(back, before_m);
        const M back_settled = hn::And(back_seated, enter(back));
        settled = hn::Or(settled, hn::And(early, back_settled));
        choose(r, early, back);
      }
    }
    Registers old = r;
    load_walk(old, first);
    choose(old, wanted, r);
    save_walk(old, first);
    return settled;
  }

  // Takes the walk of `other` where `mask`.
  HWY_INLINE void choose(Registers& r, M mask, const Registers& other) const {
    r.column = hn::IfThenElse(mask, other.column, r.column);
    r.row = hn::IfThenElse(mask, other.row, r.row);
    r.g = hn::IfThenElse(mask, other.g, r.g);
    r.u = hn::IfThenElse(mask, other.u, r.u);
    r.v = hn::IfThenElse(mask, other.v, r.v);
    r.z = hn::IfThenElse(mask, other.z, r.z);
  }

  HWY_INLINE void rescue(std::size_t first, std::uint32_t lanes) {
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto i = first + static_cast<std::size_t>(__builtin_ctz(lanes));
      rescues_.rays[rescues_.count++] = static_cast<std::int32_t>(set_.index[i]);
    }
  }

  // Finds the first cells of rays first, first + 1, ..., which are those of EyeRays in order.
  HWY_INLINE void place(std::size_t first) {
    save(rays_.ground_m, first, of(-1));
    const V rise = hn::Abs(load(rays_.direction_z, first));
    const V across_x = load(rays_.direction_x, first);
    const V across_y = load(rays_.direction_y, first);
    // As is_vertical(), or nearly: those near it go the sure way. NaN too.
    const M slanted = across_x * across_x + across_y * across_y > of(4e-24) * rise * rise;
    const V start_m = floats_at(front_.starts_m(), load(set_.start, first));
    const M meets = start_m < hn::Inf(D());
    const M settled = settle(first, hn::IfThenElseZero(meets, start_m), meets);
    const std::uint32_t lanes = lanes_from(first);
    const std::uint32_t lost =
        (lanes & ~bits_of(slanted)) | (lanes & bits_of(hn::AndNot(settled, meets)));
    rescue(first, lost);
    walking(first) = static_cast<std::uint8_t>(lanes & bits_of(meets) & ~lost);
  }

  // One crossing of rays first, first + 1, ... Without branches on what they meet: which lanes are
  // settled can't be foreseen. In the first step the set's order is that of EyeRays.
  template <bool kFirst>
  HWY_INLINE void step(std::size_t first) {
    std::uint32_t active = walking(first);
    if (active == 0) return;
    Registers r = ray_lines(first);
    load_walk(r, first);
    park(r, active);
    const NextCrossing next = grid_.next_crossing(r);
    const V in = r.slope * r.g - r.z;
    const V out = r.slope * next.g - next.z;
    const std::uint32_t ground = bits_of(next.has_ground) & active;
    const std::uint32_t cut = bits_of(next.g > r.end) & active;
    // Also those whose last piece ends: the grid does before, but for rounding.
    const std::uint32_t ended = cut & bits_of(r.end >= of(front_.terrain().reach_m()));
    std::uint32_t lost = (bits_of(in < of(0)) & ground & ~cut) | ended;
    const std::uint32_t hit = bits_of(hn::And(out <= of(0), next.g > r.g)) & ground & ~(lost | cut);
    tests_ += __builtin_popcount(ground & ~cut);
    const V share = hn::IfThenElseZero(in > of(0), in / (in - out));
    const Registers met = between(r, next, share);
    if constexpr (kFirst) {
      record_in_order(met, hit, first);
    } else {
      record(met, hit, first);
    }
    const Registers here = r;
    advance(r, next);
    if constexpr (kBent) choose(r, mask_of(cut), here);
    const std::uint32_t outside = ~bits_of(grid_.is_inside(r)) & active & ~(hit | lost);
    active &= ~(hit | lost | outside);
    save_walk(r, first);
    if constexpr (kBent) {
      lost |= outside & returning(first, outside);
      for (std::uint32_t left = cut & active; left != 0; left &= left - 1)
        next_piece(first + static_cast<std::size_t>(__builtin_ctz(left)));
    }
    walking(first) = static_cast<std::uint8_t>(active);
    rescue(first, lost);
  }

  // A ray goes on along the next piece of its track, in the same cell.
  void next_piece(std::size_t i) {
    const TrackPiece piece =
        tracks_->piece({set_.x[i], set_.y[i]}, set_.end[i], front_.terrain().reach_m());
    set_.piece[i] += 1;
    set_.begin[i] = piece.begin_m;
    set_.end[i] = piece.end_m;
    set_.start_u[i] = piece.start.x;
    set_.start_v[i] = piece.start.y;
    set_.rate_u[i] = piece.rate.x;
    set_.rate_v[i] = piece.rate.y;
    set_.metres_u[i] = piece.metres.x;
    set_.metres_v[i] = piece.metres.y;
  }

  // Of lanes that have left the grid, those whose tracks come back.
  std::uint32_t returning(std::size_t first, std::uint32_t outside) const {
    std::uint32_t back = 0;
    const TerrainLayer& layer = front_.terrain().layers()[0];
    const double reach_m = front_.terrain().reach_m();
    for (std::uint32_t left = outside; left != 0; left &= left - 1) {
      const auto i = first + static_cast<std::size_t>(__builtin_ctz(left));
      if (set_.end[i] >= reach_m) continue;
      const GroundLine line{{0, 0}, {set_.x[i], set_.y[i]}};
      GridWalk walk(*layer.grid, *layer.map, front_.terrain().model(), line, set_.end[i], reach_m);
      if (walk.over_grid()) back |= 1U << __builtin_ctz(left);
    }
    return back;
  }

  HWY_INLINE Registers between(const Registers& r, const NextCrossing& next, V share) const {
    Registers met = r;
    met.g = r.g + share * (next.g - r.g);
    met.u = r.u + share * (next.u - r.u);
    met.v = r.v + share * (next.v - r.v);
    return met;
  }

  HWY_INLINE void record_in_order(const Registers& met, std::uint32_t hit, std::size_t first) {
    const M mask = mask_of(hit);
    hn::BlendedStore(met.g, mask, D(), rays_.ground_m.data() + first);
    hn::BlendedStore(met.u, mask, D(), rays_.u.data() + first);
    hn::BlendedStore(met.v, mask, D(), rays_.v.data() + first);
    hn::BlendedStore(met.column, mask, D(), rays_.column.data() + first);
    hn::BlendedStore(met.row, mask, D(), rays_.row.data() + first);
  }

  HWY_INLINE void record(const Registers& met, std::uint32_t hit, std::size_t first) {
    alignas(64) std::array<double, kVectorLanes> lanes[5];
    hn::Store(met.g, D(), lanes[0].data());
    hn::Store(met.u, D(), lanes[1].data());
    hn::Store(met.v, D(), lanes[2].data());
    hn::Store(met.column, D(), lanes[3].data());
    hn::Store(met.row, D(), lanes[4].data());
    for (; hit != 0; hit &= hit - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(hit));
      const auto i = static_cast<std::size_t>(set_.index[first + lane]);
      rays_.ground_m[i] = lanes[0][lane];
      rays_.u[i] = lanes[1][lane];
      rays_.v[i] = lanes[2][lane];
      rays_.column[i] = lanes[3][lane];
      rays_.row[i] = lanes[4][lane];
    }
  }

  void move(std::size_t from, std::size_t to) {
    set_.move(from, to);
    if constexpr (kBent) set_.move_piece(from, to);
  }

  // Moves the rays that walk to the front of the set.
  void pack() {
    std::size_t kept = 0;
    for (std::size_t first = 0; first < set_.count; first += hn::Lanes(D()))
      for (std::uint32_t left = walking(first); left != 0; left &= left - 1)
        move(first + static_cast<std::size_t>(__builtin_ctz(left)), kept++);
    set_.count = kept;
    // Lanes past the last ray are computed all the same.
    for (std::size_t i = kept; i % kVectorLanes != 0; ++i) move(kept - 1, i);
    for (std::size_t first = 0; first < kept; first += hn::Lanes(D()))
      walking(first) = static_cast<std::uint8_t>(lanes_from(first));
  }

  // Takes rays over the sectors that they clear; those that clear all there are have missed.
  HWY_INLINE void look_ahead(std::size_t first) {
    const std::uint32_t lanes = lanes_from(first);
    Registers r = ray_lines(first);
    load_walk(r, first);
    const V wedge = hn::Floor(load(set_.start, first) * of(1.0 / EyeFront::kStartBins));
    const V here = ring_of(first);
    const V beyond = floats_at(
        front_.bounds_beyond(),
        in_group(wedge, hn::Floor(here * of(1.0 / EyeFront::kStride)), front_.coarse_rings()));
    const V from = hn::IfThenElse(beyond < r.slope, of(rings_), here);
    const V ring = search(from, r.slope, wedge, lanes);
    const M missed = ring >= of(rings_);
    const V known = hn::Min(ring, of(rings_ - 1));
    walking(first) = static_cast<std::uint8_t>(lanes & ~bits_of(missed));
    // A leap may settle a little before its end, and must go forward all the same.
    const M far = ring_at(known) > r.g + of(kBent ? 2 * front_.step_back_m() : 0);
    const M leaps = hn::And(ring > here, far);
    if ((bits_of(leaps) & walking(first)) == 0) return;

    const V bound = sector_bound(wedge, known);
    const V down_m = hn::IfThenElseZero(
        bound < of(0), ring_at(known + of(1)) * (hn::Max(bound, r.slope) / r.slope));
    const V start_m = hn::Max(ring_at(known), down_m) - of(front_.margin_m());
    const M settled = settle(first, start_m, leaps);
    const std::uint32_t lost = walking(first) & bits_of(hn::AndNot(settled, leaps));
    rescue(first, lost);
    walking(first) = static_cast<std::uint8_t>(walking(first) & ~lost);
  }

  HWY_INLINE V ring_of(std::size_t first) const {
    alignas(64) std::array<double, kVectorLanes> rings;
    for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane)
      rings[lane] = front_.ring_of(set_.g[first + lane]);
    return hn::Load(D(), rings.data());
  }

  // The bound of a ring in a wedge; infinite past the last ring.
  HWY_INLINE V sector_bound(V wedge, V ring) const {
    return floats_at(front_.bounds(), in_group(wedge, ring, rings_ + 1));
  }

  HWY_INLINE V in_group(V wedge, V ring, int rings) const {
    constexpr int kGroup = EyeFront::kGroup;
    const V group = hn::Floor(wedge * of(1.0 / kGroup));
    return (group * of(rings) + ring) * of(kGroup) + (wedge - group * of(kGroup));
  }

  // The first ring from `ring` on whose bound reaches the slope.
  HWY_INLINE V search(V ring, V slope, V wedge, std::uint32_t lanes) const {
    constexpr int kStride = EyeFront::kStride;
    while (true) {
      const M below = sector_bound(wedge, ring) < slope;
      if ((bits_of(below) & lanes) == 0) return ring;
      const V block = hn::Floor(ring * of(1.0 / kStride));
      const V coarse =
          floats_at(front_.coarse_bounds(), in_group(wedge, block, front_.coarse_rings()));
      const M leap = hn::And(block * of(kStride) == ring, coarse < slope);
      ring = ring + hn::IfThenElseZero(below, hn::IfThenElse(leap, of(kStride), of(1)));
    }
  }

  const EyeFront& front_;
  VectorGrid grid_;
  EyeRays& rays_;
  RaySet& set_;
  RescueList& rescues_;
  int rings_;
  const EyeTracks* tracks_;
  double eye_u_ = 0;
  double eye_v_ = 0;
  // Where the eye is not over ground, no cell is its cell.
  double eye_column_ = -2;
  double eye_row_ = -2;
  double eye_z_ = 0;
  std::int64_t tests_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif
