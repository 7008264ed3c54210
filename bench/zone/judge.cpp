#include "bench/zone/judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace terrview {
namespace {

using Real = long double;

constexpr std::size_t kMostJudged = 4000;
constexpr int kPlacesInCell = 16;
// A line that touches the ground as nearly as this may be taken for either.
constexpr Real kTouch_m = 1e-9L;

bool bears_out(Real clearance_m, bool seen) {
  return std::fabs(clearance_m) < kTouch_m || (clearance_m > 0) == seen;
}

Real bilinear_m(const HeightGrid& grid, Real u, Real v) {
  const int column = std::clamp(static_cast<int>(std::floor(u)), 0, grid.columns - 2);
  const int row = std::clamp(static_cast<int>(std::floor(v)), 0, grid.rows - 2);
  const Real s = u - column;
  const Real t = v - row;
  const Real north = grid.at(column, row) * (1 - s) + grid.at(column + 1, row) * s;
  const Real south = grid.at(column, row + 1) * (1 - s) + grid.at(column + 1, row + 1) * s;
  return north * (1 - t) + south * t;
}

bool is_seen(float value) { return value > 0; }

// The shares of the way from target to post at which it crosses rows and columns, in order.
std::vector<Real> crossings(glm::dvec2 from, glm::ivec2 post) {
  std::vector<Real> shares;
  for (int axis = 0; axis < 2; ++axis) {
    const Real way = post[axis] - static_cast<Real>(from[axis]);
    if (way == 0) continue;
    const int step = way > 0 ? 1 : -1;
    for (int line = post[axis] - step; (line - static_cast<Real>(from[axis])) * step > 0;
         line -= step)
      shares.push_back((line - static_cast<Real>(from[axis])) / way);
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

}  // namespace

Real clearance_m(const FlatSight& sight, glm::ivec2 post, Ground ground) {
  const HeightGrid& grid = sight.grid;
  const Real u = sight.target_uv.x;
  const Real v = sight.target_uv.y;
  const Real begin_m = sight.target_height_m;
  const Real end_m = grid.at(post.x, post.y) + static_cast<Real>(sight.observer_m);
  Real least_m = std::numeric_limits<Real>::infinity();
  const auto look = [&](Real share) {
    const Real ground_m = bilinear_m(grid, u + share * (post.x - u), v + share * (post.y - v));
    least_m = std::min(least_m, begin_m + share * (end_m - begin_m) - ground_m);
  };
  Real last = 0;
  for (const Real share : crossings(sight.target_uv, post)) {
    look(share);
    for (int i = 1; ground == Ground::bilinear && i < kPlacesInCell; ++i)
      look(last + (share - last) * i / kPlacesInCell);
    last = share;
  }
  return least_m;
}

Judgement judge(const FlatSight& sight, const HeightGrid& zone, const HeightGrid& other) {
  Judgement found;
  std::vector<glm::ivec2> differing;
  for (int row = 0; row < zone.rows; ++row)
    for (int column = 0; column < zone.columns; ++column) {
      if (std::isnan(sight.grid.at(column, row))) continue;
      ++found.posts;
      if (is_seen(zone.at(column, row)) == is_seen(other.at(column, row))) continue;
      differing.emplace_back(column, row);
      if (is_seen(other.at(column, row))) ++found.other_shows;
    }
  found.differ = differing.size();
  const std::size_t step = std::max<std::size_t>(1, differing.size() / kMostJudged);
  std::vector<double> sizes_m;
  for (std::size_t i = 0; i < differing.size(); i += step) {
    const glm::ivec2 post = differing[i];
    const bool zone_says = is_seen(zone.at(post.x, post.y));
    const Real on_edges_m = clearance_m(sight, post, Ground::edges);
    if (bears_out(on_edges_m, zone_says)) ++found.zone_edges;
    if (bears_out(clearance_m(sight, post, Ground::bilinear), zone_says)) ++found.zone_bilinear;
    sizes_m.push_back(static_cast<double>(std::fabs(on_edges_m)));
  }
  found.judged = sizes_m.size();
  if (sizes_m.empty()) return found;
  std::nth_element(sizes_m.begin(), sizes_m.begin() + static_cast<std::ptrdiff_t>(found.judged / 2),
                   sizes_m.end());
  found.median_m = sizes_m[found.judged / 2];
  return found;
}

}  // namespace terrview
