#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/eye_facets.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include <glm/mat2x2.hpp>

#include "terrain/eye_tracer.h"
#include "terrain/ground_map.h"
#include "terrain/set_walk-inl.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// The jacobian of an affine map, one vector of hits after the other.
class SameSlopes {
 public:
  explicit SameSlopes(const glm::dmat2& jacobian) : slopes_(all_lanes(jacobian)) {}
  VEC_INLINE VectorSlopes next() const { return slopes_; }

 private:
  VectorSlopes slopes_;
};

// Rays side by side, whatever the first.
struct RayRun {
  const EyeRays& rays;
  std::size_t first, count;

  VEC_INLINE V get(const EyeRays::Values& values, std::size_t i) const {
    return hn::LoadU(D(), values.data() + first + i);
  }
  // Where the ground is met, of the lanes that are rays of the run.
  VEC_INLINE M hits(std::size_t i, V ground_m) const {
    return hn::And(ground_m >= of(0), mask_of(lanes_below(count, i)));
  }
};

// Those of another map.
class HitSlopes {
 public:
  HitSlopes(const GroundMap& map, const RayRun& run) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < run.count; i += hn::Lanes(D())) {
      const V g = run.get(run.rays.ground_m, i);
      const M hit = run.hits(i, g);
      if (hn::AllFalse(D(), hit)) continue;
      // As EyeRays::hit() has them; a vertical ray's lies below the eye.
      const M slanted = hn::And(hit, hn::Abs(run.get(run.rays.slope, i)) < hn::Inf(D()));
      save(x_m_, count, hn::IfThenElseZero(slanted, of(0) + run.get(run.rays.x, i) * g));
      save(y_m_, count, hn::IfThenElseZero(slanted, of(0) + run.get(run.rays.y, i) * g));
      count += hn::Lanes(D());
    }
    const auto all = [count](auto& values) { return std::span(values.data(), count); };
    map.jacobians({all(x_m_), all(y_m_)}, {all(u_by_x_), all(v_by_x_), all(u_by_y_), all(v_by_y_)});
  }
  VEC_INLINE VectorSlopes next() {
    const std::size_t i = next_;
    next_ += hn::Lanes(D());
    return {load(u_by_x_, i), load(v_by_x_, i), load(u_by_y_, i), load(v_by_y_, i)};
  }

 private:
  std::size_t next_ = 0;
  alignas(64) EyeRays::Values x_m_, y_m_, u_by_x_, v_by_x_, u_by_y_, v_by_y_;
};

// Whole vectors at once, the last ones of a run by way of an array.
template <class Value>
VEC_INLINE void put(std::span<Value> values, std::size_t i, V value) {
  const hn::Rebind<Value, D> d;
  const std::size_t lanes = hn::Lanes(D());
  auto narrow = [&] HWY_ATTR {
    if constexpr (sizeof(Value) == sizeof(double))
      return value;
    else
      return hn::DemoteTo(d, value);
  }();
  if (i + lanes <= values.size()) {
    hn::StoreU(narrow, d, values.data() + i);
    return;
  }
  std::array<Value, kVectorLanes> last;
  hn::StoreU(narrow, d, last.data());
  std::copy_n(last.begin(), values.size() - i, values.data() + i);
}

VEC_INLINE void put_misses(const EyeFacets& facets, std::size_t i) {
  put(facets.normal_x, i, of(0));
  put(facets.normal_y, i, of(0));
  put(facets.cell, i, of(-1));
  put(facets.distance_m, i, hn::Inf(D()));
}

template <class Slopes>
void facets_with(Slopes& slopes, const Terrain& terrain, const RayRun& run,
                 const EyeFacets& facets) {
  const EyeRays& rays = run.rays;
  const HeightGrid& grid = *terrain.layers()[0].grid;
  const VectorPosts posts(grid);
  const V columns = of(grid.columns);
  const V z_scale = of(terrain.frame().z_scale);
  for (std::size_t i = 0; i < run.count; i += hn::Lanes(D())) {
    const V g = run.get(rays.ground_m, i);
    const M hit = run.hits(i, g);
    if (hn::AllFalse(D(), hit)) {
      put_misses(facets, i);
      continue;
    }
    const V column = hn::IfThenElseZero(hit, run.get(rays.column, i));
    const V row = hn::IfThenElseZero(hit, run.get(rays.row, i));
    const V f_u = hn::Min(hn::Max(run.get(rays.u, i) - column, of(0)), of(1));
    const V f_v = hn::Min(hn::Max(run.get(rays.v, i) - row, of(0)), of(1));
    const auto [nw, ne, sw, se] = posts.corners(row * columns + column);
    // glm::mix(x, y, a) = x * (1 - a) + y * a.
    const V g_u = (ne - nw) * (of(1) - f_v) + (se - sw) * f_v;
    const V g_v = (sw - nw) * (of(1) - f_u) + (se - ne) * f_u;
    const VectorSlopes by = slopes.next();
    const V slope_x = z_scale * (by.u_by_x * g_u + by.v_by_x * g_v);
    const V slope_y = z_scale * (by.u_by_y * g_u + by.v_by_y * g_v);
    const V inverse = of(1) / hn::Sqrt(slope_x * slope_x + slope_y * slope_y + of(1));
    put(facets.normal_x, i, hn::IfThenElseZero(hit, hn::Neg(slope_x) * inverse));
    put(facets.normal_y, i, hn::IfThenElseZero(hit, hn::Neg(slope_y) * inverse));
    const V cell = row * (columns - of(1)) + column;
    put(facets.cell, i, hn::IfThenElse(hit, cell, of(-1)));
    const V slope = run.get(rays.slope, i);
    const V along = hn::Sqrt(of(1) + slope * slope);
    const V distance = hn::IfThenElse(hn::Abs(slope) < hn::Inf(D()), g * along, g);
    put(facets.distance_m, i, hn::IfThenElse(hit, distance, hn::Inf(D())));
  }
}

void facets_of(const Terrain& terrain, const EyeRays& rays, std::size_t first,
               const EyeFacets& facets) {
  const RayRun run{rays, first, facets.distance_m.size()};
  const GroundMap& map = *terrain.layers()[0].map;
  if (const glm::dmat2* jacobian = map.linear()) {
    SameSlopes slopes(*jacobian);
    facets_with(slopes, terrain, run, facets);
  } else {
    HitSlopes slopes(map, run);
    facets_with(slopes, terrain, run, facets);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(facets_of);

void facets(const Terrain& terrain, const EyeRays& rays, std::size_t first,
            const EyeFacets& facets) {
  HWY_DYNAMIC_DISPATCH(facets_of)(terrain, rays, first, facets);
}

}  // namespace terrview
#endif
