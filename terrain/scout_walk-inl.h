// Walks of rays from the eye over the grid, in single precision with a bound. Included once for
// every instruction set.
//
// A line of posts is crossed where the closed form says, or less than `stray` posts beside. The ray
// is clear of an edge, or below it, only by more than that and the rounding of heights are worth;
// nearer than that to an edge it is unsure. So all edges before the first one that a ray is below
// have been crossed by the exact walk too, and cleared: the hit, if it proves one in doubles, is
// the first.
#if defined(TERRVIEW_TERRAIN_SCOUT_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_SCOUT_WALK_INL_H_
#undef TERRVIEW_TERRAIN_SCOUT_WALK_INL_H_
#else
#define TERRVIEW_TERRAIN_SCOUT_WALK_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>

#include "terrain/terrain.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_masks-inl.h"
#include "terrain/vertical_math.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The Earth and the tracks of lines over the grid.
enum class Ground { flat, curved, bent };

template <Ground kGround>
class ScoutWalk {
 public:
  using F = hn::CappedTag<float, 16>;
  using I = hn::RebindToSigned<F>;
  using VF = hn::Vec<F>;
  using VI = hn::Vec<I>;
  using MF = hn::Mask<F>;

  // Lines u = base + rate * g, in posts from the eye's cell, and where the walks stand on them.
  struct Walk {
    VF base_u, base_v, rate_u, rate_v, metres_u, metres_v;
    VF end;               // of the piece of a bent track
    VF slope, curvature;  // of the ray; of the Earth below it
    VF column, row, g;
  };
  struct Fates {
    MF active, hit, unsure;
    MF at_knot;  // their tracks go on with another piece
  };

  // On no line are more than `posts_per_m` posts passed a metre, along u or v. Walks begin where
  // they are clear for `margin_m` more.
  ScoutWalk(const Terrain& terrain, double posts_per_m, double margin_m)
      : grid_(*terrain.layers()[0].grid),
        frame_(terrain.frame()),
        scale_(static_cast<float>(frame_.z_scale)),
        eye_height_m_(static_cast<float>(frame_.eye_height_m)),
        margin_m_(static_cast<float>(margin_m)),
        stray_growth_(kPlaceGrowth * static_cast<float>(posts_per_m)),
        last_post_(static_cast<std::uint32_t>(grid_.heights_m.size() - 1)),
        height_terms_(
            static_cast<float>(2 * terrain.height_bound_m() + std::abs(frame_.eye_height_m))),
        beside_post_m_(static_cast<float>(8 * terrain.height_bound_m())) {
    const glm::dvec2 eye_uv = terrain.layers()[0].map->to_grid({0, 0});
    const glm::dvec2 cell = glm::floor(eye_uv);
    eye_u_ = static_cast<float>(eye_uv.x - cell.x);
    eye_v_ = static_cast<float>(eye_uv.y - cell.y);
    first_column_ = static_cast<float>(-cell.x);
    last_column_ = static_cast<float>(grid_.columns - 2 - cell.x);
    first_row_ = static_cast<float>(-cell.y);
    last_row_ = static_cast<float>(grid_.rows - 2 - cell.y);
  }

  // The eye, in posts from its cell.
  VEC_INLINE VF eye_u() const { return of(eye_u_); }
  VEC_INLINE VF eye_v() const { return of(eye_v_); }
  // The cells of walks, in the grid.
  VEC_INLINE VF column_of(const Walk& w) const { return w.column - of(first_column_); }
  VEC_INLINE VF row_of(const Walk& w) const { return w.row - of(first_row_); }
  // 1 / R along directions from the eye.
  VEC_INLINE VF curvature(VF x, VF y) const {
    return x * x * of(static_cast<float>(frame_.east_curvature_per_m)) +
           y * y * of(static_cast<float>(frame_.north_curvature_per_m));
  }
  // Cells compared with rays.
  [[nodiscard]] std::int64_t tests() const { return tests_; }

  // Puts the active walks into their cells. They are unsure at the border of the grid, and beside
  // lines that they cross so slowly that they may be further from them than they are clear.
  VEC_INLINE void seat(Walk& w, Fates& fates) const {
    const VF u = w.rate_u * w.g + w.base_u;
    const VF v = w.rate_v * w.g + w.base_v;
    w.column = hn::Floor(u);
    w.row = hn::Floor(v);
    const VF stray = stray_at(w.g);
    const MF inside_u = hn::And(u - stray > of(first_column_), u + stray < of(last_column_ + 1));
    const MF inside_v = hn::And(v - stray > of(first_row_), v + stray < of(last_row_ + 1));
    const MF tells = hn::And(tells_side(u, stray, w.metres_u), tells_side(v, stray, w.metres_v));
    const MF seated = hn::And(hn::And(inside_u, inside_v), tells);
    fates.unsure = hn::Or(fates.unsure, hn::AndNot(seated, fates.active));
    fates.active = hn::And(fates.active, seated);
  }

