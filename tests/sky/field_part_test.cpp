// Promises of sky/random_field.h and sky/field_part.h.
#include "sky/field_part.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace terrview {
namespace {

constexpr std::array<FieldKind, 3> kKinds{FieldKind::midpoint, FieldKind::displaced,
                                          FieldKind::smooth};

FieldOptions options(FieldKind kind, glm::ivec2 levels, double h = 0.5) {
  FieldOptions result;
  result.seed = 11;
  result.kind = kind;
  result.levels = levels;
  result.h = {h};
  return result;
}

double draw(const RandomField& field, int level, std::int64_t column, std::int64_t row) {
  const KeyedRandom& random = field.random();
  return static_cast<double>(field.deviation(level) *
                             random.first(KeyedRandom::bits(random.row_key(level, row), column)));
}

TEST(FieldPart, IsTheSameForAnyRectangle) {
  for (const FieldKind kind : kKinds) {
    for (const glm::ivec2 levels : {glm::ivec2(5, 5), glm::ivec2(6, 3), glm::ivec2(2, 5)}) {
      const RandomField field(options(kind, levels));
      const LatticeRectangle whole{-37, -50, 120, 90};
      const std::vector<float> all = field_part(field, whole);
      for (const LatticeRectangle& part :
           {LatticeRectangle{-37, -50, 1, 1}, LatticeRectangle{-1, -1, 3, 2},
            LatticeRectangle{5, 7, 33, 1}, LatticeRectangle{-20, 0, 64, 40}}) {
        const std::vector<float> values = field_part(field, part);
        for (std::int64_t j = 0; j < part.rows; ++j)
          for (std::int64_t i = 0; i < part.columns; ++i) {
            const auto there = static_cast<std::size_t>((part.row + j - whole.row) * whole.columns +
                                                        part.column + i - whole.column);
            ASSERT_EQ(values[static_cast<std::size_t>(j * part.columns + i)], all[there]);
          }
      }
    }
  }
}

TEST(FieldPart, MidpointsAreMeansAndADraw) {
  const RandomField field(options(FieldKind::midpoint, {1, 1}));
  const std::vector<float> v = field_part(field, {-2, 4, 3, 3});
  const auto at = [&](int i, int j) {
    return static_cast<double>(v[static_cast<std::size_t>(3 * j + i)]);
  };
  const auto root = [&](int i, int j) {
    return static_cast<double>(field.root_value(-1 + i, 2 + j));
  };
  EXPECT_EQ(at(0, 0), root(0, 0));
  EXPECT_EQ(at(2, 2), root(1, 1));
  EXPECT_NEAR(at(1, 0), (root(0, 0) + root(1, 0)) / 2 + draw(field, 1, -1, 4), 1e-6);
  EXPECT_NEAR(at(2, 1), (root(1, 0) + root(1, 1)) / 2 + draw(field, 1, 0, 5), 1e-6);
  const KeyedRandom& random = field.random();
  const std::uint64_t two = KeyedRandom::bits(random.row_key(1, 5), -1);
  EXPECT_NEAR(at(1, 1),
              ((at(0, 1) + at(2, 1)) / 2 + static_cast<double>(random.first(two)) +
               (at(1, 0) + at(1, 2)) / 2 + static_cast<double>(random.second(two))) /
                  2,
              1e-6);
}

// Linear between the draws of one level.
double bilinear_noise(const RandomField& field, int level, double x, double y) {
  const double i = std::floor(x);
  const double j = std::floor(y);
  const auto at = [&](int di, int dj) {
    return draw(field, level, static_cast<std::int64_t>(i) + di, static_cast<std::int64_t>(j) + dj);
  };
  const double s = x - i;
  const double t = y - j;
  return (1 - t) * ((1 - s) * at(0, 0) + s * at(1, 0)) + t * ((1 - s) * at(0, 1) + s * at(1, 1));
}

// The quadratic B-spline around 0.
double spline(double x) {
  x = std::abs(x);
  if (x < 0.5) return 0.75 - x * x;
  return x < 1.5 ? 0.5 * (1.5 - x) * (1.5 - x) : 0;
}

double spline_noise(const RandomField& field, int level, double x, double y) {
  double sum = 0;
  const auto i0 = static_cast<std::int64_t>(std::floor(x));
  const auto j0 = static_cast<std::int64_t>(std::floor(y));
  for (std::int64_t j = j0 - 2; j <= j0 + 2; ++j)
    for (std::int64_t i = i0 - 2; i <= i0 + 2; ++i)
      sum += draw(field, level, i, j) * spline(x - static_cast<double>(i) - 0.5) *
             spline(y - static_cast<double>(j) - 0.5);
  return sum;
}

// Displaced and smooth fields are plain sums of noise; nothing of this shares code with them.
TEST(FieldPart, DisplacedAndSmoothFieldsAreSumsOfNoise) {
  for (const glm::ivec2 levels : {glm::ivec2(5, 5), glm::ivec2(6, 4)}) {
    const RandomField displaced(options(FieldKind::displaced, levels, 0.6));
    const RandomField smooth(options(FieldKind::smooth, levels, 0.6));
    const LatticeRectangle part{-19, 23, 40, 30};
    const std::vector<float> a = field_part(displaced, part);
    const std::vector<float> b = field_part(smooth, part);
    for (std::int64_t j = 0; j < part.rows; ++j) {
      for (std::int64_t i = 0; i < part.columns; ++i) {
        double bilinear = 0;
        double splines = 0;
        for (int level = 0; level <= displaced.levels(); ++level) {
          const glm::ivec2 left = levels - displaced.divisions(level);
          const double x = std::ldexp(static_cast<double>(part.column + i), -left.x);
          const double y = std::ldexp(static_cast<double>(part.row + j), -left.y);
          bilinear += bilinear_noise(displaced, level, x, y);
          // An axis that is not divided keeps its control points: only halves of cells move.
          if (levels.x == levels.y) splines += spline_noise(smooth, level, x, y);
        }
        const auto k = static_cast<std::size_t>(j * part.columns + i);
        ASSERT_NEAR(static_cast<double>(a[k]), bilinear, 1e-5);
        if (levels.x == levels.y) {
          ASSERT_NEAR(static_cast<double>(b[k]), splines, 1e-5);
        }
      }
    }
  }
}

double variance(const std::vector<float>& values) {
  double sum = 0;
  for (const float v : values) sum += static_cast<double>(v) * static_cast<double>(v);
  return sum / static_cast<double>(values.size());
}

TEST(RandomField, ExpectsTheDeviationThatItHas) {
  for (const FieldKind kind : kKinds) {
    for (const double h : {0.1, 0.5, 0.9}) {
      const RandomField field(options(kind, {3, 3}, h));
      const double measured = variance(field_part(field, {0, 0, 8 * 150, 8 * 150}));
      const double expected = std::pow(field.expected_deviation(), 2);
      EXPECT_NEAR(measured / expected, 1, 0.04) << static_cast<int>(kind) << ' ' << h;
    }
  }
}

// Middle minus the mean of its ends, over the vertices that level n made.
struct LevelVariances {
  double edges = 0;
  double centers = 0;
};

LevelVariances level_variances(const RandomField& field, int level) {
  const std::int64_t step = std::int64_t{1} << (field.levels() - level);
  const std::int64_t side = 512;
  const std::vector<float> v = field_part(field, {0, 0, side + 1, side + 1});
  const auto at = [&](std::int64_t i, std::int64_t j) {
    return static_cast<double>(v[static_cast<std::size_t>(j * (side + 1) + i)]);
  };
  LevelVariances sums;
  double count = 0;
  for (std::int64_t j = 0; j < side; j += 2 * step) {
    for (std::int64_t i = 0; i < side; i += 2 * step) {
      const double edge = at(i + step, j) - (at(i, j) + at(i + 2 * step, j)) / 2;
      const double center =
          at(i + step, j + step) - (at(i + step, j) + at(i + step, j + 2 * step) + at(i, j + step) +
                                    at(i + 2 * step, j + step)) /
                                       4;
      sums.edges += edge * edge;
      sums.centers += center * center;
      ++count;
    }
  }
  return {sums.edges / count, sums.centers / count};
}

TEST(RandomField, VarianceFallsByTheLevelAndIsHalfInCentres) {
  for (const double h : {0.2, 0.5, 0.8}) {
    const RandomField field(options(FieldKind::midpoint, {6, 6}, h));
    for (int level = 3; level <= 6; ++level) {
      const LevelVariances found = level_variances(field, level);
      const double expected = std::exp2(-2 * h * (level - 1));
      EXPECT_NEAR(found.edges / expected, 1, 0.12) << h << ' ' << level;
      EXPECT_NEAR(found.centers / expected, 0.5, 0.06) << h << ' ' << level;
    }
  }
}

TEST(RandomField, TakesHByLevelAndItsLastOneForTheRest) {
  FieldOptions by_level = options(FieldKind::midpoint, {5, 5});
  by_level.h = {0, 0, 1};
  by_level.scale = 3;
  const RandomField field(by_level);
  const std::vector<float> expected{3, 3, 3, 3, 1.5F, 0.75F};
  for (int level = 0; level <= 5; ++level)
    EXPECT_EQ(field.deviation(level), expected[static_cast<std::size_t>(level)]);
}

// How much more the field bends across the edges of root cells, every 64 vertices, than across
// lines that came four levels later: a ratio of mean squares of second differences along x.
double crease(const RandomField& field) {
  const std::int64_t side = 1024;
  const std::vector<float> v = field_part(field, {0, 0, side + 1, side + 1});
  const auto mean_bend = [&](std::int64_t first, std::int64_t step) {
    double sum = 0;
    double count = 0;
    for (std::int64_t i = first; i < side; i += step) {
      for (std::int64_t j = 0; j < side; ++j, ++count) {
        const float* here = &v[static_cast<std::size_t>(j * (side + 1) + i)];
        sum += std::pow(static_cast<double>(here[-1] - 2 * here[0] + here[1]), 2);
      }
    }
    return sum / count;
  };
  return mean_bend(64, 64) / mean_bend(4, 8);
}

TEST(RandomField, SmoothFieldsHaveNoCreasesWhereTheOthersDo) {
  const auto crease_of = [](FieldKind kind) {
    return crease(RandomField(options(kind, {6, 6}, 0.8)));
  };
  EXPECT_GT(crease_of(FieldKind::midpoint), 1.2);
  EXPECT_GT(crease_of(FieldKind::displaced), 1.2);
  EXPECT_NEAR(crease_of(FieldKind::smooth), 1, 0.07);
}

}  // namespace
}  // namespace terrview
