#include "sky/random_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace terrview {
namespace {

// What corners of one cell have in common, averaged over all cells of a level.
struct CellMoments {
  double variance;  // of a corner
  double edge;      // covariance of the ends of an edge
  double diagonal;  // covariance of opposite corners
};

// The moments of the four cells that a cell is divided into, none of its corners displaced.
// `edge_noise` is the variance of the draw of an edge's middle, `center_noise` that of the
// centre's.
CellMoments divided(const CellMoments& cell, double edge_noise, double center_noise) {
  const double middle = (cell.variance + cell.edge) / 2 + edge_noise;
  const double corner_center = (cell.variance + 2 * cell.edge + cell.diagonal) / 4;
  const double next_middles = corner_center;
  const double opposite_middles = (cell.edge + cell.diagonal) / 2;
  const double corner_middle = (cell.variance + cell.edge) / 2;
  const double middle_center = (middle + 2 * next_middles + opposite_middles) / 4;
  const double center = (4 * middle + 8 * next_middles + 4 * opposite_middles) / 16 + center_noise;
  return {(cell.variance + 2 * middle + center) / 4, (corner_middle + middle_center) / 2,
          (corner_center + next_middles) / 2};
}

// The sum of the squared weights that the draws of a level have along one axis (linear, or
// quadratic B-splines), averaged over the vertices `depth` levels below.
double squared_weights(FieldKind kind, int depth) {
  const int count = 1 << std::min(depth, 8);
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    const double s = static_cast<double>(k) / count;
    const double t = 1 - s;
    sum += kind == FieldKind::smooth
               ? (t * t * t * t + (1 + 2 * s * t) * (1 + 2 * s * t) + s * s * s * s) / 4
               : s * s + t * t;
  }
  return sum / count;
}

}  // namespace

RandomField::RandomField(FieldOptions options)
    : options_(std::move(options)), random_(options_.seed, options_.law) {
  assert(std::min(options_.levels.x, options_.levels.y) >= 0 && !options_.h.empty());
  const int levels = std::max(options_.levels.x, options_.levels.y);
  assert(levels <= kMostLevels);
  double deviation = options_.scale;
  deviations_.push_back(static_cast<float>(deviation));
  for (int level = 1; level <= levels; ++level) {
    deviations_.push_back(static_cast<float>(deviation));
    const auto n = static_cast<std::size_t>(level - 1);
    deviation *= std::exp2(-options_.h[std::min(n, options_.h.size() - 1)]);
  }
}

glm::ivec2 RandomField::divisions(int level) const {
  return {std::min(level, options_.levels.x), std::min(level, options_.levels.y)};
}

double RandomField::expected_deviation() const {
  double sum = 0;
  CellMoments cell{0, 0, 0};
  for (int level = 0; level <= levels(); ++level) {
    const double variance = std::pow(static_cast<double>(deviation(level)), 2);
    sum += variance * std::pow(squared_weights(options_.kind, levels() - level), 2);
    cell = level == 0 ? CellMoments{variance, 0, 0} : divided(cell, variance, variance / 2);
  }
  return std::sqrt(options_.kind == FieldKind::midpoint ? cell.variance : sum);
}

}  // namespace terrview
