// What tests of the tracer expect of a ray, each judged by the oracle as well.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "terrain/terrain.h"
#include "tests/support/judge.h"
#include "tests/support/scenes.h"

namespace terrview {

// A suite that runs once for each surface model.
class ModelTest : public testing::TestWithParam<SurfaceModel> {
 protected:
  static Terrain terrain(HeightGrid grid, const Place& place) {
    return make_terrain(std::move(grid), place, GetParam());
  }
};

inline std::string model_name(const testing::TestParamInfo<SurfaceModel>& info) {
  return name_of(info.param);
}

// What the ray meets, after the oracle has agreed.
inline std::optional<Hit> judged_hit(const Terrain& terrain, const Ray& ray) {
  const auto judgement = oracle::judge(terrain, ray);
  EXPECT_NE(judgement.verdict, oracle::Verdict::wrong)
      << oracle::to_string(ray) << ": " << judgement.fault;
  return terrain.first_hit(ray);
}

// Bit for bit.
inline void expect_same_hit(const Hit& found, const Hit& expected, const Ray& ray) {
  EXPECT_EQ(found.distance_m, expected.distance_m) << oracle::to_string(ray);
  EXPECT_EQ(found.position_m, expected.position_m) << oracle::to_string(ray);
  EXPECT_EQ(found.uv, expected.uv) << oracle::to_string(ray);
  EXPECT_EQ(found.cell, expected.cell) << oracle::to_string(ray);
  EXPECT_EQ(found.grid, expected.grid) << oracle::to_string(ray);
}

inline void expect_hit_at(const Terrain& terrain, const Ray& ray, double distance_m,
                          double tolerance_m) {
  const auto hit = judged_hit(terrain, ray);
  ASSERT_TRUE(hit) << oracle::to_string(ray);
  EXPECT_NEAR(hit->distance_m, distance_m, tolerance_m) << oracle::to_string(ray);
  EXPECT_TRUE(terrain.occluded(ray));
}

inline void expect_free(const Terrain& terrain, const Ray& ray) {
  EXPECT_FALSE(judged_hit(terrain, ray)) << oracle::to_string(ray);
  EXPECT_FALSE(terrain.occluded(ray)) << oracle::to_string(ray);
}

inline void expect_ends_below(const Terrain& terrain, const Ray& ray) {
  EXPECT_FALSE(judged_hit(terrain, ray)) << oracle::to_string(ray);
  EXPECT_TRUE(terrain.occluded(ray)) << oracle::to_string(ray);
}

}  // namespace terrview
