// A random field over the plane by recursive subdivision (S. Coquillart, thesis, 1984, chapter 4).
//
// The plane is cut into root cells of side 1. Each is divided in four, `levels` times; a vertex
// gets its value from those around it and a random draw keyed by (seed, level, place), so that any
// part of the infinite field can be made in any order and neighbouring parts join. Between the
// vertices of the last level the field is bilinear.
//
// The vertices of level 0, the corners of root cells, have the standard deviation `scale`; the
// draws of level 1 too, and each later level's is 2^-h times that of the level before it.
//
// Kinds:
//   midpoint   the thesis's: the middle of an edge is the mean of its ends plus a draw; a centre
//   the
//              mean of what its two pairs of mid-edges give, each with a draw of its own, so that
//              the draw of a centre has half the variance. Its statistics differ from place to
//              place, and straight creases show along the coarse cells' edges.
//   displaced  every vertex of a level gets a draw, old ones too (successive random additions:
//   Voss,
//              in The Science of Fractal Images, 1988). A sum of bilinear noises: the same
//              everywhere in the mean, but creased as much.
//   smooth     square-square subdivision (Miller, SIGGRAPH 1986): the values are control points at
//              the middles of cells, refined 9:3:3:1 and all displaced. A sum of biquadratic
//              B-splines of noise, without creases. A vertex is the mean of the control points of
//              the four cells around it.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "sky/keyed_random.h"

namespace terrview {

enum class FieldKind { midpoint, displaced, smooth };

struct FieldOptions {
  std::uint64_t seed = 1;
  FieldKind kind = FieldKind::midpoint;
  Law law = Law::gaussian;
  // Divisions of a root cell along x and y. Where one has fewer, the last ones halve cells along
  // the other alone.
  glm::ivec2 levels{7, 7};
  // h of the n-th division, n from 0; the last one is that of all further divisions. Between 0
  // (rough) and 1 (soft) as a rule.
  std::vector<double> h{0.5};
  double scale = 1;
};

class RandomField {
 public:
  static constexpr int kMostLevels = 24;

  // Levels lie in [0, kMostLevels]; there is at least one h.
  explicit RandomField(FieldOptions options);

  [[nodiscard]] const FieldOptions& options() const { return options_; }
  [[nodiscard]] const KeyedRandom& random() const { return random_; }

  // How many divisions there are along either axis.
  [[nodiscard]] int levels() const { return static_cast<int>(deviations_.size()) - 1; }
  // Divisions along x and y down to `level`.
  [[nodiscard]] glm::ivec2 divisions(int level) const;
  // The standard deviation of one draw of `level`.
  [[nodiscard]] float deviation(int level) const {
    return deviations_[static_cast<std::size_t>(level)];
  }

  // The root of the field's variance, averaged over the vertices of the last level; all divisions
  // taken as divisions in four.
  [[nodiscard]] double expected_deviation() const;

  // The value of level 0: of a vertex (midpoint, displaced) or of a control point (smooth).
  [[nodiscard]] float root_value(std::int64_t column, std::int64_t row) const {
    return deviation(0) * random_.first(KeyedRandom::bits(random_.row_key(0, row), column));
  }

 private:
  FieldOptions options_;
  KeyedRandom random_;
  std::vector<float> deviations_;  // by level
};

// The rules of subdivision, written once, so that every form of the field has the same bytes.
[[nodiscard]] inline float mean(float a, float b) { return (a + b) * 0.5F; }
[[nodiscard]] inline float mean(float a, float b, float c, float d) {
  return mean(mean(a, b), mean(c, d));
}
// A control point of the next level, nearer to `near`.
[[nodiscard]] inline float three_to_one(float near, float far) {
  return 0.75F * near + 0.25F * far;
}

}  // namespace terrview
