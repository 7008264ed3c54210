#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "bench/bench_dem.h"
#include "render/parallel.h"
#include "samples/mountains.h"
#include "terrain/huge_pages.h"

namespace terrview {
namespace {

constexpr double kPost_m = 30;
constexpr float kRelief_m = 2000;
constexpr double kLongestWave_m = 15000;
constexpr double kShortestWave_m = 2 * kPost_m;
constexpr double kGain = 0.55;  // amplitude of an octave over the one before: fractal dimension 2.1

constexpr int kBlock_posts = 48;   // of the city, streets included
constexpr int kStreet_posts = 14;  // the narrowest

// SplitMix64's finaliser (Steele, Lea & Flood, OOPSLA 2014).
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

std::uint64_t key_of(int a, int b, int c) {
  const auto part = [](int x) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)); };
  return mix(mix(mix(part(a)) + 0x9e3779b97f4a7c15U + part(b)) + 0x9e3779b97f4a7c15U + part(c));
}

// In [0, 1).
double uniform(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

// The slope of the noise at a point of its lattice, times the way from there.
double pull(int octave, int column, int row, double dx, double dy) {
  const std::uint64_t key = key_of(octave, column, row);
  return (2 * uniform(key) - 1) * dx + (2 * uniform(mix(key + 1)) - 1) * dy;
}

double blend(double from, double to, double share) { return from + share * (to - from); }

double fade(double t) { return t * t * t * (t * (6 * t - 15) + 10); }

double gradient_noise(int octave, double x, double y) {
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const double dx = x - column;
  const double dy = y - row;
  const double s = fade(dx);
  const double north =
      blend(pull(octave, column, row, dx, dy), pull(octave, column + 1, row, dx - 1, dy), s);
  const double south = blend(pull(octave, column, row + 1, dx, dy - 1),
                             pull(octave, column + 1, row + 1, dx - 1, dy - 1), s);
  return blend(north, south, fade(dy));
}

float mountain(int column, int row) {
  double height = 0;
  double amplitude = 1;
  int octave = 0;
  for (double wave_m = kLongestWave_m; wave_m >= kShortestWave_m; wave_m /= 2) {
    height +=
        amplitude * gradient_noise(octave++, column * kPost_m / wave_m, row * kPost_m / wave_m);
    amplitude *= kGain;
  }
  return static_cast<float>(height);
}

float roof(int column, int row) {
  const int block_column = column / kBlock_posts;
  const int block_row = row / kBlock_posts;
  const auto chance = [&](int what) { return uniform(key_of(what, block_column, block_row)); };
  const auto wall = [&](int what) {
    return kStreet_posts / 2 + static_cast<int>(chance(what) * 8);
  };
  const int x = column % kBlock_posts;
  const int y = row % kBlock_posts;
  const bool inside =
      x >= wall(1) && y >= wall(2) && x <= kBlock_posts - wall(3) && y <= kBlock_posts - wall(4);
  if (!inside) return 0;
  const double tallness = chance(5) * chance(6) * chance(7);  // few are tall
  return static_cast<float>(std::floor(6 + 84 * tallness));
}

template <class Height>
HeightGrid fill_grid(int side_posts, Height height) {
  const auto side = static_cast<std::size_t>(side_posts);
  HeightGrid grid{side_posts, side_posts, floats_in_huge_pages(side * side, 0)};
  parallel_for(side_posts, 0, [&](int row) {
    float* heights_m = grid.heights_m.data() + static_cast<std::size_t>(row) * side;
    for (int column = 0; column < side_posts; ++column) heights_m[column] = height(column, row);
  });
  return grid;
}

}  // namespace

BenchDem synthetic_mountains(int side_posts) {
  HeightGrid grid = fill_grid(side_posts, mountain);
  const HeightRange range = height_range(grid);
  const float scale = kRelief_m / (range.highest_m - range.lowest_m);
  for (float& height_m : grid.heights_m) height_m = (height_m - range.lowest_m) * scale;
  return make_bench_dem("synthetic-" + std::to_string(side_posts), std::move(grid),
                        {kPost_m, 0, 0, -kPost_m});
}

BenchDem synthetic_city(int side_posts) {
  return make_bench_dem("city-" + std::to_string(side_posts), fill_grid(side_posts, roof),
                        {1, 0, 0, -1});
}

BenchDem thesis_mountains() {
  const HeightGrid sample = make_mountains();
  HeightGrid grid = fill_grid(256, [&](int column, int row) { return sample.at(column, row); });
  return make_bench_dem("thesis", std::move(grid), {60, 0, 0, -90});
}

}  // namespace terrview
