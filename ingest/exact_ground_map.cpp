#include "ingest/exact_ground_map.h"

#include <array>
#include <cmath>
#include <utility>

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace terrview {
namespace {

// Of the central differences: its square over the Earth's, and rounding over it, are 1e-10 or less.
constexpr double kDifference_m = 50;

const GeographicLib::AzimuthalEquidistant& equidistant() {
  static const GeographicLib::AzimuthalEquidistant map(GeographicLib::Geodesic::WGS84());
  return map;
}

}  // namespace

glm::dvec2 ground_from_geographic(GeoPoint eye, GeoPoint point) {
  glm::dvec2 ground_m;
  equidistant().Forward(eye.latitude_deg, eye.longitude_deg, point.latitude_deg,
                        point.longitude_deg, ground_m.x, ground_m.y);
  return ground_m;
}

GeoPoint geographic_from_ground(GeoPoint eye, glm::dvec2 ground_m) {
  GeoPoint point{};
  equidistant().Reverse(eye.latitude_deg, eye.longitude_deg, ground_m.x, ground_m.y,
                        point.latitude_deg, point.longitude_deg);
  return point;
}

ExactGroundMap::ExactGroundMap(GeoPoint eye, std::shared_ptr<const CrsTransform> crs,
                               const PostPlacement& placement)
    : eye_(eye),
      crs_(std::move(crs)),
      placement_(placement),
      to_posts_(glm::inverse(placement.step)) {
  if (crs_->turn()) turn_ = to_posts_ * glm::dvec2(*crs_->turn(), 0);
}

void ExactGroundMap::to_grid(std::span<glm::dvec2> points) const {
  for (glm::dvec2& point : points) {
    const GeoPoint place = geographic_from_ground(eye_, point);
    point = {place.longitude_deg, place.latitude_deg};
  }
  crs_->from_geographic(points);
  for (glm::dvec2& point : points) {
    point = to_posts_ * (point - placement_.origin);
    if (turn_)
      point += *turn_ * std::round(glm::dot(near_ - point, *turn_) / glm::dot(*turn_, *turn_));
  }
}

void ExactGroundMap::to_ground(std::span<glm::dvec2> points) const {
  for (glm::dvec2& point : points) point = placement_.at(point);
  crs_->to_geographic(points);
  for (glm::dvec2& point : points)
    if (!std::isnan(point.x)) point = ground_from_geographic(eye_, {point.y, point.x});
}

glm::dvec2 ExactGroundMap::to_grid(glm::dvec2 ground_m) const {
  to_grid(std::span(&ground_m, 1));
  return ground_m;
}

glm::dvec2 ExactGroundMap::to_ground(glm::dvec2 uv) const {
  to_ground(std::span(&uv, 1));
  return uv;
}

glm::dmat2 ExactGroundMap::jacobian(glm::dvec2 ground_m) const {
  const glm::dvec2 dx(kDifference_m, 0);
  const glm::dvec2 dy(0, kDifference_m);
  std::array points{ground_m + dx, ground_m - dx, ground_m + dy, ground_m - dy};
  to_grid(points);
  return {(points[0] - points[1]) / (2 * kDifference_m),
          (points[2] - points[3]) / (2 * kDifference_m)};
}

}  // namespace terrview
