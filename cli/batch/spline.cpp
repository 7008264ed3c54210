#include "cli/batch/spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace terrview {
namespace {

// At the middle one of three knots `before` and `after` apart, with chords of these slopes.
double middle_slope(double before, double after, double slope_before, double slope_after) {
  return (after * slope_before + before * slope_after) / (before + after);
}

std::vector<double> slopes_of(const std::vector<double>& knots, const std::vector<double>& values) {
  const std::size_t last = knots.size() - 1;
  std::vector<double> slopes(knots.size());
  if (last == 0) return slopes;
  const auto step = [&](std::size_t i) { return knots[i + 1] - knots[i]; };
  const auto chord = [&](std::size_t i) { return (values[i + 1] - values[i]) / step(i); };
  for (std::size_t i = 1; i < last; ++i)
    slopes[i] = middle_slope(step(i - 1), step(i), chord(i - 1), chord(i));
  // A parabola's chord has the mean slope of its ends.
  slopes[0] = last > 1 ? 2 * chord(0) - slopes[1] : chord(0);
  slopes[last] = last > 1 ? 2 * chord(last - 1) - slopes[last - 1] : chord(0);
  return slopes;
}

double limited(double slope, double chord) {
  if (slope * chord <= 0) return 0;
  return std::copysign(std::min(std::abs(slope), 3 * std::abs(chord)), slope);
}

}  // namespace

Spline::Spline(std::vector<double> knots, std::vector<double> values, Shape shape)
    : knots_(std::move(knots)), values_(std::move(values)), slopes_(slopes_of(knots_, values_)) {
  if (shape == Shape::smooth) return;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const double chord = (values_[i + 1] - values_[i]) / (knots_[i + 1] - knots_[i]);
    slopes_[i] = limited(slopes_[i], chord);
    slopes_[i + 1] = limited(slopes_[i + 1], chord);
  }
}

double Spline::at(double t) const {
  if (t <= knots_.front()) return values_.front();
  if (t >= knots_.back()) return values_.back();
  const auto next = std::upper_bound(knots_.begin(), knots_.end(), t);
  const auto i = static_cast<std::size_t>(next - knots_.begin()) - 1;
  const double step = knots_[i + 1] - knots_[i];
  const double x = (t - knots_[i]) / step;
  const double y = 1 - x;
  return y * y * (1 + 2 * x) * values_[i] + x * x * (1 + 2 * y) * values_[i + 1] +
         step * x * y * (y * slopes_[i] - x * slopes_[i + 1]);
}

std::vector<double> unwound(std::vector<double> angles_deg) {
  for (std::size_t i = 1; i < angles_deg.size(); ++i)
    angles_deg[i] = angles_deg[i - 1] + std::remainder(angles_deg[i] - angles_deg[i - 1], 360.0);
  return angles_deg;
}

}  // namespace terrview
