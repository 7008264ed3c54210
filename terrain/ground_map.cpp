#include "terrain/ground_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/error.h"

namespace terrview {

void GroundMap::places(const GroundPoints& points, const Places& found) const {
  for (std::size_t i = 0; i < points.x_m.size(); ++i) {
    const glm::dvec2 uv = to_grid({points.x_m[i], points.y_m[i]});
    found.u[i] = uv.x;
    found.v[i] = uv.y;
  }
}

void GroundMap::jacobians(const GroundPoints& points, const Jacobians& found) const {
  for (std::size_t i = 0; i < points.x_m.size(); ++i) {
    const glm::dmat2 one = jacobian({points.x_m[i], points.y_m[i]});
    found.u_by_x[i] = one[0].x;
    found.v_by_x[i] = one[0].y;
    found.u_by_y[i] = one[1].x;
    found.v_by_y[i] = one[1].y;
  }
}

void GroundMap::piece_ends_m(const GroundLines& lines, const Stretches& stretches,
                             std::span<double> ends_m) const {
  for (std::size_t i = 0; i < ends_m.size(); ++i)
    ends_m[i] = piece_end_m({{lines.x0_m[i], lines.y0_m[i]}, {lines.x[i], lines.y[i]}},
                            stretches.from_m[i], stretches.limit_m[i]);
}

AffineGroundMap::AffineGroundMap(glm::dvec2 eye_uv, const glm::dmat2& jacobian,
                                 glm::ivec2 grid_size)
    : eye_uv_(eye_uv), jacobian_(jacobian), reach_m_(0) {
  const double determinant = glm::determinant(jacobian);
  if (!std::isfinite(determinant) || determinant == 0)
    throw InputError("the grid's posts lie on a line: check its geotransform");
  const glm::dmat2 to_ground = glm::inverse(jacobian);
  for (const double u : {0.0, grid_size.x - 1.0}) {
    for (const double v : {0.0, grid_size.y - 1.0})
      reach_m_ = std::max(reach_m_, glm::length(to_ground * (glm::dvec2(u, v) - eye_uv)));
  }
  // A margin for rounding, so that the farthest post is not cut off.
  reach_m_ += 1e-9 * reach_m_ + glm::length(to_ground[0]) + glm::length(to_ground[1]);
}

glm::dvec2 AffineGroundMap::to_grid(glm::dvec2 ground_m) const {
  return eye_uv_ + jacobian_ * ground_m;
}

glm::dmat2 AffineGroundMap::jacobian(glm::dvec2 /*ground_m*/) const { return jacobian_; }

double AffineGroundMap::piece_end_m(const GroundLine& /*line*/, double /*from_m*/,
                                    double limit_m) const {
  return limit_m;
}

}  // namespace terrview
