// Buildings and trees on the ground of a view: ingest/buildings.h, ground_under.h.
#include "ingest/buildings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "ingest/ground_under.h"
#include "terrain/error.h"
#include "tests/ingest/test_raster.h"
#include "tests/ingest/true_earth.h"

namespace terrview {
namespace {

constexpr double kMetre_deg = 1 / 111200.0;

// Posts a minute apart about 48 N 7 E, rising by 30 m a post to the east.
class Buildings : public testing::Test {
 protected:
  Buildings() {
    TestRaster raster;
    raster.columns = 41;
    raster.rows = 41;
    raster.crs = "EPSG:4326";
    raster.geotransform = {{6.75, 1 / 80.0, 0, 48.25, 0, -1 / 80.0}};
    raster.number = [](int column, int) { return 500.0 + 30 * column; };
    dem_ = read_one(raster.write(folder_ / "slope.tif"));
  }

  [[nodiscard]] ViewFrame frame(double latitude_deg, double longitude_deg, double height_m,
                                double z_scale = 1) const {
    ViewFrameOptions options;
    options.z_scale = z_scale;
    EyePlace eye;
    eye.geographic = GeoPoint{latitude_deg, longitude_deg};
    eye.height_m = height_m;
    return {{dem_}, eye, options};
  }

  // A footprint about 48 N 7 E, its sides in metres.
  [[nodiscard]] static Footprint house(double side_m, int number = 1) {
    const double dx = side_m / 2 * kMetre_deg / std::cos(48 * 0.017453292519943295);
    const double dy = side_m / 2 * kMetre_deg;
    Footprint footprint;
    footprint.number = number;
    footprint.polygons = {
        {{{7 - dx, 48 - dy}, {7 + dx, 48 - dy}, {7 + dx, 48 + dy}, {7 - dx, 48 + dy}}}};
    return footprint;
  }

  [[nodiscard]] static FootprintFile file(std::vector<Footprint> footprints) {
    FootprintFile result;
    result.file = {.name = "houses",
                   .crs_wkt = "EPSG:4326",
                   .geographic = true,
                   .features = static_cast<int>(footprints.size()),
                   .warnings = {}};
    result.footprints = std::move(footprints);
    return result;
  }

  // The height at which a vertical ray meets the building at a place.
  [[nodiscard]] static double top_m(const ViewFrame& frame, const PlacedObjects& objects,
                                    const GeoPoint& place) {
    const glm::dvec2 ground_m = frame.to_ground(place);
    const auto hit =
        objects.scene_objects()->set->first_hit({{ground_m, 5000}, {0, 0, -1}}).value();
    return frame.terrain()->frame().at(ground_m).scene_height_m(hit.surface.position_m.z);
  }

