#include "sky/solid_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>

namespace terrview {
namespace {

// Weights of a quadratic B-spline on the cells before, at and after a place, `share` into its cell.
std::array<double, 3> weights(double share) {
  const double left = 1 - share;
  return {left * left / 2, 0.5 + share * left, share * share / 2};
}

FieldOptions cubed(FieldOptions options) {
  options.levels.y = options.levels.x;
  return options;
}

}  // namespace

SolidField::SolidField(const FieldOptions& options) : field_(cubed(options)) {}

double SolidField::spline(int level, const glm::dvec3& place) const {
  const glm::dvec3 floor = glm::floor(place);
  const glm::dvec3 share = place - floor;
  const auto x = weights(share.x);
  const auto y = weights(share.y);
  const auto z = weights(share.z);
  const KeyedRandom& random = field_.random();
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto layer = static_cast<std::int64_t>(floor.z) + static_cast<std::int64_t>(k) - 1;
    const std::uint64_t layer_key = random.row_key(level, layer);
    for (std::size_t j = 0; j < 3; ++j) {
      const auto row = static_cast<std::int64_t>(floor.y) + static_cast<std::int64_t>(j) - 1;
      const std::uint64_t row_key = KeyedRandom::bits(layer_key, row);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto column = static_cast<std::int64_t>(floor.x) + static_cast<std::int64_t>(i) - 1;
        const double draw = random.first(KeyedRandom::bits(row_key, column));
        sum += x[i] * y[j] * z[k] * draw;
      }
    }
  }
  return sum;
}

double SolidField::at(const glm::dvec3& place_cells, double width_cells) const {
  double value = 0;
  double cell = 1;
  for (int level = 0; level <= field_.levels(); ++level, cell /= 2) {
    const double kept = width_cells > 0 ? std::min(cell / width_cells - 1, 1.0) : 1;
    if (!(kept > 0)) break;
    value +=
        kept * static_cast<double>(field_.deviation(level)) * spline(level, place_cells / cell);
  }
  return value;
}

double SolidField::expected_deviation() const {
  // The mean of the sum of the squared weights along an axis.
  constexpr double kSquared = 11.0 / 20;
  double variance = 0;
  for (int level = 0; level <= field_.levels(); ++level)
    variance += std::pow(static_cast<double>(field_.deviation(level)), 2);
  return std::sqrt(variance * kSquared * kSquared * kSquared);
}

}  // namespace terrview
