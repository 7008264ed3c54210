#include "ingest/ground_patch.h"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace terrview {
namespace {

constexpr int kNodes = GroundPatch::kNodes;
constexpr int kDegree = GroundPatch::kDegree;
using Table = std::array<std::array<double, kNodes>, kNodes>;

// The first of the terms x^i, x^i y, x^i y^2, ... of a polynomial of this degree.
constexpr int first_term(int i, int degree = kDegree) { return i * (2 * degree + 3 - i) / 2; }

// The polynomial of such terms at a point, by Horner's scheme.
template <int kAnyDegree, class Value>
Value value(const Value* terms, glm::dvec2 p) {
  Value sum(0);
  for (int i = kAnyDegree; i >= 0; --i) {
    const Value* const row = terms + first_term(i, kAnyDegree);
    Value inner = row[kAnyDegree - i];
    for (int j = kAnyDegree - i - 1; j >= 0; --j) inner = inner * p.y + row[j];
    sum = sum * p.x + inner;
  }
  return sum;
}

double node(int index) { return -std::cos(std::numbers::pi * (index + 0.5) / kNodes); }

// Row k: the coefficients of the Chebyshev polynomial T_k.
Table chebyshev_coefficients() {
  Table table{};
  table[0][0] = 1;
  table[1][1] = 1;
  for (std::size_t k = 2; k < kNodes; ++k)
    for (std::size_t power = 0; power <= k; ++power)
      table[k][power] = (power > 0 ? 2 * table[k - 1][power - 1] : 0) - table[k - 2][power];
  return table;
}

// Row k: what the sample at each node adds to the coefficient of T_k.
Table chebyshev_weights() {
  Table table{};
  for (int k = 0; k < kNodes; ++k)
    for (int i = 0; i < kNodes; ++i)
      table[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)] =
          (k == 0 ? 1.0 : 2.0) / kNodes * std::cos(k * std::acos(node(i)));
  return table;
}

}  // namespace

GroundPatch::Nodes GroundPatch::nodes(const GroundSquare& square) {
  Nodes points;
  for (int i = 0; i < kNodes; ++i)
    for (int j = 0; j < kNodes; ++j)
      points[static_cast<std::size_t>(i * kNodes + j)] = square.at({node(i), node(j)});
  return points;
}

GroundPatch::GroundPatch(const GroundSquare& square, const Nodes& uv_at_nodes)
    : square_(square), per_half_m_(1 / square.half_m), terms_{}, slope_terms_{} {
  static const Table weights = chebyshev_weights();
  static const Table powers = chebyshev_coefficients();
  for (std::size_t k = 0; k < kNodes; ++k) {
    for (std::size_t l = 0; k + l < kNodes; ++l) {
      glm::dvec2 coefficient(0);
      for (std::size_t i = 0; i < kNodes; ++i)
        for (std::size_t j = 0; j < kNodes; ++j)
          coefficient += weights[k][i] * weights[l][j] * uv_at_nodes[i * kNodes + j];
      for (std::size_t i = 0; i <= k; ++i)
        for (std::size_t j = 0; j <= l; ++j)
          terms_[static_cast<std::size_t>(first_term(static_cast<int>(i))) + j] +=
              powers[k][i] * powers[l][j] * coefficient;
    }
  }
  find_slopes();
  find_bounds();
}

void GroundPatch::find_slopes() {
  for (int i = 0; i < kDegree; ++i) {
    for (int j = 0; i + j < kDegree; ++j) {
      const glm::dvec2 by_x = terms_[static_cast<std::size_t>(first_term(i + 1) + j)];
      const glm::dvec2 by_y = terms_[static_cast<std::size_t>(first_term(i) + j + 1)];
      slope_terms_[static_cast<std::size_t>(first_term(i, kDegree - 1) + j)] =
          per_half_m_ * glm::dmat2((i + 1.0) * by_x, (j + 1.0) * by_y);
    }
  }
}

void GroundPatch::find_bounds() {
  const double per_area = per_half_m_ * per_half_m_;
  for (int i = 0; i < kNodes; ++i) {
    for (int j = 0; i + j < kNodes; ++j) {
      const glm::dvec2 term = per_area * terms_[static_cast<std::size_t>(first_term(i) + j)];
      const glm::dvec3 factors(i * (i - 1), i * j, j * (j - 1));
      SecondDerivative& kind = i + j == 2 ? central_ : spread_;
      kind.u += i + j == 2 ? factors * term.x : glm::abs(factors * term.x);
      kind.v += i + j == 2 ? factors * term.y : glm::abs(factors * term.y);
    }
  }
  const glm::dmat2 to_ground = glm::inverse(jacobian(square_.centre_m));
  cell_m_ = {glm::length(to_ground[0]), glm::length(to_ground[1])};
  skew_ = std::abs(glm::dot(to_ground[0], to_ground[1])) / (cell_m_.x * cell_m_.y);
}

double GroundPatch::metres(glm::dvec2 steps) const {
  const glm::dvec2 m = steps * cell_m_;
  return std::sqrt(m.x * m.x + m.y * m.y + 2 * skew_ * m.x * m.y);
}

glm::dvec2 GroundPatch::at(glm::dvec2 ground_m) const {
  return value<kDegree>(terms_.data(), (ground_m - square_.centre_m) * per_half_m_);
}

glm::dmat2 GroundPatch::jacobian(glm::dvec2 ground_m) const {
  return value<kDegree - 1>(slope_terms_.data(), (ground_m - square_.centre_m) * per_half_m_);
}

glm::dvec2 GroundPatch::bend(glm::dvec2 direction) const {
  const glm::dvec3 form(direction.x * direction.x, 2 * direction.x * direction.y,
                        direction.y * direction.y);
  const glm::dvec3 size = glm::abs(form);
  return {std::abs(glm::dot(central_.u, form)) + glm::dot(spread_.u, size),
          std::abs(glm::dot(central_.v, form)) + glm::dot(spread_.v, size)};
}

}  // namespace terrview
