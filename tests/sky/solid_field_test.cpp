// The field in space against its definition by division, and its statistics.
#include "sky/solid_field.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>

namespace terrview {
namespace {

FieldOptions options_of(int levels, double h = 0.5) {
  return {.seed = 11, .levels = {levels, levels}, .h = {h}, .scale = 1.5};
}

// Control points of a cube of cells of one level.
struct Lattice {
  std::int64_t first;  // the lowest cell along every axis
  std::int64_t side;
  std::vector<double> values;

  double& at(std::int64_t x, std::int64_t y, std::int64_t z) {
    return values[static_cast<std::size_t>(((z - first) * side + y - first) * side + x - first)];
  }
};

Lattice lattice(std::int64_t first, std::int64_t side) {
  return {first, side, std::vector<double>(static_cast<std::size_t>(side * side * side), 0)};
}

double draw(const RandomField& field, int level, std::int64_t x, std::int64_t y, std::int64_t z) {
  const KeyedRandom& random = field.random();
  const std::uint64_t row = KeyedRandom::bits(random.row_key(level, z), y);
  return field.deviation(level) * random.first(KeyedRandom::bits(row, x));
}

// Refined 27:9:9:9:3:3:3:1, and displaced at levels that the field has.
Lattice divided(Lattice& coarse, const RandomField& field, int level) {
  Lattice fine = lattice(2 * coarse.first + 1, 2 * coarse.side - 2);
  const std::int64_t end = fine.first + fine.side;
  const auto parent = [](std::int64_t cell) { return cell >> 1; };
  const auto beside = [](std::int64_t cell) { return (cell >> 1) + ((cell & 1) != 0 ? 1 : -1); };
  for (std::int64_t z = fine.first; z < end; ++z) {
    for (std::int64_t y = fine.first; y < end; ++y) {
      for (std::int64_t x = fine.first; x < end; ++x) {
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const bool far_x = (corner & 1) != 0;
          const bool far_y = (corner & 2) != 0;
          const bool far_z = (corner & 4) != 0;
          const double weight = (far_x ? 1 : 3) * (far_y ? 1 : 3) * (far_z ? 1 : 3);
          sum += weight * coarse.at(far_x ? beside(x) : parent(x), far_y ? beside(y) : parent(y),
                                    far_z ? beside(z) : parent(z));
        }
        fine.at(x, y, z) = sum / 64 + (level <= field.levels() ? draw(field, level, x, y, z) : 0);
      }
    }
  }
  return fine;
}

// A vertex is the mean of the control points of the eight cells around it.
double vertex(Lattice& cells, std::int64_t x, std::int64_t y, std::int64_t z) {
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner)
    sum += cells.at(x - (corner & 1), y - (corner >> 1 & 1), z - (corner >> 2 & 1));
  return sum / 8;
}

TEST(SolidField, IsThatOfDivisionByEight) {
  constexpr int kLevels = 3;
  const FieldOptions options = options_of(kLevels);
  const RandomField draws(options);
  const SolidField field(options);
  Lattice cells = lattice(-3, 6);
  for (std::int64_t z = -3; z < 3; ++z)
    for (std::int64_t y = -3; y < 3; ++y)
      for (std::int64_t x = -3; x < 3; ++x) cells.at(x, y, z) = draw(draws, 0, x, y, z);
  // One level more than there are draws for: the limit is not of the last draws' lattice alone.
  for (int level = 1; level <= kLevels + 1; ++level) cells = divided(cells, draws, level);
  const double scale = std::exp2(kLevels + 1);
  for (const glm::i64vec3 at : {glm::i64vec3(0, 0, 0), glm::i64vec3(5, -7, 3),
                                glm::i64vec3(-9, 1, 11), glm::i64vec3(2, 8, -14)}) {
    EXPECT_NEAR(field.at(glm::dvec3(at) / scale), vertex(cells, at.x, at.y, at.z), 1e-6);
  }
}

TEST(SolidField, HasTheDeviationItExpects) {
  const SolidField field(options_of(4, 0.8));
  constexpr int kPlaces = 20000;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const double value = field.at({i * 7.3, i * -3.1 + 0.21, i * 0.77});
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kPlaces, 0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / kPlaces), field.expected_deviation(), 0.02);
}

TEST(SolidField, IsSmoothAcrossCells) {
  const SolidField field(options_of(3));
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 seam(i * 0.125, i * 0.25 - 3, 0.375);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0);
      step[axis] = kStep;
      const double before = field.at(seam) - field.at(seam - step);
      const double after = field.at(seam + step) - field.at(seam);
      EXPECT_NEAR(before / kStep, after / kStep, 0.02);
    }
  }
}

TEST(SolidField, LeavesOutWhatIsNarrowerThanAPixel) {
  const SolidField coarse(options_of(2));
  const SolidField fine(options_of(6));
  const glm::dvec3 place(0.3, 4.1, -2.7);
  EXPECT_EQ(fine.at(place, 0.125), coarse.at(place));
  EXPECT_NE(fine.at(place, 0.2), coarse.at(place));
  EXPECT_EQ(fine.at(place, 4), 0);
  EXPECT_NEAR(fine.at(place, 1e-9), fine.at(place), 1e-15);
}

}  // namespace
}  // namespace terrview
