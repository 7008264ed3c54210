// One test per promise of ingest/view_frame.h; directions are in true_direction_test.cpp.
#include "ingest/view_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include "terrain/error.h"
#include "tests/ingest/geodesy_cases.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

using cases::GridCase;

const GridCase kUtm{"utm.tif", "EPSG:32632", {350000, 5312000}, 75, {200, 300}, {0.5, 0.5}};
// The same ground.
const GridCase kGeographic{"geo.tif",  "EPSG:4326", {6.98, 47.95},
                           1.0 / 1200, {256, 256},  {0.5, 0.5}};

// Level ground at `height_m`.
Dem plain(const GridCase& grid, float height_m = 400) {
  Dem dem = cases::dem(grid);
  auto heights = std::make_shared<HeightGrid>(*dem.grid);
  std::fill(heights->heights_m.begin(), heights->heights_m.end(), height_m);
  dem.grid = heights;
  return dem;
}

Dem without_crs(Dem dem) {
  dem.crs_wkt.clear();
  return dem;
}

EyePlace over(const GridCase& grid, double height_m, bool above_ground = false) {
  return {.geographic = {},
          .projected = cases::placement(grid).at(cases::eye_uv(grid)),
          .height_m = height_m,
          .above_ground = above_ground};
}

std::string refused(const std::vector<Dem>& dems, const EyePlace& eye,
                    const ViewFrameOptions& options = {}) {
  try {
    const ViewFrame frame(dems, eye, options);
    return "";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
}

TEST(ViewFrameEye, StandsAboveTheGround) {
  const ViewFrame frame({plain(kUtm)}, over(kUtm, 2, true), {});
  EXPECT_DOUBLE_EQ(frame.eye().ground_m.value(), 400);
  EXPECT_DOUBLE_EQ(frame.eye().height_m, 402);
  EXPECT_DOUBLE_EQ(frame.terrain()->frame().eye_height_m, 402);
}

TEST(ViewFrameEye, IsTheSameInBothKindsOfCoordinates) {
  const ViewFrame projected({plain(kUtm)}, over(kUtm, 2, true), {});
  const ViewFrame geographic({plain(kUtm)},
                             {.geographic = projected.eye().geographic,
                              .projected = {},
                              .height_m = 2,
                              .above_ground = true},
                             {});
  EXPECT_LT(glm::distance(geographic.eye().projected, projected.eye().projected), 1e-6);
}

TEST(ViewFrameEye, MultipliesAbsoluteHeightsAlone) {
  const ViewFrame absolute({plain(kUtm)}, over(kUtm, 500), {.z_scale = 3});
  EXPECT_DOUBLE_EQ(absolute.terrain()->frame().eye_height_m, 1500);
  EXPECT_DOUBLE_EQ(absolute.eye().height_m, 500);
  const ViewFrame above({plain(kUtm)}, over(kUtm, 12, true), {.z_scale = 3});
  EXPECT_DOUBLE_EQ(above.terrain()->frame().eye_height_m, 1212);
  EXPECT_DOUBLE_EQ(above.eye().height_m, 404);
}

TEST(ViewFrameEye, UnderTheGroundIsRefusedSayingByHowMuch) {
  EXPECT_TRUE(says(refused({plain(kUtm)}, over(kUtm, 387.5)), {"12.500 m under", "400.000"}));
  EXPECT_TRUE(says(refused({plain(kUtm)}, over(kUtm, -1, true)), {"1.000 m under"}));
  EXPECT_EQ(refused({plain(kUtm)}, over(kUtm, 400)), "");
}

TEST(ViewFrameEye, MayStandOutsideTheDem) {
  GridCase beside = kUtm;
  beside.eye_share = {-1.5, 0.5};
  const ViewFrame frame({plain(kUtm)}, over(beside, 3000), {});
  EXPECT_FALSE(frame.eye().ground_m);
  const auto hit =
      frame.terrain()->first_hit({.direction = glm::normalize(glm::dvec3(30e3, 0, -2600))});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->position_m.x, 30e3, 2e3);
  EXPECT_TRUE(says(refused({plain(kUtm)}, over(beside, 2, true)), {"no ground", "+"}));
}

TEST(ViewFrameEye, TakesTheGroundOfTheFirstDemThatHasSome) {
  Dem hole = plain(kUtm, std::numeric_limits<float>::quiet_NaN());
  auto heights = std::make_shared<HeightGrid>(*hole.grid);
  heights->heights_m[0] = 1;
  hole.grid = heights;
  const ViewFrame frame({hole, plain(kUtm, 250), plain(kUtm, 300)}, over(kUtm, 0, true), {});
  EXPECT_DOUBLE_EQ(frame.eye().height_m, 250);
}

TEST(ViewFrameEye, NeedsAPlace) {
  EXPECT_NE(refused({plain(kUtm)}, {.geographic = {}, .projected = {}, .height_m = 3}), "");
  EXPECT_NE(refused({plain(kUtm)}, {.geographic = GeoPoint{91, 7}, .projected = {}}), "");
  EXPECT_NE(refused({plain(kUtm)}, over(kUtm, std::nan(""))), "");
  EXPECT_TRUE(says(refused({without_crs(plain(kUtm))},
                           {.geographic = GeoPoint{47, 7}, .projected = {}, .height_m = 900}),
                   {"--eye-xy", "--a-srs"}));
}

