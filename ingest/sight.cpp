#include "ingest/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terrview {
namespace {

constexpr double kFurthest_rad = 1.4;
constexpr int kHalvings = 60;

// The Earth as a sphere of the frame's larger radius.
class Sphere {
 public:
  explicit Sphere(const VerticalFrame& frame)
      : radius_m_(1 / std::min(frame.north_curvature_per_m, frame.east_curvature_per_m)),
        eye_height_m_(frame.eye_height_m),
        refraction_(frame.refraction) {}

  [[nodiscard]] double radius_m() const { return radius_m_; }

  // The tangent of the apparent elevation of a height at an arc, and its derivative.
  [[nodiscard]] double elevation(double height_m, double arc) const {
    return -std::tan(arc / 2) + refraction_ * arc / 2 + lift(height_m) / std::sin(arc);
  }
  [[nodiscard]] double elevation_slope(double height_m, double arc) const {
    const double half = 1 / std::cos(arc / 2);
    const double sine = std::sin(arc);
    return (refraction_ - half * half) / 2 - lift(height_m) * std::cos(arc) / (sine * sine);
  }

  // Where the sphere of this height, not above the eye, reaches its highest elevation.
  [[nodiscard]] double horizon(double height_m) const {
    double low = 0;
    double high = kFurthest_rad;
    for (int i = 0; i < kHalvings; ++i) {
      const double arc = (low + high) / 2;
      (elevation_slope(height_m, arc) > 0 ? low : high) = arc;
    }
    return high;
  }

 private:
  [[nodiscard]] double lift(double height_m) const {
    return (height_m - eye_height_m_) / (radius_m_ + height_m);
  }

  double radius_m_;
  double eye_height_m_;
  double refraction_;
};

}  // namespace

double sight_m(const VerticalFrame& frame, double lowest_m, double highest_m) {
  if (frame.north_curvature_per_m == 0 || frame.east_curvature_per_m == 0)
    return std::numeric_limits<double>::infinity();
  const Sphere sphere(frame);
  const double low_m = std::min(lowest_m, frame.eye_height_m);
  const double high_m = std::max(low_m, highest_m);
  double low = sphere.horizon(low_m);
  const double dip = sphere.elevation(low_m, low);
  double high = kFurthest_rad;
  for (int i = 0; i < kHalvings; ++i) {
    const double arc = (low + high) / 2;
    (sphere.elevation(high_m, arc) >= dip ? low : high) = arc;
  }
  // What is seen may lie in the shadow of ground as far behind it as two heights see each other.
  const double r = sphere.radius_m();
  const double shadow = 2 * std::acos((r + low_m) / (r + high_m));
  return r * std::min(kFurthest_rad, 1.01 * (high + shadow));
}

}  // namespace terrview
