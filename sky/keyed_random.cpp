#include "sky/keyed_random.h"

#include <cmath>
#include <numbers>

namespace terrview {
namespace {

// Newton's method from the left, where the tail is convex and every step falls short.
double gaussian_quantile(double tail) {
  double x = 0;
  for (int step = 0; step < 200; ++step) {
    const double excess = std::erfc(x / std::numbers::sqrt2) / 2 - tail;
    const double density = std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
    const double next = x + excess / density;
    if (!(next > x)) break;
    x = next;
  }
  return x;
}

double quantile(Law law, double tail) {
  switch (law) {
    case Law::gaussian:
      return gaussian_quantile(tail);
    case Law::uniform:
      return std::numbers::sqrt3 * (1 - 2 * tail);
    case Law::laplace:
      return -std::log(2 * tail) / std::numbers::sqrt2;
    case Law::coin:
      return 1;
  }
  return 0;
}

}  // namespace

QuantileTable::QuantileTable(Law law) {
  for (std::size_t octave = 0; octave < 32; ++octave) {
    const auto tail = [&](std::size_t i) {
      return std::ldexp(1 + static_cast<double>(i) / kIntervals, -static_cast<int>(octave) - 2);
    };
    double start = quantile(law, tail(0));
    for (std::size_t i = 0; i < kIntervals; ++i) {
      const double end = quantile(law, tail(i + 1));
      intervals_[octave * kIntervals + i] = {static_cast<float>(start),
                                             static_cast<float>(std::ldexp(end - start, -25))};
      start = end;
    }
  }
}

const QuantileTable& quantile_table(Law law) {
  static const std::array<QuantileTable, 4> kTables{
      QuantileTable(Law::gaussian), QuantileTable(Law::uniform), QuantileTable(Law::laplace),
      QuantileTable(Law::coin)};
  return kTables[static_cast<std::size_t>(law)];
}

}  // namespace terrview
