#include "sky/cloud_layer.h"

#include <cmath>

namespace terrview {

std::optional<double> CloudLayer::distance(const glm::dvec3& direction) const {
  if (height_m <= 0) return std::nullopt;
  const double run2 = direction.x * direction.x + direction.y * direction.y;
  const double bend = curvature_per_m * run2;
  const double root = std::sqrt(direction.z * direction.z + 2 * bend * height_m);
  // Of the two forms of the solution the one without a difference of near numbers.
  double t = 0;
  if (direction.z > 0)
    t = 2 * height_m / (direction.z + root);
  else if (bend > 0)
    t = (root - direction.z) / bend;
  else
    return std::nullopt;
  if (t * t * run2 > reach_m * reach_m) return std::nullopt;
  return t;
}

}  // namespace terrview
