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

#include "terrain/eye_cell.h"
#include "terrain/eye_loop-inl.h"
#include "terrain/eye_proof-inl.h"
#include "terrain/eye_scout-inl.h"
#include "terrain/eye_tracer.h"
#include "terrain/eye_tracks.h"
#include "terrain/ray_set.h"
#include "terrain/tracer.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"
#include "terrain/vector_sectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// Makes groups of wedges of a front; `made` is the last one that is known to be.
VEC_INLINE void make_groups(const EyeFront& front, V groups, double& made) {
  if (hn::AllTrue(D(), groups == of(made))) return;
  alignas(64) std::array<double, kVectorLanes> lanes;
  hn::Store(groups, D(), lanes.data());
  for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane) {
    if (lanes[lane] == made) continue;
    made = lanes[lane];
    front.make(static_cast<int>(made));
  }
}

// Ground lines and slopes, as ground_line() and ray_slope() find them; straight tracks, as
// track_piece(); and the places in the front's starts, which are made.
void prepare_rays(const EyeFront& front, EyeRays& rays, RaySet& set) {
  const GroundMap& map = *front.terrain().layers()[0].map;
  const glm::dmat2* jacobian = map.linear();
  const EyeTracks* tracks = map.eye_tracks();
  set.count = rays.count;
  const V steps = hn::Iota(D(), 0);
  double made = -1;
  for (std::size_t i = 0; i < rays.count; i += hn::Lanes(D())) {
    const VectorLine line =
        line_under(load(rays.direction_x, i), load(rays.direction_y, i), load(rays.direction_z, i));
    const auto [x, y, slope] = line;
    save(rays.x, i, x);
    save(rays.y, i, y);
    save(rays.slope, i, slope);
    save(set.index, i, of(static_cast<double>(i)) + steps);
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
      save(set.sector, i, sectors_of(D(), x, y, tracks->sectors_a_side()));
    }
    const V bin = hn::Floor((slope / (of(EyeFront::kHalfwaySlope) + hn::Abs(slope)) + of(1)) *
                            of(EyeFront::kStartBins / 2));
    const V first_bin = of(front.first_bin());
    const V known_bin =
        hn::IfThenElse(bin >= first_bin, hn::Min(bin, of(front.last_bin())), first_bin);
    const V wedge = sectors_of(D(), x, y, front.wedges_a_side());
    save(set.start, i, wedge * of(EyeFront::kStartBins) + known_bin);
    make_groups(front, hn::Floor(wedge * of(1.0 / EyeFront::kGroup)), made);
  }
}

// Where rays have ended, for those that follow them.
void keep_clear(EyeRays& rays) {
  for (std::size_t i = 0; i < rays.count; i += hn::Lanes(D())) {
    const V g = load(rays.ground_m, i);
    save(rays.clear_m, i, hn::IfThenElse(g >= of(0), g, hn::Inf(D())));
  }
}

std::int64_t run_eye_loop(const EyeFront& front, EyeRays& rays, RaySet& set, RescueList& rescues) {
  if (front.terrain().layers()[0].map->linear())
    return EyeLoop<false>(front, rays, set, rescues).run();
  return EyeLoop<true>(front, rays, set, rescues).run();
}

template <Ground kGround>
std::int64_t scout_over(const EyeFront& front, EyeRays& rays, ScoutFinds& finds) {
  const std::int64_t tests = EyeScout<kGround>(front, rays, finds).run();
  EyeProof<kGround == Ground::bent>(front.terrain(), rays, finds).run();
  return tests;
}

