#include "samples/mountains.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sky/erosion.h"

namespace terrview {
namespace {

using Line = std::vector<double>;

// A crest in the west, a valley that opens to the south, a chain with a lone summit in the east.
// North is up.
const HeightRows kDrawnRelief_m{{750, 960, 1100, 990, 800, 690, 710, 630, 470},
                                {800, 1060, 1270, 1110, 840, 630, 750, 690, 460},
                                {870, 990, 1200, 1040, 710, 550, 800, 770, 430},
                                {830, 1040, 1320, 960, 590, 590, 910, 750, 390},
                                {770, 990, 1160, 840, 500, 690, 990, 690, 370},
                                {730, 1100, 1230, 750, 450, 650, 1290, 800, 350},
                                {690, 920, 990, 630, 410, 510, 880, 610, 330},
                                {610, 800, 840, 550, 390, 390, 550, 470, 310},
                                {510, 630, 650, 470, 370, 350, 370, 340, 300}};

constexpr double kFirstDisplacement_m = 200;
constexpr double kDecay = 0.46;   // 2^-h for h = 1.1: old, rounded mountains
constexpr double kFloor_m = 320;  // displacement grows from a quarter here
constexpr double kRough_m = 900;  // to its full size here
constexpr std::uint64_t kSeed = 1984;

// SplitMix64's finaliser (Steele, Lea & Flood, OOPSLA 2014).
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

// Nearly normal, mean 0 and variance 1, keyed by the post: the sum of twelve uniforms less 6.
// Integers until the end, because the C library's logarithm may round otherwise elsewhere.
double random_normal(std::size_t level, std::size_t column, std::size_t row) {
  std::uint64_t state = kSeed;
  for (const std::size_t key : {level, column, row}) state = mix(state + 0x9e3779b97f4a7c15U + key);
  std::uint64_t sum = 0;
  for (int i = 0; i < 12; ++i) sum += mix(state += 0x9e3779b97f4a7c15U) >> 32;
  return static_cast<double>(sum) / 4294967296.0 - 6;
}

// A line with the 4-point midpoints in between; past its ends it goes on straight.
Line with_midpoints(const Line& coarse) {
  const std::size_t last = coarse.size() - 1;
  Line fine;
  for (std::size_t i = 0; i < last; ++i) {
    const double before = i > 0 ? coarse[i - 1] : 2 * coarse[0] - coarse[1];
    const double after = i + 2 <= last ? coarse[i + 2] : 2 * coarse[last] - coarse[last - 1];
    fine.push_back(coarse[i]);
    fine.push_back((9 * (coarse[i] + coarse[i + 1]) - (before + after)) / 16);
  }
  fine.push_back(coarse[last]);
  return fine;
}

// Every row with its midpoints, transposed: done twice, it refines both ways.
HeightRows refined_and_transposed(const HeightRows& coarse) {
  HeightRows fine(2 * coarse[0].size() - 1, Line(coarse.size()));
  for (std::size_t row = 0; row < coarse.size(); ++row) {
    const Line line = with_midpoints(coarse[row]);
    for (std::size_t column = 0; column < line.size(); ++column) fine[column][row] = line[column];
  }
  return fine;
}

void displace(HeightRows& relief, std::size_t level, double displacement_m) {
  for (std::size_t row = 1; row + 1 < relief.size(); ++row)
    for (std::size_t column = 1; column + 1 < relief.size(); ++column) {
      double& height_m = relief[row][column];
      const double rise = (height_m - kFloor_m) / (kRough_m - kFloor_m);
      height_m += std::clamp(rise, 0.25, 1.0) * displacement_m * random_normal(level, column, row);
    }
}

}  // namespace

HeightGrid make_mountains() {
  HeightRows relief = kDrawnRelief_m;
  double displacement_m = kFirstDisplacement_m;
  for (std::size_t level = 1; relief.size() < kSampleSize_posts; ++level) {
    relief = refined_and_transposed(refined_and_transposed(relief));
    displace(relief, level, displacement_m);
    if (level > 2) erode(relief);
    displacement_m *= kDecay;
  }
  HeightGrid grid{kSampleSize_posts, kSampleSize_posts, {}};
  for (const Line& row : relief)
    for (const double height_m : row)
      grid.heights_m.push_back(static_cast<float>(std::floor(height_m + 0.5)));
  return grid;
}

}  // namespace terrview
