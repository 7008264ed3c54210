#include "ingest/feature_places.h"

#include <cmath>
#include <limits>
#include <vector>

#include "ingest/crs_transform.h"

namespace terrview {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Some points all over the file, for which its operation is chosen.
std::vector<glm::dvec2> some_of(std::span<const glm::dvec2> points) {
  constexpr std::size_t kSome = 64;
  std::vector<glm::dvec2> some;
  const std::size_t step = points.size() / kSome + 1;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

bool is_on_earth(glm::dvec2 longitude_latitude) {
  return std::abs(longitude_latitude.x) <= 360 && std::abs(longitude_latitude.y) <= 90;
}

}  // namespace

void to_geographic(const VectorFile& file, std::span<glm::dvec2> points) {
  if (file.geographic)
    for (glm::dvec2& point : points)
      if (!is_on_earth(point)) point = glm::dvec2(kNaN);
  const CrsTransform crs(file.name, file.crs_wkt, some_of(points));
  crs.to_geographic(points);
  for (glm::dvec2& point : points)
    if (!std::isfinite(point.x) || !is_on_earth(point)) point = glm::dvec2(kNaN);
}

void to_ground(const VectorFile& file, const ViewFrame& frame, std::span<glm::dvec2> points) {
  if (points.empty()) return;
  if (file.crs_wkt.empty() || !frame.is_geographic()) {
    for (glm::dvec2& point : points) point = frame.to_ground_from_projected(point);
    return;
  }
  to_geographic(file, points);
  for (glm::dvec2& point : points)
    if (!std::isnan(point.x)) point = frame.to_ground({point.y, point.x});
}

}  // namespace terrview