  TemporaryFolder folder_;
  Dem dem_;
};

TEST_F(Buildings, StandOnTheLowestMeanOrHighestGroundUnderThem) {
  const ViewFrame from = frame(48.02, 7.0, 2000);
  Footprint footprint = house(400);
  footprint.height_m = 20;
  // 30 m a post of 932 m, so 12.9 m across the footprint; the middle is at 1085 m.
  const double half_m = 200 * 30 / 927.6;
  for (const auto& [base, expected_m] :
       {std::pair(BuildingBase::lowest, 1105 - half_m), std::pair(BuildingBase::mean, 1105.0),
        std::pair(BuildingBase::highest, 1105 + half_m)}) {
    PlacedObjects objects;
    place_buildings(file({footprint}), from, {.base = base}, objects);
    EXPECT_NEAR(top_m(from, objects, {48, 7}), expected_m, 0.05);
  }
}

TEST_F(Buildings, ReachBelowTheGroundEverywhere) {
  const ViewFrame from = frame(48.02, 7.0, 2000);
  for (const double side_m : {1.0, 30.0, 400.0, 3000.0}) {
    PlacedObjects objects;
    place_buildings(file({house(side_m)}), from, {.base = BuildingBase::highest}, objects);
    const glm::dvec2 middle_m = from.to_ground({48, 7});
    for (int i = 0; i < 100; ++i) {
      // Level rays just under the ground, at the wall downhill.
      const glm::dvec2 at = middle_m + glm::dvec2(-side_m / 2, side_m * (i - 50) / 110.0);
      const double ground_m = from.terrain()->ground_at(at)->scene_height_m;
      const double z_m = from.terrain()->frame().at(at).z_m(ground_m) - 0.5;
      EXPECT_TRUE(objects.scene_objects()->set->stops({{at - glm::dvec2(50, 0), z_m}, {1, 0, 0}}));
    }
  }
}

TEST_F(Buildings, HaveLevelRoofsInTheirTrueDirectionOnTheCurvedEarth) {
  // 15 km from the eye; 300 m across.
  const ViewFrame from = frame(47.9, 6.87, 3000);
  Footprint footprint = house(300);
  footprint.height_m = 25;
  PlacedObjects objects;
  place_buildings(file({footprint}), from, {}, objects);
  const double roof_m = top_m(from, objects, {48, 7});
  const auto& ring = footprint.polygons[0][0];
  for (const glm::dvec2& corner : ring) {
    const glm::dvec2 inside = corner + 0.01 * (glm::dvec2(7, 48) - corner);
    const GeoPoint place{inside.y, inside.x};
    // A plane instead of a level surface: r^2 / (2 R) at most, with r = 212 m.
    EXPECT_NEAR(top_m(from, objects, place), roof_m, 212.2 * 212.2 / (2 * 6.37e6));
    const glm::dvec3 truly = true_earth::enu({47.9, 6.87, 3000}, {inside.y, inside.x, roof_m});
    const glm::dvec2 ground_m = from.to_ground(place);
    const glm::dvec3 here =
        from.to_true_enu({ground_m, from.terrain()->frame().at(ground_m).z_m(roof_m)});
    EXPECT_LT(glm::length(glm::cross(glm::normalize(truly), glm::normalize(here))), 2e-6);
    const auto hit =
        objects.scene_objects()->set->first_hit({{0, 0, 0}, from.from_true_enu(truly)});
    EXPECT_TRUE(hit);
  }
}

TEST_F(Buildings, AreNotScaledWithTheGround) {
  Footprint footprint = house(20);
  footprint.height_m = 30;
  const ViewFrame from = frame(48.02, 7.0, 2000, 3);
  PlacedObjects objects;
  place_buildings(file({footprint}), from, {}, objects);
  const double ground_m = from.terrain()->ground_at(from.to_ground({48, 7}))->scene_height_m;
  EXPECT_NEAR(top_m(from, objects, {48, 7}), ground_m + 30, 2);
  EXPECT_GT(ground_m, 3000);
}

TEST_F(Buildings, MayBeginAboveTheGround) {
  Footprint footprint = house(20);
  footprint.height_m = 30;
  footprint.min_height_m = 20;
  const ViewFrame from = frame(48.02, 7.0, 2000);
  PlacedObjects objects;
  place_buildings(file({footprint}), from, {}, objects);
  const Box box = objects.objects.at(0)->bounds();
  EXPECT_NEAR(box.highest_m.z - box.lowest_m.z, 10, 0.1);
}

TEST_F(Buildings, WithoutAHeightHaveTheDefaultOverTheirBeginning) {
  Footprint footprint = house(20);
  footprint.min_height_m = 20;
  PlacedObjects objects;
  const ViewFrame from = frame(48.02, 7.0, 2000);
  EXPECT_EQ(place_buildings(file({footprint}), from, {}, objects).default_height, 1);
  const Box box = objects.objects.at(0)->bounds();
  EXPECT_NEAR(box.highest_m.z - box.lowest_m.z, 6, 0.1);
  EXPECT_EQ(objects.features.at(0).height_m, 26);
}

TEST_F(Buildings, ThatEndWhereTheyBeginAreCounted) {
  Footprint level = house(20, 1);
  level.height_m = level.min_height_m = 20;
  Footprint below = house(20, 2);
  below.height_m = 10;
  below.min_height_m = 20;
  PlacedObjects objects;
  const PlacedCounts counts =
      place_buildings(file({level, below}), frame(48.02, 7.0, 2000), {}, objects);
  EXPECT_EQ(counts.upside_down, 2);
  EXPECT_EQ(counts.placed, 0);
  EXPECT_TRUE(objects.objects.empty());
}

TEST_F(Buildings, KeepTheNumbersOfTheirFeatures) {
  Footprint far = house(20, 2);
  for (glm::dvec2& corner : far.polygons[0][0]) corner.x += 3;
  Footprint line = house(20, 3);
  for (glm::dvec2& corner : line.polygons[0][0]) corner.y = 48;
  Footprint two = house(20, 4);
  two.polygons.push_back(house(30).polygons[0]);
  two.height_m = 9;
  PlacedObjects objects;
  const ViewFrame from = frame(48.02, 7.0, 2000);
  const PlacedCounts counts =
      place_buildings(file({house(20), far, line, two}), from, {.default_height_m = 7}, objects);
  EXPECT_EQ(counts.features, 4);
  EXPECT_EQ(counts.placed, 2);
  EXPECT_EQ(counts.default_height, 1);
  EXPECT_EQ(counts.without_ground, 1);
  EXPECT_EQ(counts.without_area, 1);
  ASSERT_EQ(objects.looks.size(), 3U);
  EXPECT_EQ(objects.looks[0].id, 1);
  EXPECT_EQ(objects.looks[1].id, 4);
  EXPECT_EQ(objects.looks[2].id, 4);
  ASSERT_EQ(objects.features.size(), 2U);
  EXPECT_EQ(objects.features[0].height_m, 7);
  EXPECT_EQ(objects.features[1].height_m, 9);

  TreeFile trees;
  trees.file = file({}).file;
  trees.file.features = 1;
  trees.trees.resize(1);
  trees.trees[0].number = 1;
  trees.trees[0].place = {7.001, 48};
  place_trees(trees, from, objects);
  EXPECT_EQ(objects.looks.back().id, 5) << "after the four features before";
  EXPECT_NEAR(top_m(from, objects, {48, 7.001}),
              from.terrain()->ground_at(from.to_ground({48, 7.001}))->scene_height_m + 10, 1e-3);
}

TEST_F(Buildings, NowhereOnTheEarthAreRefused) {
  Footprint footprint = house(20, 7);
  footprint.polygons[0][0][2].y = 95;
  PlacedObjects objects;
  try {
    place_buildings(file({footprint}), frame(48.02, 7.0, 2000), {}, objects);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(says(error.what(), {"'houses', feature 7", "nowhere"}));
  }
}

}  // namespace
}  // namespace terrview
