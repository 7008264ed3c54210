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

#include "terrain/eye_loop-inl.h"
#include "terrain/eye_tracer.h"
#include "terrain/eye_tracks.h"
#include "terrain/ray_set.h"
#include "terrain/tracer.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// The sectors of unit directions, as sector_of() finds them. A vertical ray's NaN becomes sector 0.
HWY_INLINE V sectors_of(V x, V y, int a_side) {
  const V far_x = hn::Abs(x);
  const V far_y = hn::Abs(y);
  const M along_y = far_y >= far_x;
  const V c = hn::IfThenElse(along_y, x, y) / hn::Max(far_x, far_y);
  const V side = hn::IfThenElse(along_y, hn::IfThenElse(y > of(0), of(0), of(2 * a_side)),
                                hn::IfThenElse(x > of(0), of(a_side), of(3 * a_side)));
  const V place = hn::Floor((c + of(1)) * of(0.5 * a_side));
  const V sector = side + hn::Min(place, of(a_side - 1));
  return hn::IfThenElseZero(place >= of(0), sector);
}

// Ground lines and slopes, as ground_line() and ray_slope() find them; straight tracks, as
// track_piece(); and the places in the front's starts.
void prepare_rays(const EyeFront& front, EyeRays& rays, RaySet& set) {
  const GroundMap& map = *front.terrain().layers()[0].map;
  const glm::dmat2* jacobian = map.linear();
  const EyeTracks* tracks = map.eye_tracks();
  set.count = rays.count;
  for (std::size_t i = 0; i < rays.count; i += hn::Lanes(D())) {
    const VectorLine line =
        line_under(load(rays.direction_x, i), load(rays.direction_y, i), load(rays.direction_z, i));
    const auto [x, y, slope] = line;
    save(rays.x, i, x);
    save(rays.y, i, y);
    save(rays.slope, i, slope);
    save(set.index, i, hn::Iota(D(), static_cast<double>(i)));
    save(set.x, i, x);
    save(set.y, i, y);
    save(set.slope, i, slope);
    if (jacobian) {
      const LinearRates rates = rates_along(line, *jacobian);
      save(set.rate_u, i, rates.u.rate);
      save(set.rate_v, i, rates.v.rate);
      save(set.metres_u, i, rates.u.metres);
      save(set.metres_v, i, rates.v.metres);
    } else {
      save(set.sector, i, sectors_of(x, y, tracks->sectors_a_side()));
    }
    const V bin =
        hn::Floor((slope / (of(1) + hn::Abs(slope)) + of(1)) * of(EyeFront::kStartBins / 2));
    const V first_bin = of(front.first_bin());
    const V known_bin =
        hn::IfThenElse(bin >= first_bin, hn::Min(bin, of(front.last_bin())), first_bin);
    const V wedge = sectors_of(x, y, front.wedges_a_side());
    save(set.start, i, wedge * of(EyeFront::kStartBins) + known_bin);
  }
}

std::int64_t run_eye_loop(const EyeFront& front, EyeRays& rays, RaySet& set, RescueList& rescues) {
  if (front.terrain().layers()[0].map->linear())
    return EyeLoop<false>(front, rays, set, rescues).run();
  return EyeLoop<true>(front, rays, set, rescues).run();
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

void make_front(const EyeFront& front, const RaySet& set) {
  int made = -1;
  for (std::size_t i = 0; i < set.count; ++i) {
    const int group = static_cast<int>(set.start[i]) / (EyeFront::kStartBins * EyeFront::kGroup);
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
  RaySet set;
  HWY_DYNAMIC_DISPATCH(prepare_rays)(front, rays, set);
  make_front(front, set);
  RescueList rescues;
  counts.tests += HWY_DYNAMIC_DISPATCH(run_eye_loop)(front, rays, set, rescues);
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
  if (terrain.layers()[0].map->linear()) {
    if (rays.count > 0) HWY_DYNAMIC_DISPATCH(affine_normals)(terrain, rays, normals);
    return;
  }
  for (std::size_t i = 0; i < rays.count; ++i) {
    if (!rays.is_hit(i)) continue;
    const glm::dvec3 normal = terrain.facet_normal(rays.hit(i));
    normals.x[i] = normal.x;
    normals.y[i] = normal.y;
    normals.z[i] = normal.z;
  }
}

}  // namespace terrview
#endif
