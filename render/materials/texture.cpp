#include "render/materials/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "render/drape.h"
#include "sky/solid_field.h"

namespace terrview {
namespace {

glm::dvec3 texture_point(const glm::dmat4& to_texture, const glm::dvec3& position_m) {
  return glm::dvec3(to_texture * glm::dvec4(position_m, 1));
}

double turns_about_z(const glm::dvec3& point) {
  const double turns = std::atan2(point.y, point.x) / (2 * std::numbers::pi);
  const double wrapped = turns - std::floor(turns);
  return wrapped < 1 ? wrapped : 0;  // a turn's rounding
}

// What a pixel sees of the unit square: two sides.
glm::dmat2 seen_sides(const Placement& placement, const ShadingPoint& point, glm::dvec2 uv) {
  const FootprintSides sides = footprint_sides(-point.towards_eye, point.normal);
  const auto along = [&](const glm::dvec3& side) {
    const glm::dvec3 ahead_m = point.position_m + point.width_m / 2 * side;
    glm::dvec2 step = mapped(placement.mapping, texture_point(placement.to_texture, ahead_m)) - uv;
    if (placement.mapping != Mapping::planar) step.x -= std::round(step.x);  // across the seam
    return 2.0 * step;
  };
  return {along(sides.across), along(sides.up)};
}

// No longer than a copy either way: the mean over one is about that over many.
glm::dvec2 within_copy(const glm::dvec2& side) {
  return side / std::max({1.0, std::abs(side.x), std::abs(side.y)});
}

// The mean of the picture's copies about a place, the alpha being that of what they cover.
glm::vec3 repeated_mean(const PicturePyramid& picture, glm::dvec2 uv, const glm::dmat2& seen,
                        bool repeats_v) {
  const glm::dvec2 size(picture.size_px());
  const glm::dmat2 sides(within_copy(seen[0]), within_copy(seen[1]));
  const glm::dmat2 sides_px(size * glm::dvec2(sides[0].x, -sides[0].y),
                            size * glm::dvec2(sides[1].x, -sides[1].y));
  uv.x -= std::floor(uv.x);
  if (repeats_v) uv.y -= std::floor(uv.y);
  // Beyond this no copy has a part in the mean.
  const double reach_px = 2 * (glm::length(sides_px[0]) + glm::length(sides_px[1])) + 2;
  glm::vec4 sum(0);
  for (int row = repeats_v ? -1 : 0; row <= (repeats_v ? 1 : 0); ++row) {
    for (int column = -1; column <= 1; ++column) {
      const glm::dvec2 place_px = size * glm::dvec2(uv.x + column, 1 - uv.y + row);
      const glm::dvec2 beyond_px = glm::max(-place_px, place_px - size);
      if (std::max(beyond_px.x, beyond_px.y) < reach_px) sum += picture.mean(place_px, sides_px);
    }
  }
  return sum.a > 0 ? glm::vec3(sum) / sum.a : glm::vec3(0);
}

// How wide a pixel is in texture space.
double texture_width(const glm::dmat4& to_texture, double width_m) {
  return width_m * std::cbrt(std::abs(glm::determinant(glm::dmat3(to_texture))));
}

constexpr double kRingsInTable = 12;
constexpr double kBend_rings = 0.8;

}  // namespace

glm::dvec2 mapped(Mapping mapping, const glm::dvec3& point) {
  if (mapping == Mapping::planar) return {point.x, point.y};
  if (mapping == Mapping::cylindrical) return {turns_about_z(point), point.z};
  const double latitude = std::atan2(point.z, std::hypot(point.x, point.y));
  return {turns_about_z(point), 0.5 + latitude / std::numbers::pi};
}

ColorShade picture_texture(std::shared_ptr<const PicturePyramid> picture,
                           const Placement& placement) {
  return shade_node<glm::vec3>(
      [picture = std::move(picture), placement](const ShadingPoint& point) {
        const glm::dvec2 uv =
            mapped(placement.mapping, texture_point(placement.to_texture, point.position_m));
        return repeated_mean(*picture, uv, seen_sides(placement, point, uv),
                             placement.mapping != Mapping::spherical);
      });
}

ScalarShade checker(glm::ivec2 squares, const Placement& placement) {
  return shade_node<double>([squares, placement](const ShadingPoint& point) {
    const glm::dvec2 uv =
        mapped(placement.mapping, texture_point(placement.to_texture, point.position_m));
    const glm::dvec2 square = glm::floor(uv * glm::dvec2(squares));
    return std::abs(std::fmod(square.x + square.y, 2.0));
  });
}

ScalarShade solid_field(const FieldOptions& options, const glm::dmat4& to_texture) {
  return shade_node<double>([field = SolidField(options), to_texture](const ShadingPoint& point) {
    return field.at(texture_point(to_texture, point.position_m),
                    texture_width(to_texture, point.width_m));
  });
}

ColorShade marble(const FieldOptions& options, const glm::dmat4& to_texture) {
  const ColorTable table = *named_table("marble");
  const double addresses = table.window.width / SolidField(options).expected_deviation();
  return tabled(add(constant(table.window.middle),
                    multiply(constant(addresses), solid_field(options, to_texture))),
                table);
}

ColorShade wood(const FieldOptions& options, const glm::dmat4& to_texture) {
  const SolidField field(options);
  const double bend_rings = kBend_rings / field.expected_deviation();
  const auto address = [field, bend_rings, to_texture](const ShadingPoint& point) {
    const glm::dvec3 at = texture_point(to_texture, point.position_m);
    const double width = texture_width(to_texture, point.width_m);
    const double bend = bend_rings * field.at(at / glm::dvec3(8, 8, 40), width / 8);
    const double rings = (std::hypot(at.x, at.y) + bend) / kRingsInTable;
    return rings - std::floor(rings);
  };
  return tabled(shade_node<double>(address), *named_table("wood"));
}

}  // namespace terrview