  // Up to kCells cells. Those that hit stay in theirs; those that leave the grid are done.
  VEC_INLINE void cross_cells(Walk& w, Fates& fates) {
    Course course = course_of(w);
    for (int i = 0; i < kCells && !hn::AllFalse(F(), fates.active); ++i) cross(w, course, fates);
    const MF outside = hn::Not(is_inside(w));
    fates.unsure = hn::Or(fates.unsure, hn::And(outside, fates.hit));
    // Bent tracks may come back.
    if constexpr (kGround == Ground::bent)
      fates.unsure = hn::Or(fates.unsure, hn::And(outside, fates.active));
    fates.hit = hn::AndNot(outside, fates.hit);
    fates.active = hn::AndNot(outside, fates.active);
  }

 private:
  static constexpr int kCells = 8;

  // Rounding of a sum of a few terms, as a share of them; of a place, in posts, and how that grows
  // with the posts that are passed.
  static constexpr float kRounding = 0x1p-20F;
  static constexpr float kPlace = 0x1p-20F;
  static constexpr float kPlaceGrowth = 0x1p-20F;

  static VEC_INLINE VF of(float x) { return hn::Set(F(), x); }
  static VEC_INLINE VI of_int(std::int32_t x) { return hn::Set(I(), x); }

  // How far places on the line are off, in posts.
  VEC_INLINE VF stray_at(VF g) const { return of(stray_growth_) * g + of(kPlace); }

  VEC_INLINE MF tells_side(VF place, VF stray, VF metres) const {
    return hn::Or(hn::Abs(place - hn::Round(place)) > stray,
                  stray * hn::Abs(metres) < of(margin_m_));
  }

  // What does not change while a ray crosses a few cells. A walk leaves a cell over a column or a
  // row; of both, the next line ahead, the step beyond, and how far off the crossing may be.
  struct Course {
    VF ahead_u, ahead_v;    // 0 or 1: from a cell's first line to the one that is met
    VF before_u, before_v;  // metres before the eye's cell, of lines met
    VF step_u, step_v;
    VI post_ahead_u, post_ahead_v, post_step_u, post_step_v;
    VF stray_u, stray_v;  // of the place between two posts
    VF slack_u, slack_v;  // of heights
    // The cell, and its first post. They go on whatever the ray meets, so that the cells ahead need
    // not wait for the heights of this one.
    VF column, row;
    VI post;
  };

  VEC_INLINE Course course_of(const Walk& w) const {
    Course c;
    const MF east = w.rate_u > of(0);
    const MF south = w.rate_v > of(0);
    const auto ints = [](MF mask, std::int32_t yes, std::int32_t no) HWY_ATTR {
      return hn::IfThenElse(hn::RebindMask(I(), mask), of_int(yes), of_int(no));
    };
    c.ahead_u = hn::IfThenElseZero(east, of(1));
    c.ahead_v = hn::IfThenElseZero(south, of(1));
    c.before_u = (c.ahead_u - w.base_u) * w.metres_u;
    c.before_v = (c.ahead_v - w.base_v) * w.metres_v;
    c.step_u = hn::IfThenElse(east, of(1), of(-1));
    c.step_v = hn::IfThenElse(south, of(1), of(-1));
    c.post_ahead_u = ints(east, 1, 0);
    c.post_ahead_v = ints(south, grid_.columns, 0);
    c.post_step_u = ints(east, 1, -1);
    c.post_step_v = ints(south, grid_.columns, -grid_.columns);
    const VF metres_u = hn::Abs(w.metres_u);
    const VF metres_v = hn::Abs(w.metres_v);
    const VF furthest_m = w.g + of(kCells) * hn::Min(metres_u, metres_v);
    const VF stray = of(stray_growth_) * furthest_m + of(kPlace);
    const VF off_u = stray * metres_u;
    const VF off_v = stray * metres_v;
    c.stray_u = stray + off_u * hn::Abs(w.rate_v);
    c.stray_v = stray + off_v * hn::Abs(w.rate_u);
    const VF slope = hn::Abs(w.slope);
    VF terms = slope * furthest_m + of(height_terms_);
    VF rate = slope;
    if constexpr (kGround != Ground::flat) {
      const VF gamma = furthest_m * w.curvature;
      terms = of(2) * (terms + furthest_m * gamma);
      rate = of(2) * (slope + gamma);
    }
    c.slack_u = of(kRounding) * terms + rate * off_u;
    c.slack_v = of(kRounding) * terms + rate * off_v;
    c.column = w.column;
    c.row = w.row;
    c.post =
        hn::ConvertTo(I(), row_of(w)) * of_int(grid_.columns) + hn::ConvertTo(I(), column_of(w));
    return c;
  }

