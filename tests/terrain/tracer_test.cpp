// The promise of terrain/terrain.h on rounding, against an oracle that shares no code with it.
#include <gtest/gtest.h>

#include "terrain/terrain.h"
#include "tests/support/expectations.h"
#include "tests/support/judge.h"
#include "tests/support/random_scene.h"

namespace terrview {
namespace {

using oracle::Verdict;

constexpr int kRaysPerTerrain = 50;

struct Tally {
  int rays = 0;
  int hits = 0;
  int below = 0;
  int within_tolerance = 0;
  int beside = 0;

  void add(const std::optional<Hit>& hit, bool occluded, Verdict verdict) {
    ++rays;
    hits += hit ? 1 : 0;
    below += occluded && !hit ? 1 : 0;
    within_tolerance += verdict == Verdict::right_within_tolerance ? 1 : 0;
    beside += verdict == Verdict::right_beside ? 1 : 0;
  }
};

// Traces random rays over random terrains, and stops at the first that the oracle refutes.
template <class MakeTerrain>
Tally trace_and_judge(std::uint64_t seed, int rays, Position position, const MakeTerrain& make) {
  Tally tally;
  Random random(seed);
  while (tally.rays < rays) {
    const Terrain terrain = make(random);
    for (int i = 0; i < kRaysPerTerrain; ++i) {
      const Ray ray = random_ray(random, terrain, position);
      const auto hit = terrain.first_hit(ray);
      const bool occluded = terrain.occluded(ray);
      const oracle::Judgement judgement = oracle::judge(terrain, ray, hit, occluded);
      if (judgement.verdict == Verdict::wrong) {
        ADD_FAILURE() << "seed " << seed << ", ray " << tally.rays << ", " << oracle::to_string(ray)
                      << ": " << judgement.fault;
        return tally;
      }
      tally.add(hit, occluded, judgement.verdict);
    }
  }
  return tally;
}

// All three outcomes are common, or the rays were not worth tracing.
void expect_every_outcome(const Tally& tally) {
  EXPECT_GT(tally.hits, tally.rays / 5);
  EXPECT_GT(tally.below, tally.rays / 50);
  EXPECT_GT(tally.rays - tally.hits - tally.below, tally.rays / 5);
}

void expect_agreement_in_general_position(SurfaceModel model, std::uint64_t seed, int rays) {
  const Tally tally = trace_and_judge(seed, rays, Position::general, [model](Random& random) {
    return random_terrain(random, model, Position::general);
  });
  expect_every_outcome(tally);
  EXPECT_LE(tally.within_tolerance, rays / 100'000);
  EXPECT_EQ(tally.beside, 0);
}

void expect_agreement_in_special_position(SurfaceModel model, std::uint64_t seed, int rays) {
  const Tally tally = trace_and_judge(seed, rays, Position::special, [model](Random& random) {
    return random_terrain(random, model, Position::special);
  });
  expect_every_outcome(tally);
  EXPECT_LT(tally.within_tolerance, rays / 5);  // they begin on the ground, or meet it at a post
  EXPECT_LT(tally.beside, rays / 40);
}

void expect_agreement_over_several_grids(SurfaceModel model, std::uint64_t seed, int rays) {
  const Tally tally = trace_and_judge(seed, rays, Position::general, [model](Random& random) {
    return random_layers(random, model);
  });
  expect_every_outcome(tally);
  EXPECT_LE(tally.within_tolerance, rays / 100'000);
  EXPECT_EQ(tally.beside, 0);
}

void expect_agreement_on_bent_tracks(SurfaceModel model, std::uint64_t seed, int rays) {
  const Tally tally = trace_and_judge(seed, rays, Position::general, [model](Random& random) {
    return random_bent_terrain(random, model);
  });
  expect_every_outcome(tally);
  EXPECT_LE(tally.within_tolerance, rays / 100'000);
  EXPECT_EQ(tally.beside, 0);
}

class Tracer : public ModelTest {};

TEST_P(Tracer, AgreesWithAllCrossingsSorted) {
  expect_agreement_in_general_position(GetParam(), /*seed=*/1, /*rays=*/100'000);
}

TEST_P(Tracer, AgreesOnRaysThroughPostsAndAlongLines) {
  expect_agreement_in_special_position(GetParam(), /*seed=*/2, /*rays=*/30'000);
}

TEST_P(Tracer, AgreesOverSeveralGridsInOrderOfPreference) {
  expect_agreement_over_several_grids(GetParam(), /*seed=*/3, /*rays=*/30'000);
}

TEST_P(Tracer, AgreesOnTracksThatBendAndComeBack) {
  expect_agreement_on_bent_tracks(GetParam(), /*seed=*/4, /*rays=*/10'000);
}

class TracerLong : public ModelTest {};

TEST_P(TracerLong, AgreesWithAllCrossingsSorted) {
  expect_agreement_in_general_position(GetParam(), /*seed=*/5, /*rays=*/1'000'000);
}

TEST_P(TracerLong, AgreesOnRaysThroughPostsAndAlongLines) {
  expect_agreement_in_special_position(GetParam(), /*seed=*/6, /*rays=*/1'000'000);
}

TEST_P(TracerLong, AgreesOverSeveralGridsInOrderOfPreference) {
  expect_agreement_over_several_grids(GetParam(), /*seed=*/7, /*rays=*/1'000'000);
}

TEST_P(TracerLong, AgreesOnTracksThatBendAndComeBack) {
  expect_agreement_on_bent_tracks(GetParam(), /*seed=*/8, /*rays=*/200'000);
}

INSTANTIATE_TEST_SUITE_P(Models, Tracer, testing::ValuesIn(kSurfaceModels), model_name);
INSTANTIATE_TEST_SUITE_P(Models, TracerLong, testing::ValuesIn(kSurfaceModels), model_name);

}  // namespace
}  // namespace terrview
