#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ingest/patch_vectors.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "ingest/patch_vectors.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

struct VectorPoint {
  V x, y;
};

VEC_INLINE VectorPoint multiply_add(const VectorPoint& a, V b, const VectorPoint& c) {
  return {a.x * b + c.x, a.y * b + c.y};
}
VEC_INLINE VectorPoint choose(M mask, const VectorPoint& a, const VectorPoint& b) {
  return {hn::IfThenElse(mask, a.x, b.x), hn::IfThenElse(mask, a.y, b.y)};
}
VEC_INLINE V choose(M mask, V a, V b) { return hn::IfThenElse(mask, a, b); }
VEC_INLINE VectorPoint all_lanes(glm::dvec2 point) { return {of(point.x), of(point.y)}; }

VEC_INLINE VectorSlopes multiply_add(const VectorSlopes& a, V b, const VectorSlopes& c) {
  return {a.u_by_x * b + c.u_by_x, a.v_by_x * b + c.v_by_x, a.u_by_y * b + c.u_by_y,
          a.v_by_y * b + c.v_by_y};
}
VEC_INLINE VectorSlopes choose(M mask, const VectorSlopes& a, const VectorSlopes& b) {
  return {hn::IfThenElse(mask, a.u_by_x, b.u_by_x), hn::IfThenElse(mask, a.v_by_x, b.v_by_x),
          hn::IfThenElse(mask, a.u_by_y, b.u_by_y), hn::IfThenElse(mask, a.v_by_y, b.v_by_y)};
}

// As the scalar patch: terms of x^i y^j, i + j < kRows, by i, then j.
template <std::size_t kRows, class Terms>
VEC_INLINE auto polynomial(const GroundPatch& patch, const Terms& terms, const VectorPoint& at) {
  const glm::dvec2 centre_m = patch.square().centre_m;
  const V scale = of(patch.shares_per_m());
  const V x = (at.x - of(centre_m.x)) * scale;
  const V y = (at.y - of(centre_m.y)) * scale;
  auto sum = all_lanes(typename Terms::value_type(0));
  std::size_t row = terms.size();
  for (std::size_t length = 1; length <= kRows; ++length) {
    row -= length;
    auto inner = all_lanes(terms[row + length - 1]);
    for (std::size_t j = length - 1; j-- > 0;)
      inner = multiply_add(inner, y, all_lanes(terms[row + j]));
    sum = multiply_add(sum, x, inner);
  }
  return sum;
}

// What is asked of a leaf.
struct SlopesAt {
  const VectorPoint& point;
  VEC_INLINE VectorSlopes on(const PatchTree::Leaf& leaf) const {
    return polynomial<GroundPatch::kDegree>(leaf.patch, leaf.patch.slope_terms(), point);
  }
};
struct PlacesAt {
  const VectorPoint& point;
  VEC_INLINE VectorPoint on(const PatchTree::Leaf& leaf) const {
    return polynomial<GroundPatch::kNodes>(leaf.patch, leaf.patch.terms(), point);
  }
};

// Where the pieces of lines end that begin on a leaf, as CurvedGroundMap::piece_end_m(), in a disc
// that the lines leave at `limit`; NaN where they may go on over the next leaf.
struct EndsOf {
  const PieceRules& rules;
  const VectorPoint& origin;
  const VectorPoint& direction;
  V from, limit;

  VEC_INLINE V on(const PatchTree::Leaf& leaf) const {
    const double off_grid = GroundMap::kDistantTrackError * leaf.grid_distance_cells;
    const VectorPoint bend = bend_on(leaf.patch);
    const V per_m2 = hn::Sqrt(bend.x * bend.x + bend.y * bend.y) / of(rules.error_cells + off_grid);
    const V end = from + hn::Sqrt(of(8) / per_m2);
    const V out = hn::Max(from + of(rules.least_m), leaves_square(leaf.patch.square()));
    const M is_last = hn::Or(end <= out, out >= limit);
    return hn::IfThenElse(is_last, hn::Min(limit, hn::Max(from, end)), hn::NaN(D()));
  }

 private:
  // As GroundPatch::bend().
  VEC_INLINE VectorPoint bend_on(const GroundPatch& patch) const {
    const V xx = direction.x * direction.x;
    const V xy = of(2) * direction.x * direction.y;
    const V yy = direction.y * direction.y;
    const auto dot = [](const glm::dvec3& a, V x, V y, V z)
                         HWY_ATTR { return of(a.x) * x + of(a.y) * y + of(a.z) * z; };
    const auto most = [&](const glm::dvec3& central, const glm::dvec3& spread) HWY_ATTR {
      return hn::Abs(dot(central, xx, xy, yy)) + dot(spread, hn::Abs(xx), hn::Abs(xy), hn::Abs(yy));
    };
    return {most(patch.central().u, patch.spread().u), most(patch.central().v, patch.spread().v)};
  }

  VEC_INLINE V leaves_square(const GroundSquare& square) const {
    const auto leaves = [&](double centre, V begin, V speed) HWY_ATTR {
      const V side =
          hn::IfThenElse(speed > of(0), of(centre + square.half_m), of(centre - square.half_m));
      return hn::IfThenElse(speed == of(0), hn::Inf(D()), (side - begin) / speed);
    };
    return hn::Min(leaves(square.centre_m.x, origin.x, direction.x),
                   leaves(square.centre_m.y, origin.y, direction.y));
  }
};

// NaN is in every leaf.
VEC_INLINE M points_in(const PatchTree::Leaf& leaf, const VectorPoint& p) {
  const M low = hn::Or(p.x < of(leaf.low_m.x), p.y < of(leaf.low_m.y));
  const M high = hn::Or(p.x >= of(leaf.high_m.x), p.y >= of(leaf.high_m.y));
  return hn::Not(hn::Or(low, high));
}

// Points of neighbours are mostly on one leaf, and that of the points before.
class Leaves {
 public:
  explicit Leaves(const PatchTree& patches) : patches_(patches), last_(&patches.leaves()[0]) {}

  // What is asked of the leaves of points.
  template <class Asked>
  VEC_INLINE auto ask(const VectorPoint& point, const Asked& asked) {
    const auto found = asked.on(*last_);
    const M here = points_in(*last_, point);
    return hn::AllTrue(D(), here) ? found : others(point, asked, found, here);
  }

 private:
  // Leaf by leaf, what is not known yet.
  template <class Asked, class Found>
  HWY_NOINLINE Found others(const VectorPoint& point, const Asked& asked, Found all, M known) {
    alignas(64) std::array<double, kVectorLanes> x_m;
    alignas(64) std::array<double, kVectorLanes> y_m;
    hn::Store(point.x, D(), x_m.data());
    hn::Store(point.y, D(), y_m.data());
    const std::uint32_t lanes = (1U << hn::Lanes(D())) - 1;
    for (std::uint32_t left = lanes & ~bits_of(known); left != 0;) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
      last_ = &patches_.leaf_at({x_m[lane], y_m[lane]});
      const M here = points_in(*last_, point);
      all = choose(here, asked.on(*last_), all);
      left &= ~bits_of(here);
    }
    return all;
  }

  const PatchTree& patches_;
  const PatchTree::Leaf* last_;
};

// Where points lie on or in a disc, and for those outside how much further out they are.
struct OnDisc {
  VectorPoint point;
  M inside;
  V share;
};
VEC_INLINE OnDisc on_disc(const GroundDisc& disc, const VectorPoint& p) {
  const VectorPoint centre = all_lanes(disc.centre_m);
  const VectorPoint away{p.x - centre.x, p.y - centre.y};
  const V away2 = away.x * away.x + away.y * away.y;
  const M inside = away2 <= of(disc.radius_m * disc.radius_m);
  if (hn::AllTrue(D(), inside)) return {p, inside, of(1)};
  const V share = hn::Sqrt(away2) / of(disc.radius_m);
  const VectorPoint on_circle{centre.x + away.x / share, centre.y + away.y / share};
  return {choose(inside, p, on_circle), inside, share};
}

