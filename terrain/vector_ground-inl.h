// The ground under several rays at once, lane by lane in double precision, with the arithmetic of
// the scalar walk: VerticalFrame, GridWalk. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_VECTOR_GROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_VECTOR_GROUND_INL_H_
#undef TERRVIEW_TERRAIN_VECTOR_GROUND_INL_H_
#else
#define TERRVIEW_TERRAIN_VECTOR_GROUND_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "terrain/terrain.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_masks-inl.h"
#include "terrain/vertical_math.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr std::size_t kVectorLanes = 8;
using D = hn::CappedTag<double, kVectorLanes>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

VEC_INLINE V of(double x) { return hn::Set(D(), x); }

VEC_INLINE V series(const std::array<double, 6>& coefficients, V x) {
  V sum = of(coefficients[5]);
  for (std::size_t i = 5; i-- > 0;) sum = of(coefficients[i]) + x * sum;
  return sum;
}

VEC_INLINE std::uint32_t bits_of(M mask) { return mask_bits(D(), mask); }
VEC_INLINE M mask_of(std::uint32_t bits) { return mask_from(D(), bits); }

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

  VEC_INLINE V z(V x, V y, V height) const {
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

  // 1 / R towards a point.
  VEC_INLINE V curvature(V x, V y) const {
    const V x2 = x * x;
    const V y2 = y * y;
    const V s2 = x2 + y2;
    return hn::IfThenElse(s2 > of(0), (x2 * east_ + y2 * north_) / s2, north_);
  }

  // Nearly VerticalFrame::at({x, y}).scene_height_m(z) / z_scale, over an Earth of this curvature.
  VEC_INLINE V height(V x, V y, V z, V curvature) const {
    if (flat_) return (z + eye_) / scale_;
    const V s2_over_r = x * x * east_ + y * y * north_;
    const V gamma2 = s2_over_r * curvature;
    const V drop = s2_over_r * (half_refraction_ - series(kHalfTangent, gamma2));
    const V w = (z - drop) / series(kInverseSinc, gamma2);
    return (w + eye_) / ((of(1) - curvature * w) * scale_);
  }

 private:
  bool flat_;
  V eye_;
  V scale_;
  V north_;
  V east_;
  V half_refraction_;
};

// Posts per metre along a track and the inverse, as set_metres() has them.
struct VectorRate {
  V rate, metres;
};
VEC_INLINE VectorRate invertible(V rate) {
  const V metres = of(1) / rate;
  const M is_finite = hn::Abs(metres) < hn::Inf(D());
  return {hn::IfThenElseZero(is_finite, rate), hn::IfThenElseZero(is_finite, metres)};
}

// Whether a direction is not that of a vertical ray, as is_vertical() has it, nor nearly: those
// near it go the sure way. NaN is not.
VEC_INLINE M is_slanted(V x, V y, V z) { return x * x + y * y > of(4e-24) * z * z; }

// The lanes of a vector from `first` on that are below `count`.
VEC_INLINE std::uint32_t lanes_below(std::size_t count, std::size_t first) {
  return (1U << std::min(hn::Lanes(D()), count - first)) - 1;
}

// The ground lines under directions from the eye, and the slope of the rays over them.
struct VectorLine {
  V x, y, slope;
};
VEC_INLINE VectorLine line_under(V x, V y, V z) {
  const V inverse = of(1) / hn::Sqrt(x * x + y * y);
  return {x * inverse, y * inverse, z * inverse};
}

// How a straight line goes over the posts of an affine map.
struct LinearRates {
  VectorRate u, v;
};
VEC_INLINE LinearRates rates_along(const VectorLine& line, const glm::dmat2& jacobian) {
  const glm::dmat2& j = jacobian;
  return {invertible(of(j[0][0]) * line.x + of(j[1][0]) * line.y),
          invertible(of(j[0][1]) * line.x + of(j[1][1]) * line.y)};
}

// Jacobians of maps.
struct VectorSlopes {
  V u_by_x, v_by_x, u_by_y, v_by_y;
};
VEC_INLINE VectorSlopes all_lanes(const glm::dmat2& jacobian) {
  return {of(jacobian[0].x), of(jacobian[0].y), of(jacobian[1].x), of(jacobian[1].y)};
}

// The heights at the corners of cells.
struct Corners {
  V nw, ne, sw, se;
};

