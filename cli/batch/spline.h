// Smooth curves through given values.
#pragma once

#include <vector>

namespace terrview {

// The cubic Hermite curve through (knots[i], values[i]) whose slope at a knot is that of the
// parabola through it and its neighbours: Catmull and Rom's (1974) for knots at any distance.
// Continuous with its slope; exact where the values are those of a parabola. Constant beyond the
// ends.
class Spline {
 public:
  // monotone: rises or falls between two knots as their values do, and so stays between these, by
  // slopes as in Fritsch and Carlson (1980): at most three times those of the chords beside, and 0
  // where these go up and down.
  enum class Shape { smooth, monotone };

  // `knots` increase; at least one.
  Spline(std::vector<double> knots, std::vector<double> values, Shape shape = Shape::smooth);

  [[nodiscard]] double at(double t) const;

 private:
  std::vector<double> knots_;
  std::vector<double> values_;
  std::vector<double> slopes_;
};

// Angles in degrees, or longitudes, so that no two neighbours are more than half a turn apart.
[[nodiscard]] std::vector<double> unwound(std::vector<double> angles_deg);

}  // namespace terrview
