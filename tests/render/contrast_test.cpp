// One test per promise of render/contrast.h.
#include "render/contrast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/color_ramp.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

constexpr float kSky_m = std::numeric_limits<float>::infinity();

// Ground at several distances, sky, and samples that are not traced.
Raster<Sample> random_samples(glm::ivec2 size_px, Random& random) {
  Raster<Sample> samples(size_px.x, size_px.y);
  for (int row = 0; row < size_px.y; ++row) {
    for (int column = 0; column < size_px.x; ++column) {
      const double kind = random.uniform(0, 1);
      if (kind < 0.1) continue;
      Sample& sample = samples.at(column, row);
      for (int i = 0; i < 3; ++i) sample.color[i] = static_cast<float>(random.uniform(-0.2, 1.3));
      const auto distance_m = static_cast<float>(random.uniform(100, 150));
      sample.distance_m = kind < 0.3 ? kSky_m : kind < 0.4 ? 0 : distance_m;
    }
  }
  return samples;
}

// The plain twin: neighbour by neighbour.
void expect_same_as_one_by_one(const Raster<Sample>& samples, glm::ivec2 pixel, float contrast,
                               std::int32_t steps) {
  const Sample& here = samples.at(pixel.x, pixel.y);
  float most = 0;
  bool has_steps = false;
  for (int row = std::max(pixel.y - 1, 0); row < std::min(pixel.y + 2, samples.height_px()); ++row)
    for (int column = std::max(pixel.x - 1, 0); column < std::min(pixel.x + 2, samples.width_px());
         ++column) {
      const Sample& there = samples.at(column, row);
      if (!there.traced()) continue;
      has_steps |= depth_steps(here, there);
      if (here.ground() || there.ground())
        most = std::max(most, contrast_between(seen_color(here.color), seen_color(there.color)));
    }
  EXPECT_EQ(contrast, most) << pixel.x << ' ' << pixel.y;
  EXPECT_EQ(steps, has_steps ? 1 : 0) << pixel.x << ' ' << pixel.y;
}

TEST(SeenRows, TellOfEachPixelWhatItsNeighboursDo) {
  Random random(5);
  for (const glm::ivec2 size_px :
       {glm::ivec2(1, 1), glm::ivec2(1, 7), glm::ivec2(9, 1), glm::ivec2(37, 13)}) {
    const Raster<Sample> samples = random_samples(size_px, random);
    const auto width = static_cast<std::size_t>(size_px.x);
    std::vector<float> contrasts(width);
    std::vector<std::int32_t> steps(width);
    for (const int count : {1, 4, size_px.y}) {
      for (int first = 0; first < size_px.y; first += count) {
        const SeenRows seen(samples, first, count);
        for (int row = first; row < std::min(first + count, size_px.y); ++row) {
          seen.compare(row, contrasts, steps);
          for (int column = 0; column < size_px.x; ++column) {
            const auto i = static_cast<std::size_t>(column);
            if (samples.at(column, row).traced())
              expect_same_as_one_by_one(samples, {column, row}, contrasts[i], steps[i]);
          }
        }
      }
    }
  }
}

TEST(SeenColor, IsThatOfAFile) {
  const glm::vec3 seen = seen_color({0.5F, -1, 3});
  EXPECT_NEAR(seen.r, to_srgb(0.5F), 4e-6F);
  EXPECT_EQ(seen.g, 0);
  EXPECT_EQ(seen.b, 1);
}

}  // namespace
}  // namespace terrview