  // The height of a post; beyond the grid, of another.
  VEC_INLINE VF post_at(VI post) const {
    const hn::RebindToUnsigned<F> unsigned_ints;
    const VI known = hn::BitCast(
        I(), hn::Min(hn::BitCast(unsigned_ints, post), hn::Set(unsigned_ints, last_post_)));
    return hn::GatherIndex(F(), grid_.heights_m.data(), known);
  }

  // The scene height of a ray.
  VEC_INLINE VF height_at(const Walk& w, VF g) const {
    if constexpr (kGround == Ground::flat) return hn::MulAdd(w.slope, g, of(eye_height_m_));
    const VF gamma = g * w.curvature;
    const VF gamma2 = gamma * gamma;
    const VF half_refraction = of(static_cast<float>(frame_.refraction / 2));
    const VF drop = g * gamma * (half_refraction - series(kHalfTangent, gamma2));
    const VF up = (w.slope * g - drop) / series(kInverseSinc, gamma2);
    return (up + of(eye_height_m_)) / (of(1) - w.curvature * up);
  }

  static VEC_INLINE VF series(const std::array<double, 6>& coefficients, VF x) {
    VF sum = of(static_cast<float>(coefficients[5]));
    for (std::size_t i = 5; i-- > 0;)
      sum = hn::MulAdd(sum, x, of(static_cast<float>(coefficients[i])));
    return sum;
  }

  // One cell; beyond the grid, a cell of what is not ground.
  VEC_INLINE void cross(Walk& w, Course& c, Fates& fates) {
    const VF g_u = hn::MulAdd(c.column, w.metres_u, c.before_u);
    const VF g_v = hn::MulAdd(c.row, w.metres_v, c.before_v);
    const MF over_column = g_u <= g_v;
    const auto over_column_i = hn::RebindMask(I(), over_column);
    const VF g = hn::Min(g_u, g_v);
    if constexpr (kGround == Ground::bent) {
      const MF beyond = hn::And(fates.active, g >= w.end);
      fates.at_knot = hn::Or(fates.at_knot, beyond);
      fates.active = hn::AndNot(beyond, fates.active);
    }
    const VF place = hn::MulAdd(hn::IfThenElse(over_column, w.rate_v, w.rate_u), g,
                                hn::IfThenElse(over_column, w.base_v, w.base_u));
    const VF share = place - hn::IfThenElse(over_column, c.row, c.column);
    const VI post = c.post + hn::IfThenElse(over_column_i, c.post_ahead_u, c.post_ahead_v);
    const VI further = hn::IfThenElse(over_column_i, of_int(grid_.columns), of_int(1));
    const VF from = post_at(post);
    const VF climb = post_at(post + further) - from;
    const VF above = hn::NegMulAdd(of(scale_), hn::MulAdd(share, climb, from), height_at(w, g));
    const VF stray = hn::IfThenElse(over_column, c.stray_u, c.stray_v);
    const VF slack = hn::MulAdd(stray * of(scale_), hn::Abs(climb),
                                hn::IfThenElse(over_column, c.slack_u, c.slack_v));
    // Beside a post the exact walk may cross other edges that end there, nearer than this to it.
    const MF at_post = hn::Abs(share - of(0.5F)) >= of(0.5F) - stray;
    const VF far = hn::IfThenElse(at_post, hn::MulAdd(stray, of(beside_post_m_), slack), slack);
    const MF clear = above > far;
    const MF below = hn::AndNot(at_post, above < hn::Neg(slack));
    tests_ += __builtin_popcount(mask_bits(F(), fates.active));
    fates.hit = hn::Or(fates.hit, hn::And(fates.active, below));
    fates.unsure = hn::Or(fates.unsure, hn::AndNot(hn::Or(clear, below), fates.active));
    fates.active = hn::And(fates.active, clear);
    w.g = hn::IfThenElse(fates.active, g, w.g);
    c.column = hn::IfThenElse(over_column, c.column + c.step_u, c.column);
    c.row = hn::IfThenElse(over_column, c.row, c.row + c.step_v);
    w.column = hn::IfThenElse(fates.active, c.column, w.column);
    w.row = hn::IfThenElse(fates.active, c.row, w.row);
    c.post = c.post + hn::IfThenElse(over_column_i, c.post_step_u, c.post_step_v);
  }

  VEC_INLINE MF is_inside(const Walk& w) const {
    return hn::And(hn::And(w.column >= of(first_column_), w.column <= of(last_column_)),
                   hn::And(w.row >= of(first_row_), w.row <= of(last_row_)));
  }

  const HeightGrid& grid_;
  const VerticalFrame& frame_;
  float scale_;
  float eye_height_m_;
  float margin_m_;
  float stray_growth_;
  std::uint32_t last_post_;
  float height_terms_;
  // What edges that end at a post may differ by: each climbs by twice the highest height at most,
  // and the places on two may both be off.
  float beside_post_m_;
  float eye_u_;
  float eye_v_;
  float first_column_, last_column_, first_row_, last_row_;  // of cells, from the eye's
  std::int64_t tests_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif
