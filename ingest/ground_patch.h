// A polynomial in place of the exact ground map, over one square of ground.
//
// Interpolation at Chebyshev points, the terms above the total degree left out. What it is worth is
// for its maker to measure: on a square of 140 km at 48 degrees north, a grid of 3 arc-seconds is
// met within 1e-6 of a cell.
#pragma once

#include <array>
#include <span>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace terrview {

struct GroundSquare {
  glm::dvec2 centre_m{0, 0};
  double half_m = 1;

  // The point at share (x, y) of the square, from -1 to 1 on each axis.
  [[nodiscard]] glm::dvec2 at(glm::dvec2 share) const { return centre_m + half_m * share; }
};

class GroundPatch {
 public:
  static constexpr int kDegree = 5;
  static constexpr int kNodes = kDegree + 1;
  using Nodes = std::array<glm::dvec2, kNodes * kNodes>;

  // Where a square is sampled, and the patch that these samples make.
  [[nodiscard]] static Nodes nodes(const GroundSquare& square);
  GroundPatch(const GroundSquare& square, const Nodes& uv_at_nodes);

  [[nodiscard]] glm::dvec2 at(glm::dvec2 ground_m) const;
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 ground_m) const;

  // What at() and jacobian() are made of: polynomials in the point's share of the square, terms of
  // x^i y^j, i + j <= kDegree, and < kDegree, by i, then j.
  using Terms = std::array<glm::dvec2, kNodes*(kNodes + 1) / 2>;
  using SlopeTerms = std::array<glm::dmat2, kDegree*(kDegree + 1) / 2>;
  [[nodiscard]] const Terms& terms() const { return terms_; }
  [[nodiscard]] const SlopeTerms& slope_terms() const { return slope_terms_; }
  [[nodiscard]] double shares_per_m() const { return per_half_m_; }

  // How much a line of a direction can bend on the square: bounds of |u''| and |v''| per metre
  // squared.
  [[nodiscard]] glm::dvec2 bend(glm::dvec2 direction) const;

  // What bend() is made of: one of (u_xx, u_xy, u_yy) and of v, per metre squared, at the centre,
  // and how far it strays from that.
  struct SecondDerivative {
    glm::dvec3 u;
    glm::dvec3 v;
  };
  [[nodiscard]] const SecondDerivative& central() const { return central_; }
  [[nodiscard]] const SecondDerivative& spread() const { return spread_; }

  // Metres of ground that one step of u, of v, is worth at the centre, and the metres of an error
  // of that many steps in u and v, whatever their signs.
  [[nodiscard]] glm::dvec2 cell_m() const { return cell_m_; }
  [[nodiscard]] double metres(glm::dvec2 steps) const;

  [[nodiscard]] const GroundSquare& square() const { return square_; }

 private:
  void find_slopes();
  void find_bounds();

  GroundSquare square_;
  double per_half_m_;
  Terms terms_;
  SlopeTerms slope_terms_;
  SecondDerivative central_{};
  SecondDerivative spread_{};
  glm::dvec2 cell_m_{0, 0};
  double skew_ = 0;  // |cosine| of the angle between rows and columns
};

}  // namespace terrview
