// The sky views of rays through Embree beside those of the sweep: bench/light_study.h.
#include <gtest/gtest.h>

#include <vector>

#include <glm/matrix.hpp>

#include "bench/light_study.h"
#include "terrain/sky_view.h"

namespace terrview {
namespace {

BenchDem plain_dem() {
  HeightGrid grid{33, 33, std::vector<float>(33 * 33, 100)};
  return make_bench_dem("plain", std::move(grid), glm::dmat2(30, 0, 0, -30));
}

TEST(EmbreeSkyTracer, SeesAllOfTheSkyOverAPlain) {
  const BenchDem dem = plain_dem();
  const SkyTracer trace = embree_sky_tracer(dem);
  const std::vector<glm::ivec2> posts{{16, 16}, {3, 20}};
  for (const double share : trace(posts, 64)) EXPECT_EQ(share, 1);
}

// What is left does not fall with the number of rays, but with the relief from post to post: the
// sweep mixes the horizons of two lines of posts, and rays see triangles.
TEST(EmbreeSkyTracer, AgreesWithTheSweepOverMountains) {
  const BenchDem dem = synthetic_mountains(513);
  const SkyTracer trace = embree_sky_tracer(dem);
  SkyViewSweep sweep(*dem.grid, glm::inverse(dem.step_m), 1, 64);
  for (int step = 0; step < sweep.steps(); ++step) {
    for (int part = 0; part < sweep.parts(step); ++part) sweep.sweep(step, part);
  }
  const SkyView view = sweep.result();
  std::vector<glm::ivec2> posts;
  for (int i = 0; i < 40; ++i) posts.emplace_back(10 + (i * 137) % 493, 10 + (i * 253) % 493);
  const std::vector<double> traced = trace(posts, 4096);
  for (std::size_t i = 0; i < posts.size(); ++i)
    EXPECT_NEAR(view.at(posts[i]), traced[i], 0.012) << posts[i].x << ' ' << posts[i].y;
}

}  // namespace
}  // namespace terrview