VEC_INLINE VectorPoint load_points(const GroundMap::GroundPoints& points, std::size_t first) {
  return {hn::LoadU(D(), points.x_m.data() + first), hn::LoadU(D(), points.y_m.data() + first)};
}

void find_jacobians(const PatchTree& patches, const GroundDisc& disc,
                    const GroundMap::GroundPoints& points, const GroundMap::Jacobians& found) {
  Leaves leaves(patches);
  for (std::size_t i = 0; i < points.x_m.size(); i += hn::Lanes(D())) {
    const VectorPoint point = on_disc(disc, load_points(points, i)).point;
    const VectorSlopes slopes = leaves.ask(point, SlopesAt{point});
    hn::StoreU(slopes.u_by_x, D(), found.u_by_x.data() + i);
    hn::StoreU(slopes.v_by_x, D(), found.v_by_x.data() + i);
    hn::StoreU(slopes.u_by_y, D(), found.u_by_y.data() + i);
    hn::StoreU(slopes.v_by_y, D(), found.v_by_y.data() + i);
  }
}

void find_places(const PatchTree& patches, const GroundDisc& disc, glm::dvec2 centre_uv,
                 const GroundMap::GroundPoints& points, const GroundMap::Places& found) {
  Leaves leaves(patches);
  const VectorPoint centre = all_lanes(centre_uv);
  for (std::size_t i = 0; i < points.x_m.size(); i += hn::Lanes(D())) {
    const OnDisc on = on_disc(disc, load_points(points, i));
    VectorPoint uv = leaves.ask(on.point, PlacesAt{on.point});
    if (!hn::AllTrue(D(), on.inside)) {
      const VectorPoint outside{centre.x + on.share * (uv.x - centre.x),
                                centre.y + on.share * (uv.y - centre.y)};
      uv = choose(on.inside, uv, outside);
    }
    hn::StoreU(uv.x, D(), found.u.data() + i);
    hn::StoreU(uv.y, D(), found.v.data() + i);
  }
}

