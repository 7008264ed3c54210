#include "bench/sky/field_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/study_text.h"
#include "sky/field_part.h"
#include "sky/field_stream.h"

namespace terrview {
namespace {

constexpr int kRepetitions = 5;

// Keeps a result from being optimised away.
volatile float kept;

// One root cell as a sum of octaves, each interpolated between hashed lattice values: what a shader
// writer would do.
float noise_sum(const RandomField& field, double x, double y) {
  float sum = 0;
  for (int level = 0; level <= field.levels(); ++level) {
    const double u = std::ldexp(x, level);
    const double v = std::ldexp(y, level);
    const auto i = static_cast<std::int64_t>(u);
    const auto j = static_cast<std::int64_t>(v);
    const auto s = static_cast<float>(u - static_cast<double>(i));
    const auto t = static_cast<float>(v - static_cast<double>(j));
    const KeyedRandom& random = field.random();
    const std::uint64_t south = random.row_key(level, j);
    const std::uint64_t north = random.row_key(level, j + 1);
    const auto at = [&](std::uint64_t row, std::int64_t column) {
      return random.first(KeyedRandom::bits(row, column));
    };
    const float below = at(south, i) + s * (at(south, i + 1) - at(south, i));
    const float above = at(north, i) + s * (at(north, i + 1) - at(north, i));
    sum += field.deviation(level) * (below + t * (above - below));
  }
  return sum;
}

RandomField field_of(FieldKind kind, int levels) {
  FieldOptions options;
  options.kind = kind;
  options.levels = {levels, levels};
  return RandomField(options);
}

double part_seconds(FieldKind kind, int levels) {
  const RandomField field = field_of(kind, levels);
  const std::int64_t side = (std::int64_t{1} << levels) + 1;
  return seconds_of([&] { kept = field_part(field, {0, 0, side, side}).back(); });
}

double stream_seconds(int levels) {
  const RandomField field = field_of(FieldKind::midpoint, levels);
  return seconds_of([&] {
    float sum = 0;
    stream_root_cell(field, {0, 0},
                     [&](const FieldCorners& cell) { sum += cell.south_west.value; });
    kept = sum;
  });
}

double noise_seconds(int levels) {
  const RandomField field = field_of(FieldKind::displaced, levels);
  const int side = (1 << levels) + 1;
  const double step = std::ldexp(1.0, -levels);
  return seconds_of([&] {
    float sum = 0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) sum += noise_sum(field, i * step, j * step);
    kept = sum;
  });
}

}  // namespace

double seconds_of(const std::function<void()>& work) {
  std::vector<double> seconds;
  for (int i = 0; i < kRepetitions; ++i) {
    const double start = thread_seconds();
    work();
    seconds.push_back(thread_seconds() - start);
  }
  std::nth_element(seconds.begin(), seconds.begin() + kRepetitions / 2, seconds.end());
  return seconds[kRepetitions / 2];
}

void print_field_rates(const std::vector<int>& levels) {
  std::printf("Mvertices/s, one thread        streamed  midpoint  displaced  smooth  noise sum\n");
  for (const int n : levels) {
    const double vertices = std::pow(std::ldexp(1.0, n) + 1, 2) * 1e-6;
    std::printf("%2d levels, %9.0f vertices  %8.1f  %8.1f  %9.1f  %6.1f  %9.1f\n", n,
                vertices * 1e6, vertices / stream_seconds(n),
                vertices / part_seconds(FieldKind::midpoint, n),
                vertices / part_seconds(FieldKind::displaced, n),
                vertices / part_seconds(FieldKind::smooth, n), vertices / noise_seconds(n));
  }
}

}  // namespace terrview
