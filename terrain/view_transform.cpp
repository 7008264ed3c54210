#include "terrain/view_transform.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "terrain/vertical_math.h"

namespace terrview {
namespace {

// Euler's formula, for the azimuth of (x, y).
double curvature_towards(const VerticalFrame& frame, glm::dvec2 ground) {
  const double s2 = glm::dot(ground, ground);
  if (s2 == 0) return frame.north_curvature_per_m;
  return (ground.x * ground.x * frame.east_curvature_per_m +
          ground.y * ground.y * frame.north_curvature_per_m) /
         s2;
}

// sin(gamma) / gamma and cos(gamma).
struct Arc {
  double sinc;
  double cosine;
};
Arc arc(double gamma) {
  const double gamma2 = gamma * gamma;
  if (gamma2 <= kSeriesLimit) return {series(kSinc, gamma2), series(kCosine, gamma2)};
  return {std::sin(gamma) / gamma, std::cos(gamma)};
}

}  // namespace

glm::dvec3 to_true_enu(const VerticalFrame& frame, const glm::dvec3& view_m) {
  if (frame.is_flat()) return view_m;
  const double curvature = curvature_towards(frame, glm::dvec2(view_m));
  const double s = glm::length(glm::dvec2(view_m));
  const auto [sinc, cosine] = arc(s * curvature);
  const double z = view_m.z - frame.refraction * curvature * s * s / 2;
  const double scale =
      (1 + curvature * frame.eye_height_m) * sinc / (cosine - curvature * z * sinc);
  return scale * glm::dvec3(view_m.x, view_m.y, z);
}

glm::dvec3 from_true_enu(const VerticalFrame& frame, const glm::dvec3& enu_m) {
  if (frame.is_flat()) return enu_m;
  const double curvature = curvature_towards(frame, glm::dvec2(enu_m));
  const double rho = glm::length(glm::dvec2(enu_m));
  const double up = 1 + curvature * (frame.eye_height_m + enu_m.z);  // over R, from the centre
  const double gamma = std::atan2(curvature * rho, up);
  const double scale = rho > 0 ? gamma / (curvature * rho) : 1 / up;
  const double lift = frame.refraction * gamma * gamma / (2 * curvature);
  return scale * enu_m + glm::dvec3(0, 0, lift);
}

glm::dvec3 direction_at(const VerticalFrame& frame, const glm::dvec3& view_m,
                        const glm::dvec3& true_direction) {
  if (frame.is_flat()) return true_direction;
  const glm::dvec3 enu = to_true_enu(frame, view_m);
  const double curvature = curvature_towards(frame, glm::dvec2(enu));
  const double rho = glm::length(glm::dvec2(enu));
  const double up = 1 + curvature * (frame.eye_height_m + enu.z);
  if (rho < kPlumbLine_m) {
    const double rise = true_direction.z * (1 + curvature * frame.eye_height_m) / up;
    return glm::normalize(glm::dvec3(true_direction.x, true_direction.y, rise));
  }
  // The derivative of from_true_enu() at a fixed R: along rho, across it, and up.
  const glm::dvec2 outward = glm::dvec2(enu) / rho;
  const double d_rho = glm::dot(outward, glm::dvec2(true_direction));
  const glm::dvec2 across = glm::dvec2(true_direction) - d_rho * outward;
  const double s = glm::length(glm::dvec2(view_m));
  const double scale = s / rho;
  const double d_s = (up * d_rho - curvature * rho * true_direction.z) /
                     (up * up + curvature * curvature * rho * rho);
  const double d_scale = (d_s - scale * d_rho) / rho;
  const double d_z =
      scale * true_direction.z + enu.z * d_scale + frame.refraction * curvature * s * d_s;
  return glm::normalize(glm::dvec3(d_s * outward + scale * across, d_z));
}

glm::dvec3 local_direction(const VerticalFrame& frame, const glm::dvec3& view_m,
                           const glm::dvec3& true_direction) {
  const double s = glm::length(glm::dvec2(view_m));
  const double gamma = s * curvature_towards(frame, glm::dvec2(view_m));
  if (gamma == 0) return true_direction;
  const glm::dvec2 outward = glm::dvec2(view_m) / s;
  const double d_rho = glm::dot(outward, glm::dvec2(true_direction));
  const auto [sinc, cosine] = arc(gamma);
  const double sine = gamma * sinc;
  const double turned = cosine * d_rho - sine * true_direction.z;
  return {glm::dvec2(true_direction) + (turned - d_rho) * outward,
          sine * d_rho + cosine * true_direction.z};
}

}  // namespace terrview
