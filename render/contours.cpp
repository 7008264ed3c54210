#include "render/contours.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace terrview {
namespace {

// What rounding leaves of a level normal's slope.
constexpr double kLevel = 1e-9;

}  // namespace

double contour_share(double height_m, double rise_m, double interval_m) {
  if (!(rise_m > 0)) return 0;
  const double away_px =
      std::abs(height_m - interval_m * std::round(height_m / interval_m)) / rise_m;
  const double spacing_px = interval_m / rise_m;
  // A line and a pixel, one wide each, overlap by so much.
  return std::max(0.0, 1 - away_px) * std::clamp(spacing_px / 2 - 1, 0.0, 1.0);
}

double rise_over(const glm::dmat2& sides_m, const glm::dvec3& normal, double z_scale) {
  const glm::dvec2 slope = -glm::dvec2(normal) / std::max(normal.z, kLevel);
  if (glm::length(slope) < kLevel) return 0;
  return glm::length(glm::transpose(sides_m) * slope) / z_scale;
}

}  // namespace terrview
