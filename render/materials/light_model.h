// The light that leaves a point of a surface, term by term.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "render/beams.h"
#include "render/materials/material.h"

namespace terrview {

// Where a ray of a unit direction goes from a mirror of that unit normal: I - 2 N (N . I).
[[nodiscard]] glm::dvec3 reflected(const glm::dvec3& direction, const glm::dvec3& normal);

// Where it goes beyond a surface, N . I < 0, by Snell's law; `index` is that of the matter beyond
// over that before. Unit length; nullopt: total reflection.
[[nodiscard]] std::optional<glm::dvec3> refracted(const glm::dvec3& direction,
                                                  const glm::dvec3& normal, double index);

// The outward unit normal `normal` of a surface that stands out by material.bump_m there:
// N - (grad F - N (N . grad F)), of unit length (Blinn, SIGGRAPH 1978). The gradient is that over a
// pixel's width.
[[nodiscard]] glm::dvec3 bumped_normal(const ScalarShade& bump_m, const ShadingPoint& point,
                                       const glm::dvec3& normal);

// Sums over the sources.
struct SourceLight {
  glm::vec3 diffuse{0};   // D
  glm::vec3 specular{0};  // S
};

// Adds a beam with N . L > 0.
void add_beam(const Material& material, const ShadingPoint& point, const Beam& beam,
              SourceLight& light);

// ka C Ia + kd C sum D + ks sum S.
[[nodiscard]] glm::vec3 own_color(const Material& material, const ShadingPoint& point,
                                  const glm::vec3& ambient_light, const SourceLight& light);

}  // namespace terrview
