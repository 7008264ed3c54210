// Textures: the leaves of shade trees that vary from place to place.
//
// A texture has a space of its own; `to_texture`, affine, takes points of the view frame there.
#pragma once

#include <memory>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "render/materials/shade_tree.h"
#include "render/picture_pyramid.h"
#include "sky/random_field.h"

namespace terrview {

// From points of texture space to the unit square, (u, v) = M(x, y, z).
enum class Mapping {
  planar,       // (x, y)
  cylindrical,  // (the angle about the z axis from +x, in turns; z)
  spherical,    // (the same angle; the latitude, 0 at the south pole, 1 at the north pole)
};

// In the plane: u of the round mappings lies in [0, 1).
[[nodiscard]] glm::dvec2 mapped(Mapping mapping, const glm::dvec3& texture_point);

struct Placement {
  Mapping mapping = Mapping::planar;
  glm::dmat4 to_texture{1};
};

// A picture over the unit square, u along its rows and v upwards, repeated all over the plane
// (spherical: over u alone), and averaged over what a pixel sees of it. Its holes are black.
[[nodiscard]] ColorShade picture_texture(std::shared_ptr<const PicturePyramid> picture,
                                         const Placement& placement);

// 0 and 1 by turns on `squares` by `squares` of the unit square, 0 in its first.
[[nodiscard]] ScalarShade checker(glm::ivec2 squares, const Placement& placement);

// A random field in space (sky/solid_field.h), whose root cells are the unit cubes of texture
// space; what is narrower than a pixel is left out.
[[nodiscard]] ScalarShade solid_field(const FieldOptions& options, const glm::dmat4& to_texture);

// Veins where such a field is near 0: the table `marble` of sky/color_table.h.
[[nodiscard]] ColorShade marble(const FieldOptions& options, const glm::dmat4& to_texture);

// A trunk along the z axis, its year rings about 1 wide, bent by such a field of 8 rings a cell,
// and five times that along the trunk: the table `wood`.
[[nodiscard]] ColorShade wood(const FieldOptions& options, const glm::dmat4& to_texture);

}  // namespace terrview
