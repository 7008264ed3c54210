// Between the view frame and true directions.
//
// The view frame is the true east-north-up frame of the eye, scaled along the ground so that a
// horizontal distance is that of the geodesic, and lifted by refraction:
//
//   rho = (R + h) sin(gamma), U = (R + h) cos(gamma) - (R + h_eye)
//   view = (s / rho) (E, N, U) + (0, 0, k s^2 / (2 R)),  s = R gamma
//
// with R and k of terrain/vertical_frame.h. Light to the eye is straight in both. Other straight
// lines are bent a little by the view frame: direction_at() gives their direction at a point.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "terrain/vertical_frame.h"

namespace terrview {

// True east, north and up at the eye, metres, refraction taken out; and back. Each undoes the other
// to rounding. Below 90 degrees of arc from the eye.
[[nodiscard]] glm::dvec3 to_true_enu(const VerticalFrame& frame, const glm::dvec3& view_m);
[[nodiscard]] glm::dvec3 from_true_enu(const VerticalFrame& frame, const glm::dvec3& enu_m);

// The direction (unit length) that a true straight line of direction `true_direction`, east, north,
// up at the eye, has at `view_m`: the sun's, for a shadow ray. At the eye it is unchanged but for
// the eye's height over R.
[[nodiscard]] glm::dvec3 direction_at(const VerticalFrame& frame, const glm::dvec3& view_m,
                                      const glm::dvec3& true_direction);

// Those at many points, bit for bit.
void directions_at(const VerticalFrame& frame, std::span<const glm::dvec3> view_m,
                   const glm::dvec3& true_direction, std::span<glm::dvec3> directions);

// Nearer to the plumb line of the eye the derivatives that make a direction take their limit: their
// quotients lose digits.
inline constexpr double kPlumbLine_m = 1e-3;

// The same true direction in the local frame of Terrain::facet_normal() at `view_m`: x and y along
// the view frame's axes, z along the plumb line there.
[[nodiscard]] glm::dvec3 local_direction(const VerticalFrame& frame, const glm::dvec3& view_m,
                                         const glm::dvec3& true_direction);

}  // namespace terrview
