#include "ingest/exact_ground_map.h"

#include <array>
#include <cmath>
#include <utility>

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/error.h"

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
    if (turn_) point = unwrapped(point);
  }
}

glm::dvec2 ExactGroundMap::unwrapped(glm::dvec2 uv) const {
  const double from_near = glm::dot(uv - near_, *turn_) / glm::dot(*turn_, *turn_);
  const double turns = std::round(from_near);
  uv -= *turn_ * turns;
  const double aside = from_near - turns;
  const double far = (std::abs(aside) - far_side_) / (0.5 - far_side_);
  if (!(far > 0)) return uv;
  // First beyond the pole, then together.
  return uv + beyond_pole_ * glm::smoothstep(0.0, 0.5, far) -
         *turn_ * (aside * glm::smoothstep(0.5, 1.0, far));
}

void ExactGroundMap::part_at_pole(double latitude_deg, glm::ivec2 grid_size) {
  const glm::dvec2 last_post(grid_size - 1);
  near_ = 0.5 * last_post;
  const double turn2 = glm::dot(*turn_, *turn_);
  const double half_width = 0.5 * glm::dot(last_post, glm::abs(*turn_)) / turn2;
  constexpr double kLeastFarSide = 0.1;
  if (0.5 - half_width < kLeastFarSide)
    throw InputError("'" + dem() +
                     "': its longitudes surround a pole within sight of the eye: warp it to a "
                     "polar projection, as gdalwarp -t_srs EPSG:3413");
  far_side_ = half_width + 0.3 * (0.5 - half_width);
  beyond_pole_ = to_posts_ * glm::dvec2(0, std::copysign(*crs_->turn() / 2, latitude_deg));
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
