// What rays show a line drawing: things, and where one ends before another.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/camera.h"
#include "render/scene.h"
#include "terrain/eye_front.h"

namespace terrview {

// What the ray through a point of the picture meets.
struct LinePoint {
  static constexpr std::int32_t kWater = -2;
  static constexpr std::int32_t kSky = -1;
  static constexpr std::int32_t kGround = 0;  // objects have numbers above it

  std::int32_t thing = kSky;
  int grid = 0;                // of the ground, that under water too
  double distance_m = 0;       // along the ray; infinite for the sky
  glm::dvec2 uv{0, 0};         // of the ground
  glm::dvec3 normal{0, 0, 0};  // of objects
};

// Between two points of the picture, where one thing ends before (or beside) another.
struct LineCrossing {
  glm::dvec2 at_px;
  LinePoint first;   // just before it, seen from the first of the two points
  LinePoint second;  // just behind it
  double gap = 1;    // between them; 1 is the least

  // The thing whose outline it is: the nearer.
  [[nodiscard]] const LinePoint& front() const {
    return first.distance_m <= second.distance_m ? first : second;
  }
};

// Immutable, so threads may share one. References must outlive it.
class LineTracer {
 public:
  LineTracer(const Scene& scene, const Camera& camera);

  [[nodiscard]] LinePoint at(glm::dvec2 image_px) const;
  [[nodiscard]] std::vector<LinePoint> at(std::span<const glm::dvec2> image_px) const;

  // The outline between two points that show `first` and `second`, to 1e-4 of their distance; the
  // widest gap where there are several. Ground ends before ground where the distance jumps by
  // two thirds of a post and of a percent: a gap of 1. An object ends before whatever else, and at
  // its own creases of more than 20 degrees.
  [[nodiscard]] std::optional<LineCrossing> crossing(glm::dvec2 first_px, const LinePoint& first,
                                                     glm::dvec2 second_px,
                                                     const LinePoint& second) const;

  // Metres between posts of a layer, the wider way.
  [[nodiscard]] double post_m(int grid) const { return post_m_[static_cast<std::size_t>(grid)]; }
  // Pixels that a metre takes, seen across, at that distance.
  [[nodiscard]] double px_per_m(double distance_m) const;

 private:
  [[nodiscard]] double gap(const LinePoint& a, const LinePoint& b) const;

  const Scene& scene_;
  const Camera& camera_;
  std::unique_ptr<const EyeFront> front_;
  std::vector<double> post_m_;
};

}  // namespace terrview
