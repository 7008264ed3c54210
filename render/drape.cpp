#include "render/drape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace terrview {
namespace {

constexpr double kLongest = 256;

double limited_facing(double facing) {
  return std::copysign(std::max(std::abs(facing), 1 / kLongest), facing);
}

}  // namespace

FootprintSides footprint_sides(const glm::dvec3& ray_direction, const glm::dvec3& normal) {
  const glm::dvec3 away = glm::normalize(ray_direction);
  const double facing = limited_facing(glm::dot(away, normal));
  const glm::dvec3 aside = std::abs(away.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(away, aside));
  const auto on_surface = [&](const glm::dvec3& side) {
    return side - away * (glm::dot(side, normal) / facing);
  };
  return {on_surface(across), on_surface(glm::cross(across, away))};
}

glm::dmat2 footprint(const glm::dvec3& ray_direction, const glm::dvec3& normal) {
  const FootprintSides sides = footprint_sides(ray_direction, normal);
  return {glm::dvec2(sides.across), glm::dvec2(sides.up)};
}

double footprint_area(const glm::dvec3& ray_direction, const glm::dvec3& normal) {
  // The upward part of the sides' cross product, whichever sides they are.
  const glm::dvec3 away = glm::normalize(ray_direction);
  const double facing = glm::dot(away, normal);
  const double limited = limited_facing(facing);
  return std::abs((normal.z + (limited - facing) * away.z) / limited);
}

Drape::Drape(PicturePyramid picture, std::vector<std::shared_ptr<const PixelMap>> maps)
    : picture_(std::move(picture)), maps_(std::move(maps)) {}

glm::vec3 Drape::over(const glm::vec3& color, const Terrain& terrain, const Ray& ray,
                      const Hit& hit, double width_m, const glm::dvec3& normal) const {
  const auto layer = static_cast<std::size_t>(hit.grid);
  const PixelMap& map = *maps_[layer];
  const glm::dmat2 sides_px = map.jacobian(hit.uv) *
                              terrain.layers()[layer].map->jacobian(glm::dvec2(hit.position_m)) *
                              (width_m * footprint(ray.direction, normal));
  const glm::vec4 seen = picture_.mean(map.to_pixels(hit.uv), sides_px);
  return glm::vec3(seen) + (1 - seen.a) * color;
}

}  // namespace terrview
