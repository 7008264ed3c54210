// A ground map whose tracks bend several times within a cell: a swirl around the eye.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "terrain/ground_map.h"

namespace terrview {

// (u, v) = eye + (x, y) turned by twist * |(x, y)|^2, one post per `spacing_m`.
class BentGroundMap final : public GroundMap {
 public:
  BentGroundMap(glm::dvec2 eye_uv, double spacing_m, double twist_per_m2, double reach_m)
      : eye_uv_(eye_uv), spacing_m_(spacing_m), twist_per_m2_(twist_per_m2), reach_m_(reach_m) {}

  [[nodiscard]] glm::dvec2 to_grid(glm::dvec2 ground_m) const override {
    const double angle = twist_per_m2_ * glm::dot(ground_m, ground_m);
    return eye_uv_ + turn(angle) * ground_m / spacing_m_;
  }

  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 ground_m) const override {
    const double angle = twist_per_m2_ * glm::dot(ground_m, ground_m);
    const glm::dmat2 rotation = turn(angle);
    const glm::dvec2 sideways = rotation * glm::dvec2(-ground_m.y, ground_m.x);
    const glm::dvec2 angle_rate = 2 * twist_per_m2_ * ground_m;
    return glm::dmat2(rotation[0] + sideways * angle_rate.x,
                      rotation[1] + sideways * angle_rate.y) /
           spacing_m_;
  }

  // Pieces end at multiples of a step that keeps them within the promised error.
  [[nodiscard]] double piece_end_m(const GroundLine& line, double from_m,
                                   double limit_m) const override {
    const double far_m = glm::length(line.origin_m) + from_m + spacing_m_;
    const double twist = std::fabs(twist_per_m2_);
    const double bend = twist * far_m * (6 + 4 * twist * far_m * far_m);
    const double step_m = std::clamp(std::sqrt(4 * kTrackError_cells * spacing_m_ / bend),
                                     1e-3 * spacing_m_, 0.7 * spacing_m_);
    return std::min(from_m + step_m, limit_m);
  }

  [[nodiscard]] double reach_m() const override { return reach_m_; }

 private:
  [[nodiscard]] static glm::dmat2 turn(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c, s, -s, c};
  }

  glm::dvec2 eye_uv_;
  double spacing_m_;
  double twist_per_m2_;
  double reach_m_;
};

}  // namespace terrview