// The posts of one grid.
class VectorPosts {
 public:
  explicit VectorPosts(const HeightGrid& grid)
      : heights_m_(grid.heights_m.data()), columns_(static_cast<std::size_t>(grid.columns)) {}

  // The heights of the posts with these indices.
  VEC_INLINE V at(V index) const {
    const hn::Rebind<float, D> floats;
    const hn::Rebind<std::int32_t, D> ints;
    return hn::PromoteTo(D(), hn::GatherIndex(floats, heights_m_, hn::DemoteTo(ints, index)));
  }

  // The corners of the cells whose first posts have these indices.
  VEC_INLINE Corners corners(V post) const {
#if HWY_TARGET == HWY_SCALAR
    const V south_post = post + of(static_cast<double>(columns_));
    return {at(post), at(post + of(1)), at(south_post), at(south_post + of(1))};
#else
    const hn::Rebind<std::int32_t, D> ints;
    alignas(64) std::array<std::int32_t, kVectorLanes> posts;
    hn::Store(hn::DemoteTo(ints, post), ints, posts.data());
    // Two posts lie side by side: loads of both together take half as long as gathers.
    const auto north = pairs<kLanes>(heights_m_, posts.data());
    const auto south = pairs<kLanes>(heights_m_ + columns_, posts.data());
    const Pairs<kLanes> d;
    const auto west = hn::ConcatEven(d, south, north);
    const auto east = hn::ConcatOdd(d, south, north);
    return {hn::PromoteTo(D(), hn::LowerHalf(west)), hn::PromoteTo(D(), hn::LowerHalf(east)),
            hn::PromoteTo(D(), hn::UpperHalf(half_, west)),
            hn::PromoteTo(D(), hn::UpperHalf(half_, east))};
#endif
  }

 private:
#if HWY_TARGET != HWY_SCALAR
  static constexpr std::size_t kLanes = hn::MaxLanes(D());
  template <std::size_t kCount>
  using Pairs = hn::CappedTag<float, 2 * kCount>;
  static constexpr hn::Rebind<float, D> half_{};

  // Posts index[i] and index[i] + 1 as elements 2 i and 2 i + 1.
  template <std::size_t kCount>
  static VEC_INLINE hn::Vec<Pairs<kCount>> pairs(const float* heights_m,
                                                 const std::int32_t* index) {
    if constexpr (kCount == 1) {
      return hn::LoadU(Pairs<1>(), heights_m + *index);
    } else {
      constexpr std::size_t kHalf = kCount / 2;
      return hn::Combine(Pairs<kCount>(), pairs<kHalf>(heights_m, index + kHalf),
                         pairs<kHalf>(heights_m, index));
    }
  }
#endif

  const float* heights_m_;
  std::size_t columns_;
};

// The state of a walk over the grid: GridWalk's, and the ground's z at the last crossing.
struct Registers {
  V column, row, g, u, v, z;
  // The piece of the track.
  V begin, end, start_u, start_v, rate_u, rate_v, metres_u, metres_v;
  // The direction of the ground line, and the slope of the ray.
  V x, y, slope;
};

