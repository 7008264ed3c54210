// Small grids of whole numbers, where nearly every ray is special: it passes through posts, along
// edges, grazes and touches. RapidCheck shrinks what it finds.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "terrain/terrain.h"
#include "tests/support/judge.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

HeightGrid any_small_grid() {
  const int columns = *rc::gen::inRange(2, 5);
  const int rows = *rc::gen::inRange(2, 5);
  const auto heights = *rc::gen::container<std::vector<int>>(
      static_cast<std::size_t>(columns * rows), rc::gen::inRange(-2, 4));
  const int void_post = *rc::gen::inRange(0, 2 * columns * rows);
  return make_grid(columns, rows, [&](int column, int row) {
    const int post = row * columns + column;
    return post == void_post ? double{kVoid} : heights[static_cast<std::size_t>(post)];
  });
}

glm::dvec3 any_quarter_point() {
  const auto quarters = [] { return *rc::gen::inRange(-4, 17) / 4.0; };
  return {quarters(), -quarters(), quarters() - 1};
}

RC_GTEST_PROP(SmallGrid, AnyRayAgreesWithTheOracleUnderEveryModel, ()) {
  const HeightGrid grid = any_small_grid();
  RC_PRE(height_range(grid).lowest_m <= height_range(grid).highest_m);
  for (const SurfaceModel model : kSurfaceModels) {
    const Terrain terrain = make_terrain(grid, {}, model);
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 from_m = any_quarter_point();
      const Ray ray{from_m, any_quarter_point() - from_m};
      if (ray.direction == glm::dvec3(0)) continue;
      const auto judgement = oracle::judge(terrain, ray);
      RC_LOG() << name_of(model) << ", " << oracle::to_string(ray) << ": " << judgement.fault;
      RC_ASSERT(judgement.verdict != oracle::Verdict::wrong);
    }
  }
}

}  // namespace
}  // namespace terrview
