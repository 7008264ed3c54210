#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/eye_facets.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

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

// Those of another map.
class HitSlopes {
 public:
  HitSlopes(const GroundMap& map, const EyeRays& rays) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rays.count; i += hn::Lanes(D())) {
      const V g = load(rays.ground_m, i);
      const M hit = g >= of(0);
      if (hn::AllFalse(D(), hit)) continue;
      // As EyeRays::hit() has them; a vertical ray's lies below the eye.
      const M slanted = hn::And(hit, hn::Abs(load(rays.slope, i)) < hn::Inf(D()));
      save(x_m_, count, hn::IfThenElseZero(slanted, of(0) + load(rays.x, i) * g));
      save(y_m_, count, hn::IfThenElseZero(slanted, of(0) + load(rays.y, i) * g));
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

template <class Value>
VEC_INLINE void save(std::array<Value, EyeRays::kMost>& values, std::size_t first, V value) {
  const hn::Rebind<Value, D> d;
  hn::Store(hn::DemoteTo(d, value), d, values.data() + first);
}

VEC_INLINE void save_misses(EyeFacets& facets, std::size_t first) {
  save(facets.x, first, of(0));
  save(facets.y, first, of(0));
  save(facets.z, first, of(0));
  save(facets.cell, first, of(-1));
  save(facets.distance_m, first, hn::Inf(D()));
}

template <class Slopes>
void facets_with(Slopes& slopes, const Terrain& terrain, const EyeRays& rays, EyeFacets& facets) {
  const HeightGrid& grid = *terrain.layers()[0].grid;
  const VectorPosts posts(grid);
  const V columns = of(grid.columns);
  const V z_scale = of(terrain.frame().z_scale);
  for (std::size_t i = 0; i < rays.count; i += hn::Lanes(D())) {
    const V g = load(rays.ground_m, i);
    const M hit = g >= of(0);
    if (hn::AllFalse(D(), hit)) {
      save_misses(facets, i);
      continue;
    }
    const V column = hn::IfThenElseZero(hit, load(rays.column, i));
    const V row = hn::IfThenElseZero(hit, load(rays.row, i));
    const V f_u = hn::Min(hn::Max(load(rays.u, i) - column, of(0)), of(1));
    const V f_v = hn::Min(hn::Max(load(rays.v, i) - row, of(0)), of(1));
    const auto [nw, ne, sw, se] = posts.corners(row * columns + column);
    // glm::mix(x, y, a) = x * (1 - a) + y * a.
    const V g_u = (ne - nw) * (of(1) - f_v) + (se - sw) * f_v;
    const V g_v = (sw - nw) * (of(1) - f_u) + (se - ne) * f_u;
    const VectorSlopes by = slopes.next();
    const V slope_x = z_scale * (by.u_by_x * g_u + by.v_by_x * g_v);
    const V slope_y = z_scale * (by.u_by_y * g_u + by.v_by_y * g_v);
    const V inverse = of(1) / hn::Sqrt(slope_x * slope_x + slope_y * slope_y + of(1));
    save(facets.x, i, hn::IfThenElseZero(hit, hn::Neg(slope_x) * inverse));
    save(facets.y, i, hn::IfThenElseZero(hit, hn::Neg(slope_y) * inverse));
    save(facets.z, i, hn::IfThenElseZero(hit, inverse));
    const V cell = row * (columns - of(1)) + column;
    save(facets.cell, i, hn::IfThenElse(hit, cell, of(-1)));
    const V slope = load(rays.slope, i);
    const V along = hn::Sqrt(of(1) + slope * slope);
    const V distance = hn::IfThenElse(hn::Abs(slope) < hn::Inf(D()), g * along, g);
    save(facets.distance_m, i, hn::IfThenElse(hit, distance, hn::Inf(D())));
  }
}

void facets_of(const Terrain& terrain, const EyeRays& rays, EyeFacets& facets) {
  const GroundMap& map = *terrain.layers()[0].map;
  if (const glm::dmat2* jacobian = map.linear()) {
    SameSlopes slopes(*jacobian);
    facets_with(slopes, terrain, rays, facets);
  } else {
    HitSlopes slopes(map, rays);
    facets_with(slopes, terrain, rays, facets);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(facets_of);

void facets(const Terrain& terrain, const EyeRays& rays, EyeFacets& facets) {
  if (rays.count > 0) HWY_DYNAMIC_DISPATCH(facets_of)(terrain, rays, facets);
}

}  // namespace terrview
#endif
