// What the study of light and air says: bench/light_study.h.
#include "bench/light_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include <glm/matrix.hpp>

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
  if (!trace) GTEST_SKIP() << "built without Embree";
  const std::vector<glm::ivec2> posts{{16, 16}, {3, 20}};
  for (const double share : trace(posts, 64)) EXPECT_EQ(share, 1);
}

TEST(EmbreeSkyTracer, AgreesWithTheSweepOverMountains) {
  const BenchDem dem = synthetic_mountains(129);
  const SkyTracer trace = embree_sky_tracer(dem);
  if (!trace) GTEST_SKIP() << "built without Embree";
  SkyViewSweep sweep(*dem.grid, glm::inverse(dem.step_m), 1, 64);
  for (int step = 0; step < sweep.steps(); ++step) {
    for (int part = 0; part < sweep.parts(step); ++part) sweep.sweep(step, part);
  }
  const SkyView view = sweep.result();
  std::vector<glm::ivec2> posts;
  for (int i = 0; i < 40; ++i) posts.emplace_back(10 + (i * 37) % 109, 10 + (i * 53) % 109);
  const std::vector<double> traced = trace(posts, 2048);
  for (std::size_t i = 0; i < posts.size(); ++i)
    EXPECT_NEAR(view.at(posts[i]), traced[i], 0.025) << posts[i].x << ' ' << posts[i].y;
}

TEST(LightStudy, NamesEveryEffectWithItsCost) {
  std::ostringstream out;
  print_effect_costs(out, synthetic_mountains(65), {32, 24}, 1);
  for (const char* effect :
       {"none", "none, again", "soft shadows", "air", "level of detail", "sky view",
        "adaptive rays", "haze", "preview", "progressive", "sparkle"})
    EXPECT_NE(out.str().find(effect), std::string::npos) << effect;
}

}  // namespace
}  // namespace terrview