// As the scalar map; NaN where it is left to that.
void find_piece_ends(const PatchTree& patches, const GroundDisc& disc, const PieceRules& rules,
                     const GroundMap::GroundLines& lines, const GroundMap::Stretches& stretches,
                     std::span<double> ends_m) {
  Leaves leaves(patches);
  const VectorPoint centre = all_lanes(disc.centre_m);
  const V least = of(rules.least_m);
  for (std::size_t i = 0; i < ends_m.size(); i += hn::Lanes(D())) {
    const VectorPoint origin = load_points({lines.x0_m, lines.y0_m}, i);
    const VectorPoint direction = load_points({lines.x, lines.y}, i);
    const V from = hn::LoadU(D(), stretches.from_m.data() + i);
    const V limit = hn::LoadU(D(), stretches.limit_m.data() + i);
    const VectorPoint away{origin.x - centre.x, origin.y - centre.y};
    const V along = away.x * direction.x + away.y * direction.y;
    const V across = away.x * direction.y - away.y * direction.x;
    const V half = hn::Sqrt(of(disc.radius_m * disc.radius_m) - across * across);
    const V in = hn::Neg(along) - half;
    const V out = hn::Neg(along) + half;
    const M inside = hn::And(from >= in - least, from < out - least);
    const V first = from + least;
    const VectorPoint begin{origin.x + direction.x * first, origin.y + direction.y * first};
    const V end = leaves.ask(begin, EndsOf{rules, origin, direction, from, hn::Min(limit, out)});
    const M is_eyes =
        origin.x * origin.x + origin.y * origin.y < of(rules.at_the_eye_m * rules.at_the_eye_m);
    const M known = hn::AndNot(is_eyes, hn::And(inside, end == end));
    hn::StoreU(hn::IfThenElse(known, hn::Min(limit, hn::Max(end, first)), hn::NaN(D())), D(),
               ends_m.data() + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(find_jacobians);
HWY_EXPORT(find_places);
HWY_EXPORT(find_piece_ends);

namespace {

constexpr std::size_t kWholeVectors = 8;  // of every instruction set

template <std::size_t kArrays>
using Inputs = std::array<std::span<const double>, kArrays>;
template <std::size_t kArrays>
using Outputs = std::array<std::span<double>, kArrays>;

// Calls `find` for whole vectors, and for what is left by way of arrays of that length.
template <std::size_t kIn, std::size_t kOut, class Find>
void in_whole_vectors(const Inputs<kIn>& given, const Outputs<kOut>& found, const Find& find) {
  const std::size_t count = found[0].size();
  const std::size_t whole = count - count % kWholeVectors;
  Inputs<kIn> in;
  Outputs<kOut> out;
  for (std::size_t k = 0; k < kIn; ++k) in[k] = given[k].first(whole);
  for (std::size_t k = 0; k < kOut; ++k) out[k] = found[k].first(whole);
  find(in, out);
  if (whole == count) return;
  std::array<std::array<double, kWholeVectors>, kIn> last_in;
  std::array<std::array<double, kWholeVectors>, kOut> last_out;
  for (std::size_t k = 0; k < kIn; ++k) {
    last_in[k].fill(given[k][whole]);
    std::copy_n(given[k].data() + whole, count - whole, last_in[k].begin());
    in[k] = last_in[k];
  }
  for (std::size_t k = 0; k < kOut; ++k) out[k] = last_out[k];
  find(in, out);
  for (std::size_t k = 0; k < kOut; ++k)
    std::copy_n(last_out[k].begin(), count - whole, found[k].data() + whole);
}

}  // namespace

void patch_jacobians(const PatchTree& patches, const GroundDisc& disc,
                     const GroundMap::GroundPoints& points, const GroundMap::Jacobians& found) {
  in_whole_vectors<2, 4>({points.x_m, points.y_m},
                         {found.u_by_x, found.v_by_x, found.u_by_y, found.v_by_y},
                         [&](const Inputs<2>& in, const Outputs<4>& out) {
                           HWY_DYNAMIC_DISPATCH(find_jacobians)
                           (patches, disc, {in[0], in[1]}, {out[0], out[1], out[2], out[3]});
                         });
}

void patch_places(const PatchTree& patches, const GroundDisc& disc, glm::dvec2 centre_uv,
                  const GroundMap::GroundPoints& points, const GroundMap::Places& found) {
  in_whole_vectors<2, 2>({points.x_m, points.y_m}, {found.u, found.v},
                         [&](const Inputs<2>& in, const Outputs<2>& out) {
                           HWY_DYNAMIC_DISPATCH(find_places)
                           (patches, disc, centre_uv, {in[0], in[1]}, {out[0], out[1]});
                         });
}

void patch_piece_ends(const PatchTree& patches, const GroundDisc& disc, const PieceRules& rules,
                      const GroundMap::GroundLines& lines, const GroundMap::Stretches& stretches,
                      std::span<double> ends_m) {
  in_whole_vectors<6, 1>(
      {lines.x0_m, lines.y0_m, lines.x, lines.y, stretches.from_m, stretches.limit_m}, {ends_m},
      [&](const Inputs<6>& in, const Outputs<1>& out) {
        HWY_DYNAMIC_DISPATCH(find_piece_ends)
        (patches, disc, rules, {in[0], in[1], in[2], in[3]}, {in[4], in[5]}, out[0]);
      });
}

}  // namespace terrview
#endif
