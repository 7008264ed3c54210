#include "ingest/lay_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "ingest/curved_ground_map.h"

namespace terrview {
namespace {

constexpr int kPointsPerSide = 32;
// A disc around the outline's points holds the outline with this to spare.
constexpr double kDiscMargin = 1.02;

struct Place {
  GroundDisc disc;
  double reach_m;
};

// Points around the grid, each four after the last one on its side; empty where some are nowhere.
std::vector<glm::dvec2> outline(const ExactGroundMap& exact, glm::dvec2 last_post) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < kPointsPerSide; ++i) {
    const double share = static_cast<double>(i) / kPointsPerSide;
    points.push_back(last_post * glm::dvec2(share, 0));
    points.push_back(last_post * glm::dvec2(1, share));
    points.push_back(last_post * glm::dvec2(1 - share, 1));
    points.push_back(last_post * glm::dvec2(0, 1 - share));
  }
  exact.to_ground(points);
  if (std::any_of(points.begin(), points.end(), [](glm::dvec2 p) { return std::isnan(p.x); }))
    points.clear();
  return points;
}

// A disc around the grid, or around the eye as far as the ground matters.
Place find_place(const ExactGroundMap& exact, glm::dvec2 last_post, double sight_m) {
  const Place around_eye{{glm::dvec2(0), kDiscMargin * sight_m}, sight_m};
  const glm::dvec2 centre = exact.to_ground(0.5 * last_post);
  const std::vector<glm::dvec2> points = outline(exact, last_post);
  if (std::isnan(centre.x) || points.empty()) return around_eye;
  double radius = 0;
  double reach = 0;
  double gap = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    radius = std::max(radius, glm::distance(points[i], centre));
    reach = std::max(reach, glm::length(points[i]));
    if (i + 4 < points.size()) gap = std::max(gap, glm::distance(points[i], points[i + 4]));
  }
  radius = kDiscMargin * radius + gap / 2;
  reach += gap / 2;
  const bool unseen = glm::length(centre) - radius > sight_m;
  if (radius > around_eye.disc.radius_m && !unseen) return around_eye;
  return {{centre, radius}, std::min(reach, sight_m)};
}

// Posts all over the grid.
std::vector<glm::dvec2> posts_over(glm::dvec2 last_post) {
  constexpr int kDivisions = 16;
  std::vector<glm::dvec2> posts;
  for (int i = 0; i <= kDivisions; ++i)
    for (int j = 0; j <= kDivisions; ++j)
      posts.push_back(last_post * glm::dvec2(i, j) / double{kDivisions});
  return posts;
}

// The tangent of the exact map, at the point of the disc nearest to the eye, if it is good enough.
std::shared_ptr<const GroundMap> affine_map(const ExactGroundMap& exact, glm::ivec2 grid_size,
                                            const GroundDisc& disc) {
  // The map is smooth and nearly quadratic: its largest errors are near those of the samples.
  constexpr double kShareOfLimit = 0.9;
  const double away = glm::length(disc.centre_m);
  const glm::dvec2 anchor =
      away <= disc.radius_m ? glm::dvec2(0) : disc.centre_m * (1 - disc.radius_m / away);
  const glm::dmat2 jacobian = exact.jacobian(anchor);
  const glm::dvec2 eye_uv = exact.to_grid(anchor) - jacobian * anchor;
  const glm::dmat2 to_ground = glm::inverse(jacobian);
  const double cell_m = std::min(glm::length(to_ground[0]), glm::length(to_ground[1]));
  const std::vector<glm::dvec2> posts = posts_over(glm::dvec2(grid_size - 1));
  std::vector<glm::dvec2> ground = posts;
  exact.to_ground(ground);
  for (std::size_t i = 0; i < posts.size(); ++i) {
    const glm::dvec2 error = eye_uv + jacobian * ground[i] - posts[i];
    const double seen_rad =
        glm::length(to_ground * error) / std::max(glm::length(ground[i]), cell_m);
    if (!(glm::length(error) <= kShareOfLimit * GroundMap::kTrackError_cells) ||
        !(seen_rad <= kShareOfLimit * GroundMap::kTrackError_rad))
      return nullptr;
  }
  return std::make_shared<AffineGroundMap>(eye_uv, jacobian, grid_size);
}