// Lanes that have ended are computed all the same: they stand still in a cell of the grid.
VEC_INLINE void park(Registers& r, std::uint32_t active) {
  const M moving = mask_of(active);
  r.column = hn::IfThenElseZero(moving, r.column);
  r.row = hn::IfThenElseZero(moving, r.row);
  r.rate_u = hn::IfThenElseZero(moving, r.rate_u);
  r.rate_v = hn::IfThenElseZero(moving, r.rate_v);
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
        posts_(*terrain.layers()[0].grid),
        columns_(of(terrain.layers()[0].grid->columns)),
        rows_(of(terrain.layers()[0].grid->rows)) {}

  // The corners of the cells that the walks stand in.
  VEC_INLINE Corners corners(const Registers& r) const {
    return posts_.corners(r.row * columns_ + r.column);
  }

  VEC_INLINE NextCrossing next_crossing(const Registers& r, const Corners& corners) const {
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
    next.u = hn::IfThenElse(next.over_column, column_line, u);
    next.v = hn::IfThenElse(next.over_column, v, row_line);
    next.z = edge_z(r, corners, {next.over_column, r.rate_u > of(0), r.rate_v > of(0)},
                    {next.g, next.u, next.v});
    const V sum = corners.nw + corners.ne + corners.sw + corners.se;
    next.has_ground = sum == sum;
    return next;
  }

  // Where the walk came into the cell in which `r` stands, through the edge last crossed. True: it
  // did come into it, and not over the grid's border or next to the piece's start, where by
  // rounding the piece before may have crossed the edge too.
  VEC_INLINE M enter_cell(Registers& r, const Corners& corners) const {
    V column_line;
    V row_line;
    V column_out;
    V row_out;
    const V column_in =
        came_in(r, r.column, r.start_u, r.rate_u, r.metres_u, column_line, column_out);
    const V row_in = came_in(r, r.row, r.start_v, r.rate_v, r.metres_v, row_line, row_out);
    // At a corner the walk crosses columns first.
    const M visited = hn::And(column_in <= row_out, row_in < column_out);
    const M over_column = column_in > row_in;
    r.g = hn::IfThenElse(over_column, column_in, row_in);

    const V along = r.g - r.begin;
    const V u = clamp(r.start_u + r.rate_u * along, r.column);
    const V v = clamp(r.start_v + r.rate_v * along, r.row);
    r.u = hn::IfThenElse(over_column, column_line, u);
    r.v = hn::IfThenElse(over_column, v, row_line);
    r.z = edge_z(r, corners, {over_column, hn::Not(r.rate_u > of(0)), hn::Not(r.rate_v > of(0))},
                 {r.g, r.u, r.v});

    const V line = hn::IfThenElse(over_column, column_line, row_line);
    const V last_line = hn::IfThenElse(over_column, columns_, rows_) - of(1);
    const V metres = hn::Abs(hn::IfThenElse(over_column, r.metres_u, r.metres_v));
    const M on_piece = along > of(kStart_posts) * metres;
    return hn::And(hn::And(visited, on_piece), hn::And(line > of(0), line < last_line));
  }

  VEC_INLINE V columns() const { return columns_; }
  VEC_INLINE V rows() const { return rows_; }

  VEC_INLINE M is_inside(const Registers& r) const {
    return hn::And(hn::And(r.column >= of(0), r.row >= of(0)),
                   hn::And(r.column < columns_ - of(1), r.row < rows_ - of(1)));
  }

 private:
  // Next to the start of a piece: far more than places are rounded by.
  static constexpr double kStart_posts = 0x1p-16;

  // An edge of a cell: along a column of posts, or a row; the eastern one, the southern one.
  struct Edge {
    M over_column, east, south;
  };
  // A place on an edge.
  struct Place {
    V g, u, v;
  };

  // z of the ground where a walk crosses an edge of its cell.
  VEC_INLINE V edge_z(const Registers& r, const Corners& c, const Edge& edge,
                      const Place& at) const {
    const V from = hn::IfThenElse(edge.over_column, hn::IfThenElse(edge.east, c.ne, c.nw),
                                  hn::IfThenElse(edge.south, c.sw, c.nw));
    const V to = hn::IfThenElse(edge.over_column, hn::IfThenElse(edge.east, c.se, c.sw),
                                hn::IfThenElse(edge.south, c.se, c.ne));
    const V share = hn::IfThenElse(edge.over_column, at.v - r.row, at.u - r.column);
    return frame_.z(r.x * at.g, r.y * at.g, from + share * (to - from));
  }

  // Where a line of the grid is met, never before the last crossing.
  VEC_INLINE V meets(const Registers& r, V cell, V start, V rate, V metres, V& line) const {
    line = hn::IfThenElse(rate > of(0), cell + of(1), cell);
    const V g = hn::Max(r.g, r.begin + (line - start) * metres);
    return hn::IfThenElse(rate == of(0), hn::Inf(D()), g);
  }

  // Where the walk crosses into a cell's column or row; and the line, and where it goes out.
  VEC_INLINE V came_in(const Registers& r, V cell, V start, V rate, V metres, V& line,
                       V& out) const {
    const M forward = rate > of(0);
    const M still = rate == of(0);
    line = hn::IfThenElse(forward, cell, cell + of(1));
    const V line_out = hn::IfThenElse(forward, cell + of(1), cell);
    out = hn::IfThenElse(still, hn::Inf(D()), r.begin + (line_out - start) * metres);
    return hn::IfThenElse(still, hn::Neg(hn::Inf(D())), r.begin + (line - start) * metres);
  }

  VEC_INLINE V clamp(V value, V cell) const { return hn::Min(hn::Max(value, cell), cell + of(1)); }

  VectorFrame frame_;
  VectorPosts posts_;
  V columns_;
  V rows_;
};

VEC_INLINE void advance(Registers& r, const NextCrossing& next) {
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

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif
