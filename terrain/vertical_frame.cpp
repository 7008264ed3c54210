#include "terrain/vertical_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "terrain/vertical_math.h"

namespace terrview {
namespace {

// tan(gamma / 2) / gamma, a function of gamma^2.
double half_tangent(double gamma2) {
  if (gamma2 <= kSeriesLimit) return series(kHalfTangent, gamma2);
  const double gamma = std::sqrt(gamma2);
  return std::tan(gamma / 2) / gamma;
}

// gamma / sin(gamma), a function of gamma^2.
double inverse_sinc(double gamma2) {
  if (gamma2 <= kSeriesLimit) return series(kInverseSinc, gamma2);
  const double gamma = std::sqrt(gamma2);
  return gamma / std::sin(gamma);
}

}  // namespace

VerticalFrame::Column VerticalFrame::at(glm::dvec2 ground_m) const {
  if (is_flat()) return {0, 1, 0, eye_height_m};
  const double x2 = ground_m.x * ground_m.x;
  const double y2 = ground_m.y * ground_m.y;
  const double s2 = x2 + y2;
  // s^2 / R by Euler's formula, which stays smooth at the eye.
  const double s2_over_r = x2 * east_curvature_per_m + y2 * north_curvature_per_m;
  const double curvature = s2 > 0 ? s2_over_r / s2 : north_curvature_per_m;
  const double gamma2 = s2_over_r * curvature;
  const double drop = s2_over_r * (refraction / 2 - half_tangent(gamma2));
  return {drop, inverse_sinc(gamma2), curvature, eye_height_m};
}

double VerticalFrame::ceiling_between(double scene_height_m, glm::dvec2 a_m, glm::dvec2 b_m) const {
  const double above_eye_m = scene_height_m - eye_height_m;
  if (is_flat()) return above_eye_m;
  const auto s2_over_r = [&](glm::dvec2 p, glm::dvec2 q) {
    return p.x * q.x * east_curvature_per_m + p.y * q.y * north_curvature_per_m;
  };
  // s^2 / R is convex along the segment: largest at an end, least at an end or between them.
  const glm::dvec2 step = b_m - a_m;
  const double at_a = s2_over_r(a_m, a_m);
  const double at_b = s2_over_r(b_m, b_m);
  double least = std::min(at_a, at_b);
  const double slope_at_a = s2_over_r(a_m, step);
  const double bend = s2_over_r(step, step);
  if (slope_at_a < 0 && slope_at_a + bend > 0)
    least = std::max(0.0, at_a - slope_at_a * slope_at_a / bend);

  const double low_curvature = std::min(north_curvature_per_m, east_curvature_per_m);
  const double high_curvature = std::max(north_curvature_per_m, east_curvature_per_m);
  const bool shrink_least = (above_eye_m > 0) == (scene_height_m > 0);
  const double w =
      above_eye_m / (1 + (shrink_least ? low_curvature : high_curvature) * scene_height_m);
  const double drop = least * (refraction - 1) / 2;
  if (w <= 0) return drop + w;
  const double gamma2 = std::max(at_a, at_b) * high_curvature;
  // The rest of the series stays below 0.0225 gamma^4 where gamma < 1.
  const double stretch =
      gamma2 < 1 ? 1 + gamma2 * (1.0 / 6 + 0.0225 * gamma2) : inverse_sinc(gamma2);
  return drop + stretch * w;
}

double VerticalFrame::ceiling_m(double scene_height_m, double reach_m) const {
  const double gamma = reach_m * std::max(north_curvature_per_m, east_curvature_per_m);
  const double far_stretch = inverse_sinc(gamma * gamma);
  const double far_lift =
      std::max(0.0, refraction - 1) * gamma * reach_m;  // only ducting raises the ground
  double highest = -std::numeric_limits<double>::infinity();
  for (const double curvature : {north_curvature_per_m, east_curvature_per_m}) {
    for (const double stretch : {1.0, far_stretch}) {
      highest =
          std::max(highest, Column(far_lift, stretch, curvature, eye_height_m).z_m(scene_height_m));
    }
  }
  return highest;
}

VerticalFrame::Bend VerticalFrame::bend(double height_bound_m) const {
  const double across = std::abs(north_curvature_per_m - east_curvature_per_m);
  const double least_m = -across * height_bound_m * (height_bound_m + std::abs(eye_height_m));
  return {least_m, 1.5 * std::max(north_curvature_per_m, east_curvature_per_m)};
}

bool VerticalFrame::is_convex(double reach_m) const {
  const double gamma = reach_m * std::max(north_curvature_per_m, east_curvature_per_m);
  return is_flat() || (gamma * gamma < kSeriesLimit && refraction >= -1 && refraction <= 0.9);
}

VerticalFrame::Slopes VerticalFrame::slopes(double lowest_m, double highest_m,
                                            double reach_m) const {
  const double gamma = reach_m * std::max(north_curvature_per_m, east_curvature_per_m);
  // dz/dh falls with the height and grows with the distance.
  const auto near_at = [&](double curvature, double height_m) {
    return Column(0, 1, curvature, eye_height_m).slope(height_m);
  };
  return {
      std::min(near_at(north_curvature_per_m, highest_m), near_at(east_curvature_per_m, highest_m)),
      inverse_sinc(gamma * gamma) * std::max(near_at(north_curvature_per_m, lowest_m),
                                             near_at(east_curvature_per_m, lowest_m))};
}

}  // namespace terrview