TEST(ViewFrame, RefusesToMixDemsWithAndWithoutCoordinates) {
  Dem lost = without_crs(plain(kGeographic));
  EXPECT_TRUE(says(refused({plain(kUtm), lost}, over(kUtm, 900)), {"geo.tif", "--a-srs"}));
  EXPECT_TRUE(says(refused({lost, plain(kUtm)}, over(kUtm, 900)), {"geo.tif", "--a-srs"}));
}

TEST(ViewFrame, WithoutADemIsFlatAndHasNoGround) {
  const ViewFrame frame({}, {std::nullopt, glm::dvec2(10, 20), 5, false}, {});
  EXPECT_FALSE(frame.is_geographic());
  EXPECT_EQ(frame.to_ground_from_projected({13, 16}), glm::dvec2(3, -4));
  EXPECT_EQ(frame.projected_from_ground({3, -4}), glm::dvec2(13, 16));
  EXPECT_FALSE(frame.terrain()->ground_at({0, 0}));
  for (const glm::dvec3 direction : {glm::dvec3(0, 0, -1), glm::dvec3(1, 2, -3)}) {
    EXPECT_FALSE(frame.terrain()->first_hit({.origin_m = {0, 0, 0}, .direction = direction}));
    EXPECT_FALSE(frame.terrain()->occluded({.origin_m = {0, 0, 0}, .direction = direction}));
  }
}

TEST(ViewFrame, RefusesOptionsThatMakeNoView) {
  EXPECT_TRUE(says(refused({}, {GeoPoint{48, 7}, std::nullopt, 900, false}), {"no DEM"}));
  EXPECT_NE(refused({plain(kUtm)}, over(kUtm, 900), {.z_scale = 0}), "");
  EXPECT_NE(refused({plain(kUtm)}, over(kUtm, 900), {.refraction = 1.5}), "");
  Dem row = plain({"row.tif", "EPSG:32632", {350000, 5312000}, 75, {200, 1}, {0.5, 0.5}});
  EXPECT_TRUE(says(refused({row}, over(kUtm, 900)), {"row.tif", "200 x 1"}));
  Dem line = plain(kUtm);
  line.placement.step[1] = line.placement.step[0];
  EXPECT_TRUE(says(refused({line}, over(kUtm, 900)), {"geotransform"}));
}

TEST(ViewFrame, WarnsOfVerticalDatumsThatDiffer) {
  Dem first = plain(kUtm);
  Dem second = plain(kUtm);
  EXPECT_TRUE(ViewFrame({first, second}, over(kUtm, 900), {}).warnings().empty());
  first.vertical_datum = "EGM96 geoid";
  EXPECT_TRUE(ViewFrame({first, second}, over(kUtm, 900), {}).warnings().empty());
  second.vertical_datum = "Normaal Amsterdams Peil";
  const auto warnings = ViewFrame({first, second}, over(kUtm, 900), {}).warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(says(warnings[0], {"EGM96 geoid", "Normaal Amsterdams Peil"}));
}

TEST(ViewFrame, ReturnsEveryPlaceToItself) {
  for (const GridCase& grid : {kUtm, kGeographic}) {
    for (const EarthModel earth : {EarthModel::curved, EarthModel::flat}) {
      const ViewFrame frame({plain(grid)}, over(grid, 900), {.earth = earth});
      std::mt19937_64 random(9);
      std::uniform_real_distribution<double> across_m(-9000, 9000);
      for (int i = 0; i < 200; ++i) {
        const glm::dvec2 ground_m(across_m(random), across_m(random));
        EXPECT_LT(glm::distance(frame.to_ground(frame.from_ground(ground_m)), ground_m), 2e-8);
        const glm::dvec2 xy = frame.projected_from_ground(ground_m);
        EXPECT_LT(glm::distance(frame.to_ground_from_projected(xy), ground_m), 2e-8);
      }
    }
  }
}

TEST(ViewFrame, LaysAFlatEarthByTheMapAtTheEye) {
  const ViewFrame frame({plain(kUtm)}, over(kUtm, 900), {.earth = EarthModel::flat});
  EXPECT_EQ(frame.terrain()->frame().north_curvature_per_m, 0);
  EXPECT_EQ(frame.terrain()->frame().refraction, 0);
  EXPECT_EQ(frame.track_error_cells(), 0);
  // Straight lines of the grid stay straight, and near the eye metres are true ones.
  const glm::dvec2 centre = cases::placement(kUtm).at(cases::eye_uv(kUtm));
  const glm::dvec2 one = frame.to_ground_from_projected(centre + glm::dvec2(1000, 500));
  const glm::dvec2 ten = frame.to_ground_from_projected(centre + glm::dvec2(10000, 5000));
  EXPECT_LT(glm::distance(10.0 * one, ten), 1e-8);
  const glm::dvec2 exact = ground_from_geographic(*frame.eye().geographic, frame.from_ground(one));
  EXPECT_LT(glm::distance(one, exact), 0.01);
}

