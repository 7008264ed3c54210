#include "tests/support/judge.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <glm/geometric.hpp>

namespace terrview::oracle {
namespace {

// The least clearance over the part of a span before `until_t`.
Real lowest_m(const Profile& profile, const Span& span, Real until_t) {
  const Real to_t = std::min(span.to_t, until_t);
  Real lowest = std::min(profile.clearance_m(span, span.from_t), profile.clearance_m(span, to_t));
  const Real length = span.to_t - span.from_t;
  if (span.bulge_m != 0 && length > 0) {
    const Real rise_m = span.to_z_m - span.from_z_m - profile.ray_slope * length;
    const Real t = span.from_t + length * (Real{0.5} + rise_m / (8 * span.bulge_m));
    if (t > span.from_t && t < to_t) lowest = std::min(lowest, profile.clearance_m(span, t));
  }
  return lowest;
}

// Over a steep chord a point's clearance is more than its distance from the chord.
Real distance_per_clearance(const Profile& profile, const Span& span) {
  const Real ground_m = (span.to_t - span.from_t) * profile.run;
  if (!(ground_m > 0)) return 1;
  const Real rise_m = span.to_z_m - span.from_z_m;
  return ground_m / std::hypot(ground_m, rise_m);
}

bool touches_span(const Profile& profile, const Span& span, Real t, Real tolerance_m) {
  if (t < span.from_t - tolerance_m || t > span.to_t + tolerance_m) return false;
  const Real distance_m = profile.clearance_m(span, std::clamp(t, span.from_t, span.to_t)) *
                          distance_per_clearance(profile, span);
  return std::fabs(distance_m) <= tolerance_m;
}

// The face that closes the step up from one grid to the next.
bool touches_step(const Profile& profile, std::size_t i, Real t, Real tolerance_m) {
  if (!profile.continues(i) || profile.spans[i - 1].layer == profile.spans[i].layer) return false;
  const Span& after = profile.spans[i];
  return std::fabs(t - after.from_t) <= tolerance_m &&
         profile.clearance_m(profile.spans[i - 1], after.from_t) >= -tolerance_m &&
         profile.clearance_m(after, after.from_t) <= tolerance_m;
}

std::string hit_fault(const Profile& profile, const Hit& hit, Real tolerance_m) {
  const Real t = hit.distance_m;
  bool touches = false;
  for (std::size_t i = 0; i < profile.spans.size(); ++i) {
    const Span& span = profile.spans[i];
    if (span.from_t < t - tolerance_m &&
        lowest_m(profile, span, t - tolerance_m) * distance_per_clearance(profile, span) <
            -tolerance_m)
      return "the ray is deeper in the ground before the hit";
    if (span.layer != hit.grid) continue;
    touches = touches || touches_span(profile, span, t, tolerance_m) ||
              touches_step(profile, i, t, tolerance_m);
  }
  return touches ? "" : "the hit is not on the surface";
}

// Without a hit, the ray may go below the ground only from an edge where it is already below, and
// then it ends there.
std::string miss_fault(const Profile& profile, Real tolerance_m) {
  for (std::size_t i = 0; i < profile.spans.size(); ++i) {
    const Span& span = profile.spans[i];
    if (!profile.continues(i) && profile.clearance_m(span, span.from_t) <= tolerance_m) return "";
    if (lowest_m(profile, span, span.to_t) * distance_per_clearance(profile, span) < -tolerance_m)
      return "the ray goes into the ground without a hit";
  }
  return "";
}

std::string occlusion_fault(const Profile& profile, bool occluded, Real tolerance_m) {
  bool touches = false;
  for (const Span& span : profile.spans) {
    const Real lowest = lowest_m(profile, span, span.to_t) * distance_per_clearance(profile, span);
    if (lowest < -tolerance_m && !occluded) return "below the ground, yet not occluded";
    touches = touches || lowest <= tolerance_m;
  }
  return occluded && !touches ? "occluded where nothing is" : "";
}

// Within a cell that a bent track turns in, uv lies on the chord over the turn.
double uv_tolerance(const GroundMap& map, const HeightGrid& grid) {
  if (dynamic_cast<const AffineGroundMap*>(&map) == nullptr)
    return 10 * GroundMap::kTrackError_cells;
  return 1e-10 * (grid.columns + grid.rows + map.reach_m() * glm::length(map.jacobian({0, 0})[0]));
}

// What a hit says about itself.
std::string record_fault(const Terrain& terrain, const Ray& ray, const Hit& hit,
                         double tolerance_m) {
  if (!(hit.distance_m >= 0 && hit.distance_m <= ray.length_m)) return "the hit is not on the ray";
  const glm::dvec3 on_ray = ray.origin_m + glm::normalize(ray.direction) * hit.distance_m;
  const glm::dvec3 off = hit.position_m - on_ray;
  if (!(std::hypot(off.x, off.y, off.z) <= tolerance_m)) return "the position is not on the ray";
  if (hit.grid < 0 || hit.grid >= static_cast<int>(terrain.layers().size())) return "no such grid";
  const TerrainLayer& layer = terrain.layers()[static_cast<std::size_t>(hit.grid)];
  const HeightGrid& grid = *layer.grid;
  if (hit.cell.x < 0 || hit.cell.y < 0 || hit.cell.x > grid.columns - 2 ||
      hit.cell.y > grid.rows - 2)
    return "no such cell";
  const glm::dvec2 corner(hit.cell);
  if (hit.uv.x < corner.x || hit.uv.y < corner.y || hit.uv.x > corner.x + 1 ||
      hit.uv.y > corner.y + 1)
    return "uv is not in the cell";
  const glm::dvec2 uv = layer.map->to_grid({hit.position_m.x, hit.position_m.y});
  if (std::hypot(uv.x - hit.uv.x, uv.y - hit.uv.y) > uv_tolerance(*layer.map, grid))
    return "uv is not below the position";
  return "";
}

struct Answer {
  std::optional<Hit> hit;
  bool occluded;
};

std::string hit_or_miss_fault(const Profile& profile, const Answer& answer, Real tolerance_m) {
  return answer.hit ? hit_fault(profile, *answer.hit, tolerance_m)
                    : miss_fault(profile, tolerance_m);
}

// Whether the track lies along columns, rows or diagonals, so that it crosses one of them anywhere
// or nowhere.
bool runs_along_lines(const GroundMap& map, const Ray& ray) {
  const glm::dvec2 origin_m(ray.origin_m);
  if (ray.direction.x == 0 && ray.direction.y == 0) return false;
  const glm::dvec2 step =
      map.to_grid(origin_m + glm::normalize(glm::dvec2(ray.direction)) * map.reach_m()) -
      map.to_grid(origin_m);
  const double least = std::min({std::fabs(step.x), std::fabs(step.y), std::fabs(step.x - step.y)});
  return least <= kTolerance * std::max(std::fabs(step.x), std::fabs(step.y));
}

// What a chord that begins or ends elsewhere within a cell may be off on a round Earth.
Real chord_sag_m(const Terrain& terrain, const Profile& profile) {
  Real sag_m = 0;
  for (const Span& span : profile.spans) {
    const Real length_m = profile.run * (span.to_t - span.from_t);
    const Real rise_m = span.to_z_m - span.from_z_m;
    sag_m = std::max(sag_m, (length_m * length_m + rise_m * rise_m) / 4);
  }
  return sag_m * terrain.frame().north_curvature_per_m;
}

// Far more than rounding moves a track, and too little to matter where there is ground.
constexpr Real kMove = 2e-14L;

std::vector<Profile> profiles_beside(const Terrain& terrain, const Ray& ray) {
  Real size = 2;
  for (const TerrainLayer& layer : terrain.layers())
    size = std::max({size, Real(layer.grid->columns), Real(layer.grid->rows)});
  const Real move = kMove * size;
  std::vector<Profile> profiles;
  for (const Shift shift :
       {Shift{}, Shift{move, move}, Shift{move, -move}, Shift{-move, move}, Shift{-move, -move}})
    profiles.push_back(profile(terrain, ray, shift));
  return profiles;
}

struct Extent {
  Real t = 0;
  int runs = 0;  // stretches without a gap
};

Extent ground_extent(const Profile& profile) {
  Extent extent;
  for (std::size_t i = 0; i < profile.spans.size(); ++i) {
    extent.t += profile.spans[i].to_t - profile.spans[i].from_t;
    extent.runs += profile.continues(i) ? 0 : 1;
  }
  return extent;
}

// Whether some of the tracks meet ground that others pass by: along a border, or at a corner.
bool part_at_a_border(const std::vector<Profile>& profiles) {
  const Extent first = ground_extent(profiles.front());
  return std::any_of(profiles.begin(), profiles.end(), [&](const Profile& profile) {
    const Extent extent = ground_extent(profile);
    return extent.runs != first.runs || std::fabs(extent.t - first.t) > 1e-6L * first.t;
  });
}

// Whether a track beside the ray's makes the answer right: on a border between ground and nothing
// either is. There a track may come onto the ground late.
bool is_right_beside(const Terrain& terrain, const Ray& ray, const Answer& answer,
                     Real tolerance_m) {
  const bool along_lines =
      std::any_of(terrain.layers().begin(), terrain.layers().end(),
                  [&](const TerrainLayer& layer) { return runs_along_lines(*layer.map, ray); });
  std::vector<Profile> profiles = profiles_beside(terrain, ray);
  const bool may_come_late = part_at_a_border(profiles);
  bool hit_or_miss = false;
  bool occlusion = false;
  for (Profile& beside : profiles) {
    const Real slack_m = tolerance_m + (along_lines ? chord_sag_m(terrain, beside) : 0);
    occlusion = occlusion || occlusion_fault(beside, answer.occluded, slack_m).empty();
    hit_or_miss = hit_or_miss || hit_or_miss_fault(beside, answer, slack_m).empty();
    while (may_come_late && !hit_or_miss && !beside.spans.empty()) {
      beside.spans.erase(beside.spans.begin());
      hit_or_miss = hit_or_miss_fault(beside, answer, slack_m).empty();
    }
  }
  return hit_or_miss && occlusion;
}

}  // namespace

double scene_scale_m(const Terrain& terrain, const Ray& ray) {
  double scale_m = std::max({std::fabs(ray.origin_m.x), std::fabs(ray.origin_m.y),
                             std::fabs(ray.origin_m.z), std::fabs(terrain.frame().eye_height_m)});
  for (const TerrainLayer& layer : terrain.layers()) {
    scale_m = std::max(scale_m, layer.map->reach_m());
    for (const float height_m : layer.grid->heights_m)
      if (!std::isnan(height_m))
        scale_m = std::max(scale_m, std::fabs(height_m * terrain.frame().z_scale));
  }
  return scale_m;
}

Outcome expected_outcome(const Profile& profile) {
  for (std::size_t i = 0; i < profile.spans.size(); ++i) {
    const Span& span = profile.spans[i];
    if (!profile.continues(i) && profile.clearance_m(span, span.from_t) < 0)
      return Outcome::ends_below;
    if (lowest_m(profile, span, span.to_t) <= 0) return Outcome::hit;
  }
  return Outcome::miss;
}

Judgement judge(const Terrain& terrain, const Ray& ray, const std::optional<Hit>& hit,
                bool occluded, double tolerance) {
  const double tolerance_m = tolerance * scene_scale_m(terrain, ray);
  std::string fault = hit ? record_fault(terrain, ray, *hit, tolerance_m) : "";
  if (!fault.empty()) return {Verdict::wrong, fault};
  const Profile under_ray = profile(terrain, ray);
  const Answer answer{hit, occluded};
  fault = hit_or_miss_fault(under_ray, answer, tolerance_m);
  if (fault.empty()) fault = occlusion_fault(under_ray, occluded, tolerance_m);
  if (!fault.empty())
    return is_right_beside(terrain, ray, answer, tolerance_m) ? Judgement{Verdict::right_beside, ""}
                                                              : Judgement{Verdict::wrong, fault};
  const Outcome outcome = expected_outcome(under_ray);
  const bool same =
      hit.has_value() == (outcome == Outcome::hit) && occluded == (outcome != Outcome::miss);
  return {same ? Verdict::right : Verdict::right_within_tolerance, ""};
}

Judgement judge(const Terrain& terrain, const Ray& ray, double tolerance) {
  return judge(terrain, ray, terrain.first_hit(ray), terrain.occluded(ray), tolerance);
}

std::string to_string(const Ray& ray) {
  std::ostringstream out;
  out << std::setprecision(17) << "Ray{{" << ray.origin_m.x << ", " << ray.origin_m.y << ", "
      << ray.origin_m.z << "}, {" << ray.direction.x << ", " << ray.direction.y << ", "
      << ray.direction.z << "}, " << ray.length_m << "}";
  return out.str();
}

}  // namespace terrview::oracle
