// One test per promise of ingest/sight.h.
#include "ingest/sight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace terrview {
namespace {

constexpr double kCurvature_per_m = 1 / 6371000.0;

VerticalFrame frame(double eye_height_m, double refraction) {
  return {.eye_height_m = eye_height_m,
          .north_curvature_per_m = kCurvature_per_m,
          .east_curvature_per_m = kCurvature_per_m,
          .refraction = refraction};
}

TEST(Sight, ReachesBeyondWhateverCanBeSeen) {
  for (const double eye_m : {2.0, 500.0, 4000.0, 400e3}) {
    for (const double refraction : {-0.2, 0.0, 0.13, 0.5}) {
      for (const double summit_m : {100.0, 4800.0}) {
        // Two horizons on a sphere that refraction flattens.
        const double flattened_m = 1 / ((1 - refraction) * kCurvature_per_m);
        const double seen_m =
            std::sqrt(2 * eye_m * flattened_m) + std::sqrt(2 * summit_m * flattened_m);
        const double shadow_m = 2 * std::sqrt(2 * summit_m / kCurvature_per_m);
        const double sight = sight_m(frame(eye_m, refraction), 0, summit_m);
        EXPECT_LT(sight, 1.05 * (seen_m + shadow_m));
        if (eye_m < 1e5) {
          EXPECT_GT(sight, seen_m + 0.99 * shadow_m);
        }
      }
    }
  }
}

TEST(Sight, LeavesRoomForShadows) {
  // A summit of 4800 m throws its shadow over the sea up to 247 km away, and another so high sees
  // the same from there.
  EXPECT_GT(sight_m(frame(2, 0), 0, 4800), 2 * 247e3);
}

TEST(Sight, OfAnEyeBelowAllGroundIsNotLess) { EXPECT_GT(sight_m(frame(0, 0), 1000, 4000), 200e3); }

TEST(Sight, StaysBelowAQuarterOfTheEarth) {
  EXPECT_LE(sight_m(frame(36e6, 0.13), -10000, 9000), 1.4 / kCurvature_per_m * (1 + 1e-12));
  EXPECT_LE(sight_m(frame(2, 1), 0, 4800), 1.4 / kCurvature_per_m * (1 + 1e-12));
}

TEST(Sight, HasNoEndOnAFlatEarth) { EXPECT_TRUE(std::isinf(sight_m({}, 0, 100))); }

}  // namespace
}  // namespace terrview