std::optional<double> pole_within(const ExactGroundMap& exact, const GroundDisc& disc) {
  for (const double latitude_deg : {90.0, -90.0})
    if (glm::distance(exact.to_ground(GeoPoint{latitude_deg, 0}), disc.centre_m) <= disc.radius_m)
      return latitude_deg;
  return std::nullopt;
}

// The smallest disc that holds another and the eye, where that sees some of the grid: tracks from
// the eye are then smooth all along. The other one alone where the eye is in it, or far from it, or
// where the map has a pole between them.
GroundDisc with_eye(const ExactGroundMap& exact, const GroundDisc& disc, double sight_m) {
  constexpr double kFurthest_m = 1e6;
  const double away_m = glm::length(disc.centre_m);
  if (away_m < disc.radius_m || away_m - disc.radius_m > std::min(sight_m, kFurthest_m))
    return disc;
  const double far_m = away_m + disc.radius_m;
  const double radius_m = kDiscMargin * far_m / 2;
  const GroundDisc both{disc.centre_m / away_m * (far_m - radius_m), radius_m};
  return exact.turn() && pole_within(exact, both) ? disc : both;
}

LaidGrid lay(const ExactGroundMap& exact, glm::ivec2 grid_size, const Place& place,
             double sight_m) {
  std::shared_ptr<const GroundMap> map = affine_map(exact, grid_size, place.disc);
  if (!map)
    map = std::make_shared<CurvedGroundMap>(exact, grid_size, with_eye(exact, place.disc, sight_m),
                                            place.reach_m);
  return {std::move(map), exact};
}

bool meets_grid(const ExactGroundMap& exact, glm::dvec2 last_post, const GroundDisc& disc) {
  constexpr int kRings = 12;
  constexpr int kSpokes = 48;
  std::vector<glm::dvec2> points{disc.centre_m};
  for (int i = 1; i <= kRings; ++i)
    for (int j = 0; j < kSpokes; ++j) {
      const double angle = 2 * std::numbers::pi * j / kSpokes;
      points.push_back(disc.centre_m +
                       disc.radius_m * i / kRings * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
  exact.to_grid(points);
  return std::any_of(points.begin(), points.end(), [&](glm::dvec2 uv) {
    return uv.x >= 0 && uv.y >= 0 && uv.x <= last_post.x && uv.y <= last_post.y;
  });
}

}  // namespace

std::vector<LaidGrid> lay_grid(const ExactGroundMap& exact, glm::ivec2 grid_size, double sight_m) {
  const glm::dvec2 last_post(grid_size - 1);
  ExactGroundMap near_grid = exact;
  near_grid.set_near(0.5 * last_post);
  const Place place = find_place(near_grid, last_post, sight_m);
  if (!near_grid.turn()) return {lay(near_grid, grid_size, place, sight_m)};
  if (const auto pole_deg = pole_within(near_grid, place.disc)) {
    near_grid.part_at_pole(*pole_deg, grid_size);
    return {lay(near_grid, grid_size, place, sight_m)};
  }
  const glm::dvec2 centre_uv = near_grid.to_grid(place.disc.centre_m);
  std::vector<LaidGrid> laid;
  for (const double turns : {0.0, -1.0, 1.0}) {
    ExactGroundMap turned = near_grid;
    turned.set_near(centre_uv + turns * *near_grid.turn());
    if (turns == 0 || meets_grid(turned, last_post, place.disc))
      laid.push_back(lay(turned, grid_size, place, sight_m));
  }
  return laid;
}

}  // namespace terrview
