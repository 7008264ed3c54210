// Promises of sky/keyed_random.h.
#include "sky/keyed_random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace terrview {
namespace {

// P(X <= x).
double distribution(Law law, double x) {
  switch (law) {
    case Law::gaussian:
      return std::erfc(-x / std::sqrt(2.0)) / 2;
    case Law::uniform:
      return 0.5 + x / (2 * std::sqrt(3.0));
    case Law::laplace:
      return x < 0 ? std::exp(x * std::sqrt(2.0)) / 2 : 1 - std::exp(-x * std::sqrt(2.0)) / 2;
    case Law::coin:
      break;
  }
  return 0;
}

std::vector<double> draws(Law law, int count) {
  const KeyedRandom random(7, law);
  std::vector<double> all;
  for (int row = 0; row * 500 < count; ++row) {
    const std::uint64_t key = random.row_key(3, row - 100);
    for (int column = 0; column < 250; ++column) {
      const std::uint64_t bits = KeyedRandom::bits(key, column - 100);
      all.push_back(static_cast<double>(random.first(bits)));
      all.push_back(static_cast<double>(random.second(bits)));
    }
  }
  return all;
}

class Laws : public testing::TestWithParam<Law> {};
INSTANTIATE_TEST_SUITE_P(All, Laws,
                         testing::Values(Law::gaussian, Law::uniform, Law::laplace, Law::coin));

TEST_P(Laws, HaveMeanZeroAndVarianceOne) {
  const std::vector<double> all = draws(GetParam(), 200000);
  double sum = 0;
  double squares = 0;
  for (const double x : all) {
    sum += x;
    squares += x * x;
  }
  const auto count = static_cast<double>(all.size());
  EXPECT_NEAR(sum / count, 0, 5 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 1, 5 * std::sqrt(5 / count));  // the laplace law's kurtosis is 6
}

TEST(QuantileTable, InvertsTheDistribution) {
  for (const Law law : {Law::gaussian, Law::uniform, Law::laplace}) {
    const QuantileTable& table = quantile_table(law);
    for (std::uint32_t step = 0; step < 100000; ++step) {
      const std::uint32_t bits = step * 42949U + 17U;
      // Bit 31 is the sign, the others the tail's probability.
      const double tail = ((bits & 0x7fffffffU) + 0.5) / 4294967296.0;
      const double x = static_cast<double>(table.draw(bits));
      const double expected = (bits >> 31) != 0 ? tail : 1 - tail;
      EXPECT_NEAR(distribution(law, x), expected, 2e-4 * std::min(1.0, 4 * tail) + 5e-8) << step;
    }
  }
}

TEST(QuantileTable, ReachesFarIntoTheGaussiansTails) {
  EXPECT_NEAR(static_cast<double>(quantile_table(Law::gaussian).draw(0)), 6.337, 0.01);
  EXPECT_NEAR(static_cast<double>(quantile_table(Law::gaussian).draw(0x80000000U)), -6.337, 0.01);
}

TEST(KeyedRandom, TakesOtherNumbersForEverySeedLevelRowColumnAndDraw) {
  const auto draw = [](std::uint64_t seed, int level, int row, int column) {
    const KeyedRandom random(seed, Law::gaussian);
    return random.first(KeyedRandom::bits(random.row_key(level, row), column));
  };
  const float here = draw(1, 2, 3, 4);
  EXPECT_EQ(here, draw(1, 2, 3, 4));
  for (const float other : {draw(2, 2, 3, 4), draw(1, 3, 3, 4), draw(1, 2, 4, 4), draw(1, 2, 3, 5),
                            draw(1, 2, -3, 4), draw(1, 2, 3, -4), draw(1, 2, 4, 3)})
    EXPECT_NE(here, other);
}

TEST(KeyedRandom, NeighboursAreUncorrelated) {
  const KeyedRandom random(5, Law::gaussian);
  constexpr int kSide = 300;
  const auto at = [&](int level, int row, int column) {
    return static_cast<double>(random.first(KeyedRandom::bits(random.row_key(level, row), column)));
  };
  double beside = 0;
  double above = 0;
  double deeper = 0;
  double twins = 0;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const double here = at(1, row, column);
      beside += here * at(1, row, column + 1);
      above += here * at(1, row + 1, column);
      deeper += here * at(2, row, column);
      twins += here * static_cast<double>(
                          random.second(KeyedRandom::bits(random.row_key(1, row), column)));
    }
  }
  for (const double sum : {beside, above, deeper, twins})
    EXPECT_NEAR(sum / (kSide * kSide), 0, 5.0 / kSide);
}

}  // namespace
}  // namespace terrview
