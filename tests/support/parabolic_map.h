// A ground map whose lines are parabolas: bent in a few pieces, as those of real maps are.
#pragma once

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "terrain/eye_tracks.h"
#include "terrain/ground_map.h"

namespace terrview {

// (u, v) = eye + ((x, y) + bend (y^2, x y)) / spacing, with a table of tracks.
class ParabolicGroundMap final : public GroundMap {
 public:
  ParabolicGroundMap(glm::dvec2 eye_uv, double spacing_m, double bend_per_m, double reach_m)
      : eye_uv_(eye_uv),
        spacing_m_(spacing_m),
        bend_per_m_(bend_per_m),
        reach_m_(reach_m),
        tracks_(EyeTracks::make(*this)) {}

  [[nodiscard]] glm::dvec2 to_grid(glm::dvec2 p) const override {
    return eye_uv_ + (p + bend_per_m_ * glm::dvec2(p.y * p.y, p.x * p.y)) / spacing_m_;
  }
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 p) const override {
    return glm::dmat2(1, bend_per_m_ * p.y, 2 * bend_per_m_ * p.y, 1 + bend_per_m_ * p.x) /
           spacing_m_;
  }
  [[nodiscard]] double piece_end_m(const GroundLine& line, double from_m,
                                   double limit_m) const override {
    const glm::dvec2 d = line.direction;
    const double bend =
        2 * std::abs(bend_per_m_) / spacing_m_ * glm::length(glm::dvec2(d.y * d.y, d.x * d.y));
    return std::min(limit_m, from_m + std::sqrt(8 * 0.8 * kTrackError_cells / bend));
  }
  [[nodiscard]] const EyeTracks* eye_tracks() const override {
    return tracks_ ? &*tracks_ : nullptr;
  }
  [[nodiscard]] double reach_m() const override { return reach_m_; }

 private:
  glm::dvec2 eye_uv_;
  double spacing_m_;
  double bend_per_m_;
  double reach_m_;
  std::optional<EyeTracks> tracks_;
};

}  // namespace terrview
