// One test per promise of ingest/dem.h about coordinate reference systems.
#include "ingest/dem_crs.h"

#include <gtest/gtest.h>

#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

class DemCrsTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TestRaster in_degrees() {
  TestRaster raster;
  raster.geotransform = {{7, 0.001, 0, 48, 0, -0.001}};
  raster.crs = "EPSG:4326";
  return raster;
}

TEST_F(DemCrsTest, LongitudesAreXWhateverTheAuthoritysAxisOrder) {
  const std::string path = in_degrees().write(folder_ / "a.tif");
  const Dem dem = read_one(path);
  EXPECT_NEAR(dem.placement.at({0, 0}).x, 7.0005, 1e-12);
  EXPECT_NEAR(dem.placement.at({0, 0}).y, 47.9995, 1e-12);
  EXPECT_TRUE(read_dem_header(path).geographic);
}

TEST_F(DemCrsTest, TheUsersCrsReplacesTheFiles) {
  DemOptions options;
  options.crs = "EPSG:2056";
  const Dem dem = read_one(TestRaster{}.write(folder_ / "a.tif"), options);
  EXPECT_TRUE(says(dem.crs_wkt, {"CH1903+"}));
  options.crs = "EPSG:424242";
  EXPECT_TRUE(says(refusal({folder_ / "a.tif"}, options), {"--a-srs EPSG:424242", "EPSG:4326"}));
}

TEST_F(DemCrsTest, WithoutACrsAGridIsFlat) {
  TestRaster raster;
  raster.crs.clear();
  EXPECT_EQ(read_one(raster.write(folder_ / "a.tif")).crs_wkt, "");
}

TEST_F(DemCrsTest, DegreesWithoutACrsAreRefusedUnlessTheUserSaysWhatTheyAre) {
  TestRaster raster = in_degrees();
  raster.crs.clear();
  const std::string path = raster.write(folder_ / "a.tif");
  EXPECT_TRUE(says(refusal({path}), {path, "--a-srs EPSG:4326"}));
  DemOptions with_crs;
  with_crs.crs = "EPSG:4326";
  EXPECT_EQ(refusal({path}, with_crs), "");
  DemOptions with_spacing;
  with_spacing.spacing = glm::dvec2(75, 111);
  EXPECT_EQ(refusal({path}, with_spacing), "");
  with_spacing.crs = "EPSG:4326";
  EXPECT_TRUE(says(refusal({path}, with_spacing), {"--a-srs"}));
}

TEST_F(DemCrsTest, MetresUnderAGeographicCrsAreRefused) {
  TestRaster raster;
  raster.crs = "EPSG:4326";
  const std::string path = raster.write(folder_ / "a.tif");
  EXPECT_TRUE(says(refusal({path}), {path, "--a-srs"}));
}

TEST_F(DemCrsTest, ACompoundCrsIsSplit) {
  TestRaster raster;
  raster.crs = "EPSG:25832+7837";
  const std::string path = raster.write(folder_ / "a.tif");
  const DemHeader header = read_dem_header(path);
  EXPECT_TRUE(says(header.crs_wkt, {"PROJCRS[\"ETRS89 / UTM zone 32N\""}));
  EXPECT_EQ(header.vertical_datum, "Deutsches Haupthoehennetz 2016");
  EXPECT_EQ(read_one(path).vertical_datum, header.vertical_datum);
}

TEST_F(DemCrsTest, TheUnitOfTheVerticalCrsIsThatOfTheHeights) {
  TestRaster raster;
  raster.crs = "EPSG:2263+6360";  // New York in US survey feet, NAVD88 in US survey feet
  const std::string path = raster.write(folder_ / "a.tif");
  EXPECT_NEAR(read_dem_header(path).metres_per_unit, 1200.0 / 3937, 1e-15);
  EXPECT_FLOAT_EQ(read_one(path).grid->at(0, 0), static_cast<float>(100 * 1200.0 / 3937));
}

TEST_F(DemCrsTest, AThreeDimensionalCrsLosesItsHeight) {
  TestRaster raster = in_degrees();
  raster.crs = "EPSG:4979";
  const Dem dem = read_one(raster.write(folder_ / "a.tif"));
  EXPECT_TRUE(says(dem.crs_wkt, {"CS[ellipsoidal,2]"}));
  EXPECT_EQ(dem.vertical_datum, "heights above the ellipsoid");
}

TEST_F(DemCrsTest, ALocalCrsIsFlatGroundIfItIsInMetres) {
  TestRaster raster;
  raster.crs = R"(LOCAL_CS["quarry",UNIT["metre",1]])";
  EXPECT_EQ(read_one(raster.write(folder_ / "m.tif")).crs_wkt, "");
  raster.crs = R"(LOCAL_CS["quarry",UNIT["foot",0.3048]])";
  const std::string feet = raster.write(folder_ / "ft.tif");
  EXPECT_TRUE(says(refusal({feet}), {feet, "--spacing"}));
  DemOptions options;
  options.spacing = glm::dvec2(3.048, 3.048);
  EXPECT_EQ(refusal({feet}, options), "");
}

TEST_F(DemCrsTest, ACrsThatHoldsNoDemIsRefused) {
  EXPECT_THROW(static_cast<void>(parse_crs("EPSG:4978")), InputError);  // geocentric
  EXPECT_THROW(static_cast<void>(parse_crs("EPSG:5773")), InputError);  // vertical
}

TEST_F(DemCrsTest, NamesAndCodesAreFound) {
  const Dem dem = read_one(TestRaster{}.write(folder_ / "a.tif"));
  EXPECT_EQ(crs_name(dem.crs_wkt), "WGS 84 / UTM zone 32N");
  EXPECT_EQ(crs_code(dem.crs_wkt), "EPSG:32632");
  // A .prj carries no code.
  const std::string grid = TestRaster{}.write(folder_ / "a.asc", "AAIGrid");
  EXPECT_EQ(crs_code(read_one(grid).crs_wkt), "EPSG:32632");
  EXPECT_EQ(crs_name(""), "");
  EXPECT_EQ(crs_code(""), "");
}

}  // namespace
}  // namespace terrview