TEST(ViewFrame, TakesADemWithoutCoordinatesAsItLies) {
  const Dem dem = without_crs(plain(kUtm));
  const ViewFrame frame({dem}, over(kUtm, 900), {});
  EXPECT_FALSE(frame.is_geographic());
  EXPECT_TRUE(frame.operations().empty());
  const glm::dvec2 eye = cases::placement(kUtm).at(cases::eye_uv(kUtm));
  EXPECT_EQ(frame.to_ground_from_projected(eye + glm::dvec2(120, -30)), glm::dvec2(120, -30));
  EXPECT_EQ(frame.to_true_enu({120, -30, 5}), glm::dvec3(120, -30, 5));
  EXPECT_EQ(frame.terrain()->ground_at({120, -30})->scene_height_m, 400);
}

TEST(ViewFrame, ListsTheOperationOfEveryDem) {
  const ViewFrame frame({plain(kUtm), plain(kGeographic)}, over(kUtm, 900), {});
  ASSERT_EQ(frame.operations().size(), 2U);
  EXPECT_EQ(frame.operations()[0].dem, "utm.tif");
  EXPECT_EQ(frame.operations()[1].dem, "geo.tif");
}

TEST(ViewFrame, PutsOnePlaceOfTwoDemsInOnePlace) {
  const ViewFrame frame({plain(kUtm), plain(kGeographic)}, over(kUtm, 900), {});
  ASSERT_EQ(frame.terrain()->layers().size(), 2U);
  const auto utm = cases::transform(kUtm);
  const auto geographic = cases::transform(kGeographic);
  for (double x_m = -7000; x_m <= 7000; x_m += 500) {
    const glm::dvec2 ground_m(x_m, 0.7 * x_m);
    glm::dvec2 first = kUtm.north_west + kUtm.spacing * glm::dvec2(1, -1) *
                                             frame.terrain()->layers()[0].map->to_grid(ground_m);
    glm::dvec2 second =
        kGeographic.north_west + kGeographic.spacing * glm::dvec2(1, -1) *
                                     frame.terrain()->layers()[1].map->to_grid(ground_m);
    utm->to_geographic({&first, 1});
    geographic->to_geographic({&second, 1});
    // Two hundredths of a cell of 75 m.
    EXPECT_LT(glm::length((first - second) * glm::dvec2(74e3, 111e3)), 1.5);
  }
}

TEST(ViewFrame, MeasuresItsErrors) {
  const ViewFrame frame({cases::dem(kGeographic)}, over(kGeographic, 5000), {});
  EXPECT_GT(frame.track_error_cells(), 0);
  EXPECT_LE(frame.track_error_cells(), GroundMap::kTrackError_cells);
  EXPECT_GT(frame.direction_error_rad(), 0);
  EXPECT_LT(frame.direction_error_rad(), 6e-5);
}

TEST(ViewFrame, SeesAcrossTheAntimeridian) {
  NEEDS_SHARED_DATA();
  const std::string path = shared_data("tricky/made_from_vosges/antimeridian.tif");
  const Dem dem = read_one(path);
  // From the eastern end, which is at -179.97 degrees, to the western one.
  const ViewFrame frame({dem},
                        {.geographic = GeoPoint{47.91, -179.972},
                         .projected = {},
                         .height_m = 2,
                         .above_ground = true},
                        {});
  EXPECT_TRUE(frame.eye().ground_m);
  EXPECT_NEAR(frame.eye().projected.x, 180.028, 1e-9);
  const glm::dvec2 west = frame.to_ground({47.91, 179.982});
  EXPECT_LT(west.x, -3000);
  EXPECT_TRUE(frame.terrain()->ground_at(west));
  EXPECT_TRUE(frame.terrain()->first_hit(
      {.direction = glm::normalize(glm::dvec3(west, -1500 * glm::length(west) / 3000))}));
}

TEST(ViewFrame, SeesADemBesideThePole) {
  NEEDS_SHARED_DATA();
  const std::string path = shared_data("tricky/made_from_vosges/near_pole.tif");
  const Dem dem = read_one(path);
  // From the pole itself, down the DEM's meridians.
  const ViewFrame frame({dem}, {.geographic = GeoPoint{90, 0}, .projected = {}, .height_m = 2000},
                        {});
  const glm::dvec2 middle =
      frame.to_ground_from_projected(dem.placement.at(glm::dvec2(31.5, 31.5)));
  EXPECT_NEAR(glm::length(middle), 4.1e3, 100);
  const auto ground = frame.terrain()->ground_at(middle);
  ASSERT_TRUE(ground);
  const double z_m = frame.terrain()->frame().at(middle).z_m(ground->scene_height_m);
  const auto hit =
      frame.terrain()->first_hit({.direction = glm::normalize(glm::dvec3(middle, z_m))});
  ASSERT_TRUE(hit);
  EXPECT_LE(hit->distance_m, glm::length(glm::dvec3(middle, z_m)) + 1);
}

}  // namespace
}  // namespace terrview
