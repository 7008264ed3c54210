#include "render/materials/light_model.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace terrview {
namespace {

constexpr double kExponent = 50;
// The least step of a gradient, as a share of the numbers that a place is made of.
constexpr double kLeastStep = 1e-7;

glm::dvec3 any_perpendicular(const glm::dvec3& unit) {
  const glm::dvec3 aside = std::abs(unit.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  return glm::normalize(glm::cross(unit, aside));
}

}  // namespace

glm::dvec3 reflected(const glm::dvec3& direction, const glm::dvec3& normal) {
  return direction - 2 * glm::dot(normal, direction) * normal;
}

std::optional<glm::dvec3> refracted(const glm::dvec3& direction, const glm::dvec3& normal,
                                    double index) {
  const double cosine = -glm::dot(normal, direction);
  const double squared = 1 - (1 - cosine * cosine) / (index * index);
  if (squared < 0) return std::nullopt;
  return glm::normalize(direction / index + (cosine / index - std::sqrt(squared)) * normal);
}

glm::dvec3 bumped_normal(const ScalarShade& bump_m, const ShadingPoint& point,
                         const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(point.position_m);
  const double step_m = std::max(point.width_m / 2, kLeastStep * (1 + size.x + size.y + size.z));
  const auto slope_along = [&](const glm::dvec3& tangent) {
    ShadingPoint ahead = point;
    ShadingPoint behind = point;
    ahead.position_m += step_m * tangent;
    behind.position_m -= step_m * tangent;
    return (bump_m->at(ahead) - bump_m->at(behind)) / (2 * step_m);
  };
  const glm::dvec3 along = any_perpendicular(normal);
  const glm::dvec3 across = glm::cross(normal, along);
  const glm::dvec3 tilt = slope_along(along) * along + slope_along(across) * across;
  return tilt == glm::dvec3(0) ? normal : glm::normalize(normal - tilt);
}

void add_beam(const Material& material, const ShadingPoint& point, const Beam& beam,
              SourceLight& light) {
  const double facing = glm::dot(point.normal, beam.towards);
  const bool is_guitteny = material.model == LightModel::guitteny;
  light.diffuse +=
      static_cast<float>(facing) * beam.intensity * (is_guitteny ? glm::vec3(1) : beam.color);
  if (!material.specular) return;
  const double cosine = glm::dot(reflected(-beam.towards, point.normal), point.towards_eye);
  if (!(cosine > 0)) return;
  const double exponent = material.exponent ? material.exponent->at(point) : kExponent;
  const double intensity = beam.intensity;
  const double highlight =
      is_guitteny ? std::pow(intensity * cosine, exponent) : intensity * std::pow(cosine, exponent);
  light.specular += static_cast<float>(highlight) * beam.color;
}

glm::vec3 own_color(const Material& material, const ShadingPoint& point,
                    const glm::vec3& ambient_light, const SourceLight& light) {
  glm::vec3 color(0);
  if (material.ambient) color += static_cast<float>(material.ambient->at(point)) * ambient_light;
  if (material.diffuse) color += static_cast<float>(material.diffuse->at(point)) * light.diffuse;
  if (material.color && color != glm::vec3(0)) color *= material.color->at(point);
  if (material.specular && light.specular != glm::vec3(0))
    color += static_cast<float>(material.specular->at(point)) * light.specular;
  return color;
}

}  // namespace terrview
