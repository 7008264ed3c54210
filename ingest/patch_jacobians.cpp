#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ingest/patch_jacobians.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "ingest/patch_jacobians.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

struct VectorPoint {
  V x, y;
};

VEC_INLINE VectorSlopes multiply_add(const VectorSlopes& a, V b, const VectorSlopes& c) {
  return {a.u_by_x * b + c.u_by_x, a.v_by_x * b + c.v_by_x, a.u_by_y * b + c.u_by_y,
          a.v_by_y * b + c.v_by_y};
}
VEC_INLINE VectorSlopes choose(M mask, const VectorSlopes& a, const VectorSlopes& b) {
  return {hn::IfThenElse(mask, a.u_by_x, b.u_by_x), hn::IfThenElse(mask, a.v_by_x, b.v_by_x),
          hn::IfThenElse(mask, a.u_by_y, b.u_by_y), hn::IfThenElse(mask, a.v_by_y, b.v_by_y)};
}

// As GroundPatch::jacobian().
VEC_INLINE VectorSlopes slopes_on(const GroundPatch& patch, const VectorPoint& at) {
  const glm::dvec2 centre_m = patch.square().centre_m;
  const V scale = of(patch.shares_per_m());
  const V x = (at.x - of(centre_m.x)) * scale;
  const V y = (at.y - of(centre_m.y)) * scale;
  const GroundPatch::SlopeTerms& terms = patch.slope_terms();
  VectorSlopes sum = all_lanes(glm::dmat2(0));
  std::size_t row = terms.size();
  for (std::size_t length = 1; length <= GroundPatch::kDegree; ++length) {
    row -= length;
    VectorSlopes inner = all_lanes(terms[row + length - 1]);
    for (std::size_t j = length - 1; j-- > 0;)
      inner = multiply_add(inner, y, all_lanes(terms[row + j]));
    sum = multiply_add(sum, x, inner);
  }
  return sum;
}

VEC_INLINE VectorPoint nearest(const GroundDisc& disc, const VectorPoint& p) {
  const VectorPoint centre{of(disc.centre_m.x), of(disc.centre_m.y)};
  const VectorPoint away{p.x - centre.x, p.y - centre.y};
  const V away2 = away.x * away.x + away.y * away.y;
  const M inside = away2 <= of(disc.radius_m * disc.radius_m);
  if (hn::AllTrue(D(), inside)) return p;
  const V share = hn::Sqrt(away2) / of(disc.radius_m);
  return {hn::IfThenElse(inside, p.x, centre.x + away.x / share),
          hn::IfThenElse(inside, p.y, centre.y + away.y / share)};
}

// NaN is in every leaf.
VEC_INLINE M points_in(const PatchTree::Leaf& leaf, const VectorPoint& p) {
  const M low = hn::Or(p.x < of(leaf.low_m.x), p.y < of(leaf.low_m.y));
  const M high = hn::Or(p.x >= of(leaf.high_m.x), p.y >= of(leaf.high_m.y));
  return hn::Not(hn::Or(low, high));
}

class Leaves {
 public:
  explicit Leaves(const PatchTree& patches) : patches_(patches), last_(&patches.leaves()[0]) {}

  VEC_INLINE VectorSlopes slopes(const VectorPoint& at) {
    const VectorSlopes found = slopes_on(last_->patch, at);
    const M here = points_in(*last_, at);
    return hn::AllTrue(D(), here) ? found : all_slopes(at);
  }

 private:
  // Leaf by leaf.
  VectorSlopes all_slopes(const VectorPoint& at) {
    alignas(64) std::array<double, kVectorLanes> x_m;
    alignas(64) std::array<double, kVectorLanes> y_m;
    hn::Store(at.x, D(), x_m.data());
    hn::Store(at.y, D(), y_m.data());
    VectorSlopes all = all_lanes(glm::dmat2(0));
    for (std::uint32_t left = (1U << hn::Lanes(D())) - 1; left != 0;) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
      last_ = &patches_.leaf_at({x_m[lane], y_m[lane]});
      const VectorSlopes found = slopes_on(last_->patch, at);
      const M here = points_in(*last_, at);
      all = choose(here, found, all);
      left &= ~bits_of(here);
    }
    return all;
  }

  const PatchTree& patches_;
  const PatchTree::Leaf* last_;
};

// Returns how many whole vectors hold.
std::size_t jacobians_of(const PatchTree& patches, const GroundDisc& disc,
                         const GroundMap::GroundPoints& points, const GroundMap::Jacobians& found) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  Leaves leaves(patches);
  std::size_t first = 0;
  for (; first + lanes <= points.x_m.size(); first += lanes) {
    const VectorPoint at{hn::LoadU(d, points.x_m.data() + first),
                         hn::LoadU(d, points.y_m.data() + first)};
    const VectorSlopes slopes = leaves.slopes(nearest(disc, at));
    hn::StoreU(slopes.u_by_x, d, found.u_by_x.data() + first);
    hn::StoreU(slopes.v_by_x, d, found.v_by_x.data() + first);
    hn::StoreU(slopes.u_by_y, d, found.u_by_y.data() + first);
    hn::StoreU(slopes.v_by_y, d, found.v_by_y.data() + first);
  }
  return first;
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(jacobians_of);

void patch_jacobians(const PatchTree& patches, const GroundDisc& disc,
                     const GroundMap::GroundPoints& points, const GroundMap::Jacobians& found) {
  std::size_t i = HWY_DYNAMIC_DISPATCH(jacobians_of)(patches, disc, points, found);
  for (; i < points.x_m.size(); ++i) {
    const glm::dvec2 point = disc.nearest({points.x_m[i], points.y_m[i]});
    const glm::dmat2 one = patches.leaf_at(point).patch.jacobian(point);
    found.u_by_x[i] = one[0].x;
    found.v_by_x[i] = one[0].y;
    found.u_by_y[i] = one[1].x;
    found.v_by_y[i] = one[1].y;
  }
}

}  // namespace terrview
#endif