std::int64_t scout(const EyeFront& front, EyeRays& rays, ScoutFinds& finds) {
  if (!front.terrain().layers()[0].map->linear())
    return scout_over<Ground::bent>(front, rays, finds);
  if (!front.terrain().frame().is_flat()) return scout_over<Ground::curved>(front, rays, finds);
  return scout_over<Ground::flat>(front, rays, finds);
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(prepare_rays);
HWY_EXPORT(run_eye_loop);
HWY_EXPORT(keep_clear);
HWY_EXPORT(scout);

namespace {

// Lanes past the last ray are computed all the same.
void pad(EyeRays& rays) {
  const std::size_t padded = (rays.count + 15) / 16 * 16;
  for (std::size_t i = rays.count; i < padded; ++i) {
    rays.direction_x[i] = rays.direction_x[0];
    rays.direction_y[i] = rays.direction_y[0];
    rays.direction_z[i] = rays.direction_z[0];
    rays.clear_m[i] = rays.clear_m[0];
  }
}

bool nothing_is_left(const EyeRays& rays) {
  const double* begin = rays.clear_m.data();
  return std::all_of(begin, begin + rays.count, [](double clear_m) { return std::isinf(clear_m); });
}

// Traces ray i by itself.
void rescue(const Terrain& terrain, EyeRays& rays, std::size_t i, TraceCounts& counts) {
  const Ray ray{{0, 0, 0}, {rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]}};
  const Trace found = trace(terrain, terrain.ceiling_m(), ray);
  counts.tests += found.counts.tests;
  counts.nodes += found.counts.nodes;
  rays.ground_m[i] = found.outcome == Outcome::hit ? found.ground_m : -1;
  // Where this one came over an edge of the ground below it, the next may come above it.
  if (rays.follows)
    rays.clear_m[i] = found.outcome == Outcome::below ? 0
                      : found.outcome == Outcome::hit ? found.ground_m
                                                      : std::numeric_limits<double>::infinity();
  if (found.outcome == Outcome::hit && is_vertical(ray)) {
    rays.slope[i] = -std::numeric_limits<double>::infinity();
    rays.ground_m[i] = found.hit.distance_m;
  }
  rays.u[i] = found.hit.uv.x;
  rays.v[i] = found.hit.uv.y;
  rays.column[i] = found.hit.cell.x;
  rays.row[i] = found.hit.cell.y;
}

// By vectors of doubles alone.
void trace_in_doubles(const EyeFront& front, EyeRays& rays, TraceCounts& counts) {
  RaySet set;
  HWY_DYNAMIC_DISPATCH(prepare_rays)(front, rays, set);
  RescueList rescues;
  counts.tests += HWY_DYNAMIC_DISPATCH(run_eye_loop)(front, rays, set, rescues);
  if (rays.follows) HWY_DYNAMIC_DISPATCH(keep_clear)(rays);
  for (std::size_t j = 0; j < rescues.count; ++j)
    rescue(front.terrain(), rays, static_cast<std::size_t>(rescues.rays[j]), counts);
}

// Whether floats can tell the places of rays, and these begin above the ground.
bool has_scouts(const EyeFront& front) {
  constexpr double kMostPosts = 1 << 15;
  const Terrain& terrain = front.terrain();
  const TerrainLayer& layer = terrain.layers()[0];
  const glm::dvec2 eye_uv = layer.map->to_grid({0, 0});
  const auto near = [](double uv, int posts) { return std::abs(uv) + posts < kMostPosts; };
  // On the ground floats cannot tell on which side a ray leaves it.
  return near(eye_uv.x, layer.grid->columns) && near(eye_uv.y, layer.grid->rows) &&
         EyeCell(terrain).is_above_ground();
}

// Traces the rays that floats say nothing of.
void retrace(const EyeFront& front, EyeRays& rays, const ScoutFinds& finds, TraceCounts& counts) {
  EyeRays again;
  again.count = finds.unsure_count;
  again.follows = true;
  const auto at = [&](std::size_t j) { return static_cast<std::size_t>(finds.unsure[j]); };
  for (std::size_t j = 0; j < again.count; ++j) {
    again.direction_x[j] = rays.direction_x[at(j)];
    again.direction_y[j] = rays.direction_y[at(j)];
    again.direction_z[j] = rays.direction_z[at(j)];
    again.clear_m[j] = std::max<double>(finds.clear_m[j], rays.follows ? rays.clear_m[at(j)] : 0);
  }
  if (rays.follows) HWY_DYNAMIC_DISPATCH(keep_clear)(rays);
  if (again.count == 0) return;
  pad(again);
  trace_in_doubles(front, again, counts);
  for (std::size_t j = 0; j < again.count; ++j) {
    rays.clear_m[at(j)] = again.clear_m[j];
    for (EyeRays::Values EyeRays::*values :
         {&EyeRays::x, &EyeRays::y, &EyeRays::slope, &EyeRays::ground_m, &EyeRays::u, &EyeRays::v,
          &EyeRays::column, &EyeRays::row})
      (rays.*values)[at(j)] = (again.*values)[j];
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
  if (rays.follows && nothing_is_left(rays)) {
    std::fill_n(rays.ground_m.begin(), rays.count, -1);
    return;
  }
  pad(rays);
  if (!has_scouts(front)) {
    trace_in_doubles(front, rays, counts);
    return;
  }
  ScoutFinds finds;
  counts.tests += HWY_DYNAMIC_DISPATCH(scout)(front, rays, finds);
  retrace(front, rays, finds, counts);
}

}  // namespace terrview
#endif
