#include "render/objects/solids/transformed.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/objects/solids/crossing.h"
#include "terrain/error.h"

namespace terrview {
namespace {

glm::dmat3 sizes_of(const glm::dmat3& m) {
  return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])};
}

// The largest sum over a row: by how much a vector's largest coordinate grows, at most.
double row_norm(const glm::dmat3& m) {
  const glm::dvec3 sums = glm::abs(m[0]) + glm::abs(m[1]) + glm::abs(m[2]);
  return std::max({sums.x, sums.y, sums.z});
}

void check(const glm::dmat4& m) {
  constexpr double kRounding = 1e-12;  // of products and inverses of affine matrices
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(m[column][row]))
        throw InputError("transform: a number that is not finite: give sixteen finite ones");
    if (std::abs(m[column][3] - (column == 3 ? 1 : 0)) > kRounding)
      throw InputError("transform: its last row is not 0 0 0 1: give an affine matrix");
  }
}

}  // namespace

Transformed::Transformed(SolidPtr solid, const glm::dmat4& to_parent)
    : solid_(std::move(solid)), to_parent_(to_parent), shift_m_(to_parent[3]) {
  check(to_parent);
  const double volume = std::abs(glm::determinant(to_parent_));
  const double sides =
      glm::length(to_parent_[0]) * glm::length(to_parent_[1]) * glm::length(to_parent_[2]);
  constexpr double kFlat = 1e-12;  // as a share of the volume that its sides would span upright
  if (!(volume > kFlat * sides))
    throw InputError("transform: it flattens the solid: give a matrix that can be inverted");
  to_solid_ = glm::inverse(to_parent_);
  normal_to_parent_ = glm::transpose(to_solid_);
  stretch_ = 3 * row_norm(to_solid_);
  rounding_ =
      kLostDigits * row_norm(sizes_of(to_solid_) * sizes_of(to_parent_) * sizes_of(to_solid_));
}

Box Transformed::bounds() const {
  const Box inner = solid_->bounds();
  if (glm::any(glm::greaterThan(inner.lowest_m, inner.highest_m))) return inner;
  Box outer{shift_m_, shift_m_};
  glm::dvec3 sizes_m = glm::abs(shift_m_);  // of all that is finite in the sums
  // Column by column (Arvo, Transforming Axis-Aligned Bounding Boxes, Graphics Gems, 1990); 0 of
  // what is infinite is 0.
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      const double scale = to_parent_[column][row];
      if (scale == 0) continue;
      const double a_m = scale * inner.lowest_m[column];
      const double b_m = scale * inner.highest_m[column];
      outer.lowest_m[row] += std::min(a_m, b_m);
      outer.highest_m[row] += std::max(a_m, b_m);
      for (const double term_m : {a_m, b_m})
        if (std::isfinite(term_m)) sizes_m[row] += std::abs(term_m);
    }
  outer.lowest_m -= kLostDigits * sizes_m;
  outer.highest_m += kLostDigits * sizes_m;
  return outer;
}

void Transformed::append_crossings(const Line& line, Crossings& crossings) const {
  const glm::dvec3 from_m = line.origin_m - shift_m_;
  const Line inner{to_solid_ * from_m, to_solid_ * line.direction,
                   stretch_ * line.origin_error_m +
                       rounding_ * (sum_of_sizes(line.origin_m) + sum_of_sizes(shift_m_)),
                   stretch_ * line.direction_error + rounding_ * sum_of_sizes(line.direction)};
  const std::size_t first = crossings.size();
  solid_->append_crossings(inner, crossings);
  for (std::size_t i = first; i < crossings.size(); ++i)
    if (std::isfinite(crossings[i].t))
      crossings[i].normal = glm::normalize(normal_to_parent_ * crossings[i].normal);
}

}  // namespace terrview
