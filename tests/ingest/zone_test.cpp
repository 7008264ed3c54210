// One test per promise of ingest/zone.h and ingest/zone_file.h; the traps that users have found in
// other programs are in zone_traps_test.cpp.
#include "ingest/zone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "ingest/zone_file.h"
#include "render/objects/object_set.h"
#include "terrain/error.h"
#include "tests/ingest/test_raster.h"
#include "tests/ingest/zone_cases.h"

namespace terrview {
namespace {

using cases::laid_flat;
using cases::target_at;

TEST(Zone, CountsTheTargetsSeen) {
  // A wall hides the low target from behind it, and not the high one.
  const Dem dem = laid_flat(21, 3, 10, [](int c, int) { return c == 10 ? 20.0 : 0.0; });
  const Zone zone = visible_zone({dem}, {target_at({0, 10}, 5), target_at({0, 10}, 500)});
  EXPECT_EQ(zone.counts[zone.index(5, 1)], 2);
  EXPECT_EQ(zone.counts[zone.index(15, 1)], 1);
  EXPECT_EQ(zone.angles_rad[zone.index(15, 1)], 0);
}

TEST(Zone, SubtendsTheLargestAngleBetweenTargetsSeen) {
  const Dem dem = laid_flat(21, 21, 10, [](int, int) { return 0.0; });
  // Across: 20 m apart, 100 m away; upright: 30 m above them. The observer's eye is at 1.6 m.
  const Zone zone = visible_zone(
      {dem}, {target_at({90, 200}, 1.6), target_at({110, 200}, 1.6), target_at({100, 200}, 31.6)});
  const double across = 2 * std::atan(10.0 / 100);
  const double upright = std::acos(100 * 100 / std::hypot(100, 10) / std::hypot(100, 30));
  EXPECT_NEAR(zone.angles_rad[zone.index(10, 10)], std::max(across, upright), 1e-6);
}

TEST(Zone, SubtendsTheSameAngleOnACurvedEarth) {
  const Dem dem = cases::sea("EPSG:32632", {500000, 5300000}, 100, {101, 101});
  const EyePlace foot = target_at({505000, 5299000}, 20);
  const EyePlace top = target_at({505000, 5299000}, 80);
  const Zone zone = visible_zone({dem}, {foot, top});
  // 8 km to the south; UTM is 0.04 percent short at its meridian.
  EXPECT_NEAR(zone.angles_rad[zone.index(50, 90)], 60.0 / 8000, 6e-6);
}

TEST(Zone, HasNoDataWhereTheDemHasNone) {
  const Dem dem = laid_flat(5, 5, 10, [](int c, int r) { return c == 1 && r == 2 ? NAN : 0.0; });
  const Zone zone = visible_zone({dem}, {target_at({20, 20}, 9)});
  EXPECT_EQ(std::count(zone.counts.begin(), zone.counts.end(), Zone::kNoData), 1);
  EXPECT_EQ(zone.counts[zone.index(1, 2)], Zone::kNoData);
  EXPECT_EQ(zone.angles_rad[zone.index(1, 2)], Zone::kNoData);
}

TEST(Zone, SeesNothingOfATargetUnderTheGround) {
  const Dem dem = laid_flat(5, 5, 10, [](int, int) { return 7.0; });
  const Zone zone = visible_zone({dem}, {target_at({20, 20}, 6.5), target_at({20, 20}, 7.5)});
  EXPECT_EQ(zone.counts, std::vector<float>(25, 1));
}

TEST(Zone, SeesTargetsBesideTheDem) {
  const Dem dem = laid_flat(11, 3, 10, [](int c, int) { return c == 5 ? 30.0 : 0.0; });
  const Zone zone = visible_zone({dem}, {target_at({-200, 10}, 20)});
  EXPECT_EQ(zone.counts[zone.index(5, 1)], 1);
  EXPECT_EQ(zone.counts[zone.index(9, 1)], 0);
}

TEST(Zone, ScalesHeightsButNotTheObserver) {
  // Scaled by 10 the sill of 1 m hides what lies behind it from a target at 5 m * 10.
  const Dem dem = laid_flat(41, 3, 10, [](int c, int) { return c == 20 ? 1.0 : 0.0; });
  const EyePlace target = target_at({0, 10}, 1.5);
  const Zone plain = visible_zone({dem}, {target});
  const Zone scaled = visible_zone({dem}, {target}, {.frame = {.z_scale = 10}});
  EXPECT_EQ(plain.counts[plain.index(40, 1)], 1);
  EXPECT_EQ(scaled.counts[scaled.index(30, 1)], 0);
}

// 3 m and 4 m of target make 30 m and 40 m, over ground of 2 m that makes 20 m.
TEST(Zone, SubtendsTheAngleOfScaledHeights) {
  const Dem dem = laid_flat(21, 3, 10, [](int, int) { return 2.0; });
  const Zone zone = visible_zone({dem}, {target_at({0, 10}, 3), target_at({0, 10}, 4)},
                                 {.observer_m = 1.6, .frame = {.z_scale = 10}});
  const double expected = std::atan((40 - 21.6) / 100) - std::atan((30 - 21.6) / 100);
  EXPECT_NEAR(zone.angles_rad[zone.index(10, 1)], expected, 1e-6);
}

TEST(Zone, IsHiddenByObstacles) {
  struct Hedge final : ObjectSet {
    Hedge() : ObjectSet({}) {}
    [[nodiscard]] std::optional<ObjectHit> first_hit(const Ray&, ObjectCounts*) const override {
      return std::nullopt;
    }
    [[nodiscard]] bool stops(const Ray& ray, ObjectCounts*) const override {
      return ray.direction.x > 0;
    }
  };
  const Dem dem = laid_flat(5, 5, 10, [](int, int) { return 0.0; });
  ZoneOptions options;
  options.obstacles = [](const ViewFrame&) { return std::make_shared<Hedge>(); };
  const Zone zone = visible_zone({dem}, {target_at({20, 20}, 5)}, options);
  for (int column = 0; column < 5; ++column)
    EXPECT_EQ(zone.counts[zone.index(column, 0)], column <= 2 ? 1 : 0);
}

TEST(Zone, IsThatOfItsOnlyCell) {
  const Dem cell = laid_flat(2, 2, 10, [](int c, int r) { return 3.0 * c - r; });
  const Zone zone = visible_zone({cell}, {target_at({5, 5}, 10)});
  EXPECT_EQ(zone.counts, std::vector<float>(4, 1));
  const Dem post = laid_flat(1, 1, 10, [](int, int) { return 0.0; });
  EXPECT_THROW(static_cast<void>(visible_zone({post}, {target_at({0, 0}, 10)})), InputError);
}

// Posts of the second DEM are no part of the zone, but its ground hides.
TEST(Zone, IsHiddenByTheGroundOfOtherDems) {
  const Dem dem = laid_flat(21, 3, 10, [](int, int) { return 0.0; });
  Dem wall = laid_flat(5, 11, 10, [](int c, int) { return c == 2 ? 50.0 : 0.0; });
  wall.placement.origin += glm::dvec2(-70, -40);
  const Zone zone = visible_zone({dem, wall}, {target_at({-100, 10}, 20)});
  EXPECT_EQ(std::count(zone.counts.begin(), zone.counts.end(), 0.0F), 21 * 3);
  const Zone alone = visible_zone({dem}, {target_at({-100, 10}, 20)});
  EXPECT_EQ(std::count(alone.counts.begin(), alone.counts.end(), 1.0F), 21 * 3);
}

TEST(Zone, IsTheSameByRaysAlone) {
  const Dem dem = cases::laid("EPSG:4326", {9.5, 47.3}, 1.0 / 1200,
                              cases::grid_of({150, 150}, [](int c, int r) {
                                return 400 * std::sin(c * 0.11) * std::cos(r * 0.13);
                              }));
  const std::vector<EyePlace> targets{target_at({9.56, 47.24}, 500),
                                      target_at({9.561, 47.24}, 520)};
  ZoneOptions plain;
  plain.plain = true;
  const Zone found = visible_zone({dem}, targets);
  const Zone expected = visible_zone({dem}, targets, plain);
  EXPECT_EQ(found.counts, expected.counts);
  EXPECT_EQ(found.angles_rad, expected.angles_rad);
  EXPECT_GT(std::count(found.counts.begin(), found.counts.end(), 2.0F), 2000);
}

TEST(Zone, RefusesWhatMakesNoZone) {
  const Dem dem = laid_flat(5, 5, 10, [](int, int) { return 0.0; });
  EXPECT_THROW(static_cast<void>(visible_zone({}, {target_at({0, 0}, 5)})), InputError);
  EXPECT_THROW(static_cast<void>(visible_zone({dem}, {})), InputError);
  EXPECT_THROW(static_cast<void>(visible_zone({dem}, {target_at({20, 20}, 5)}, {.observer_m = -1})),
               InputError);
  try {
    static_cast<void>(visible_zone({dem}, {target_at({20, 20}, 5), target_at({20, 20}, NAN)}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(says(error.what(), {"target 2: "}));
  }
}

TEST(ZoneFile, LiesOnTheDemsPosts) {
  const TemporaryFolder folder;
  TestRaster raster;
  raster.nodata = 120;
  const std::string dem_path = raster.write(folder / "dem.tif");
  DemOptions as_is;
  as_is.fill_voids = false;
  const Dem dem = read_one(dem_path, as_is);
  const glm::dvec2 middle = dem.placement.at({2, 1});
  const Zone zone = visible_zone({dem}, {target_at(middle, 300), target_at(middle, 400)});
  write_zone(folder / "zone.tif", zone, "a zone");

  GDALDatasetUniquePtr written(GDALDataset::Open((folder / "zone.tif").c_str()));
  GDALDatasetUniquePtr original(GDALDataset::Open(dem_path.c_str()));
  ASSERT_TRUE(written);
  ASSERT_EQ(written->GetRasterCount(), 2);
  std::array<double, 6> at{};
  std::array<double, 6> expected{};
  written->GetGeoTransform(at.data());
  original->GetGeoTransform(expected.data());
  EXPECT_EQ(at, expected);
  EXPECT_TRUE(written->GetSpatialRef()->IsSame(original->GetSpatialRef()));
  EXPECT_STREQ(written->GetMetadataItem("TIFFTAG_IMAGEDESCRIPTION"), "a zone");
  for (const int number : {1, 2}) {
    GDALRasterBand& band = *written->GetRasterBand(number);
    EXPECT_EQ(band.GetNoDataValue(), Zone::kNoData);
    std::vector<float> values(20);
    ASSERT_EQ(band.RasterIO(GF_Read, 0, 0, 5, 4, values.data(), 5, 4, GDT_Float32, 0, 0), CE_None);
    for (std::size_t post = 0; post < 20; ++post) {
      const float angle_deg = zone.angles_rad[post] * static_cast<float>(180 / std::numbers::pi);
      const float found = number == 1                              ? zone.counts[post]
                          : zone.angles_rad[post] == Zone::kNoData ? Zone::kNoData
                                                                   : angle_deg;
      EXPECT_EQ(values[post], found);
    }
    EXPECT_EQ(values[2], Zone::kNoData);  // (2, 0): 120
  }
}

}  // namespace
}  // namespace terrview
