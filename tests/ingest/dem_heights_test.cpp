// One test per promise of ingest/dem.h about heights: units, nodata, what is no height.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "ingest/height_unit.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class DemHeights : public testing::Test {
 protected:
  // The heights of a raster whose voids stay open.
  Dem read_open(const TestRaster& raster, DemOptions options = {}) {
    options.fill_voids = false;
    return read_one(raster.write(folder_ / "a.tif"), options);
  }

  TemporaryFolder folder_;
};

// 9 x 9 heights of 500 m and `other` in the middle.
TestRaster with_middle(double other) {
  TestRaster raster;
  raster.columns = raster.rows = 9;
  raster.number = [other](int column, int row) { return column == 4 && row == 4 ? other : 500; };
  return raster;
}

TEST_F(DemHeights, EveryTypeOfNumberIsRead) {
  for (const GDALDataType type : {GDT_Byte, GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32,
                                  GDT_Float32, GDT_Float64, GDT_Int64, GDT_UInt64}) {
    TestRaster raster;
    raster.type = type;
    EXPECT_EQ(read_open(raster).grid->at(3, 2), 132) << GDALGetDataTypeName(type);
  }
}

TEST_F(DemHeights, ComplexNumbersAreRefused) {
  TestRaster raster;
  raster.type = GDT_CFloat32;
  EXPECT_TRUE(says(refusal({raster.write(folder_ / "a.tif")}), {"a.tif", "complex", "-b"}));
}

TEST_F(DemHeights, ScaleAndOffsetComeBeforeTheUnit) {
  TestRaster raster;
  raster.type = GDT_Int16;
  raster.scale = 0.5;
  raster.offset = 1000;
  raster.unit = "ft";
  EXPECT_FLOAT_EQ(read_open(raster).grid->at(3, 2), 0.3048F * (132 * 0.5F + 1000));
}

TEST_F(DemHeights, TheUnitOfTheBandIsHonoured) {
  TestRaster raster;
  for (const auto& [unit, metres] :
       {std::pair{"m", 1.0}, {"ft", 0.3048}, {"US survey foot", 1200.0 / 3937}, {"cm", 0.01}}) {
    raster.unit = unit;
    EXPECT_FLOAT_EQ(read_open(raster).grid->at(3, 2), static_cast<float>(132 * metres)) << unit;
  }
}

TEST_F(DemHeights, AnUnknownUnitIsTakenForMetresWithAWarning) {
  TestRaster raster;
  raster.unit = "kelvin";
  const Dem dem = read_open(raster);
  EXPECT_EQ(dem.grid->at(3, 2), 132);
  ASSERT_EQ(dem.warnings.size(), 1U);
  EXPECT_TRUE(says(dem.warnings[0], {"kelvin", "--z-unit"}));
}

TEST_F(DemHeights, TheUsersUnitReplacesTheFiles) {
  TestRaster raster;
  raster.unit = "m";
  DemOptions options;
  options.height_unit = "us-ft";
  EXPECT_FLOAT_EQ(read_open(raster, options).grid->at(3, 2), 132 * 1200.0F / 3937);
  options.height_unit = "parsec";
  EXPECT_TRUE(says(refusal({folder_ / "a.tif"}, options), {"--z-unit parsec", "us-ft"}));
}

TEST_F(DemHeights, TheHeightSpacingReplacesTheFilesUnit) {
  TestRaster raster;
  raster.unit = "ft";
  DemOptions options;
  options.spacing = glm::dvec2(50, 50);
  options.height_factor = 2;
  EXPECT_EQ(read_open(raster, options).grid->at(3, 2), 264);
  options.height_factor = 1;
  EXPECT_EQ(read_open(raster, options).grid->at(3, 2), 132);
  options.height_factor = 0;
  EXPECT_TRUE(says(refusal({folder_ / "a.tif"}, options), {"--spacing", "DZ"}));
  options.height_factor = 1;
  options.height_unit = "ft";
  EXPECT_TRUE(says(refusal({folder_ / "a.tif"}, options), {"--z-unit"}));
}

TEST(HeightUnit, NamesAreReadAsPeopleWriteThem) {
  EXPECT_EQ(metres_per_height_unit("Metres"), 1.0);
  EXPECT_EQ(metres_per_height_unit("US_survey_foot"), 1200.0 / 3937);
  EXPECT_EQ(metres_per_height_unit("us-ft"), 1200.0 / 3937);
  EXPECT_EQ(metres_per_height_unit("FEET"), 0.3048);
  EXPECT_EQ(metres_per_height_unit("furlong"), std::nullopt);
  EXPECT_EQ(metres_per_height_unit(""), std::nullopt);
}

TEST_F(DemHeights, NodataNaNAndInfinityAreNoHeights) {
  for (const double nothing : {-9999.0, kNaN, kInfinity, -kInfinity}) {
    TestRaster raster = with_middle(nothing);
    raster.nodata = -9999;
    const Dem dem = read_open(raster);
    EXPECT_TRUE(std::isnan(dem.grid->at(4, 4))) << nothing;
    EXPECT_EQ(dem.voids_open, 1U);
    EXPECT_TRUE(dem.warnings.empty());
  }
}

TEST_F(DemHeights, NodataIsComparedBeforeScaling) {
  TestRaster raster = with_middle(255);
  raster.type = GDT_UInt16;
  raster.scale = 0.1;
  raster.nodata = 255;
  const Dem dem = read_open(raster);
  EXPECT_TRUE(std::isnan(dem.grid->at(4, 4)));
  EXPECT_FLOAT_EQ(dem.grid->at(0, 0), 50);
}

TEST_F(DemHeights, NodataIsFoundInEveryTypeOfNumber) {
  TestRaster lowest_float = with_middle(-std::numeric_limits<float>::max());
  lowest_float.nodata = -3.40282346638529e+38;  // as GDAL writes it in text
  TestRaster lowest_int64 = with_middle(-9223372036854775808.0);
  lowest_int64.type = GDT_Int64;
  lowest_int64.nodata = -9223372036854775808.0;
  TestRaster short_float = with_middle(-99.99F);
  short_float.nodata = -99.99;
  for (const TestRaster& raster : {lowest_float, lowest_int64, short_float}) {
    const Dem dem = read_open(raster);
    EXPECT_TRUE(std::isnan(dem.grid->at(4, 4)));
    EXPECT_TRUE(dem.warnings.empty());
  }
}

TEST_F(DemHeights, TheUsersNodataReplacesTheFiles) {
  TestRaster raster = with_middle(7);
  raster.nodata = 500;
  DemOptions options;
  options.nodata = 7;
  const Dem dem = read_open(raster, options);
  EXPECT_TRUE(std::isnan(dem.grid->at(4, 4)));
  EXPECT_EQ(dem.grid->at(0, 0), 500);
}

TEST_F(DemHeights, AMaskInTheFileIsHonoured) {
  TestRaster raster = with_middle(500);
  raster.change = [](GDALDataset& dataset) {
    dataset.CreateMaskBand(GMF_PER_DATASET);
    GDALRasterBand& mask = *dataset.GetRasterBand(1)->GetMaskBand();
    mask.Fill(255);
    unsigned char masked = 0;
    ASSERT_EQ(mask.RasterIO(GF_Write, 4, 4, 1, 1, &masked, 1, 1, GDT_Byte, 0, 0, nullptr), CE_None);
  };
  EXPECT_TRUE(std::isnan(read_open(raster).grid->at(4, 4)));
}

TEST_F(DemHeights, AUsualNodataNumberThatStandsAloneIsNoHeight) {
  for (const char* number : {"-32768", "-32767", "-9999", "-99999", "32767", "65535"}) {
    const Dem dem = read_open(with_middle(std::stod(number)));
    EXPECT_TRUE(std::isnan(dem.grid->at(4, 4))) << number;
    ASSERT_EQ(dem.warnings.size(), 1U);
    EXPECT_TRUE(says(dem.warnings[0], {std::string("a.tif: 1 post of ") + number,
                                       std::string("--nodata ") + number}));
  }
}

TEST_F(DemHeights, AUsualNodataNumberAmongOthersLikeItIsAHeight) {
  TestRaster sea = with_middle(-9999);
  sea.number = [](int column, int row) { return column == 4 && row == 4 ? -9999 : -9200 + row; };
  const Dem dem = read_open(sea);
  EXPECT_EQ(dem.grid->at(4, 4), -9999);
  EXPECT_TRUE(dem.warnings.empty());
  // Those like it in other rows.
  for (const double number : {-9999.0, 32767.0}) {
    TestRaster steps = with_middle(number);
    steps.number = [number](int column, int row) {
      if (column == 4 && row == 4) return number;
      return row == 4 ? 0 : 0.99 * number;
    };
    EXPECT_EQ(read_open(steps).grid->at(4, 4), static_cast<float>(number));
  }
}

TEST_F(DemHeights, AUsualNodataNumberIsAHeightIfTheUserNamesAnother) {
  DemOptions options;
  options.nodata = -1;
  EXPECT_EQ(read_open(with_middle(-9999), options).grid->at(4, 4), -9999);
}

TEST_F(DemHeights, WhatNoBodyIsHighEnoughForIsNoHeight) {
  const Dem dem = read_open(with_middle(1e30));
  EXPECT_TRUE(std::isnan(dem.grid->at(4, 4)));
  ASSERT_EQ(dem.warnings.size(), 1U);
  EXPECT_TRUE(says(dem.warnings[0], {"a.tif", "1e+30 m at column 4, row 4", "--z-unit"}));
  EXPECT_EQ(read_open(with_middle(-21'000)).grid->at(4, 4), -21'000);
  TestRaster in_hectometres = with_middle(2000);
  in_hectometres.scale = 100;
  const Dem scaled = read_open(in_hectometres);
  EXPECT_TRUE(std::isnan(scaled.grid->at(4, 4)));
  EXPECT_EQ(scaled.grid->at(0, 0), 50'000);
}

TEST_F(DemHeights, ADemWithoutHeightsIsRefusedAndSaysWhy) {
  TestRaster raster;
  raster.nodata = 5;
  raster.number = [](int, int) { return 5; };
  EXPECT_TRUE(says(refusal({raster.write(folder_ / "a.tif")}), {"a.tif", "--nodata"}));
  raster.number = [](int, int) { return 1.7e6; };
  EXPECT_TRUE(says(refusal({raster.write(folder_ / "a.tif")}), {"a.tif", "--z-unit"}));
}

TEST_F(DemHeights, ADemWithoutHeightsBesideAnotherIsLeftOut) {
  TestRaster empty;
  empty.nodata = 5;
  empty.number = [](int, int) { return 5; };
  empty.geotransform = {{900000, 50, 0, 5300000, 0, -50}};
  const auto dems =
      read_dems({empty.write(folder_ / "empty.tif"), TestRaster{}.write(folder_ / "a.tif")});
  ASSERT_EQ(dems.size(), 1U);
  EXPECT_TRUE(says(dems[0].name, {"a.tif"}));
  ASSERT_EQ(dems[0].warnings.size(), 1U);
  EXPECT_TRUE(says(dems[0].warnings[0], {"empty.tif"}));
}

TEST_F(DemHeights, TheChosenBandIsRead) {
  TestRaster raster;
  raster.bands = 3;
  DemOptions options;
  options.band = 2;
  EXPECT_EQ(read_open(raster, options).grid->at(0, 0), 1100);
  for (const int band : {0, 4, -1}) {
    options.band = band;
    EXPECT_TRUE(says(refusal({folder_ / "a.tif"}, options), {"a.tif", "-b 1 to 3"}));
  }
}

TEST_F(DemHeights, APictureGetsAWarning) {
  TestRaster raster;
  raster.bands = 3;
  raster.type = GDT_Byte;
  raster.creation_options = {"PHOTOMETRIC=RGB"};
  const Dem dem = read_open(raster);
  ASSERT_EQ(dem.warnings.size(), 1U);
  EXPECT_TRUE(says(dem.warnings[0], {"Red", "-b"}));
}

TEST_F(DemHeights, BlocksOfAnyShapeGiveTheSameHeights) {
  TestRaster raster;
  raster.columns = 2100;
  raster.rows = 1100;
  raster.number = [](int column, int row) { return (column * 31 + row * 17) % 5003; };
  const auto expected = read_open(raster).grid->heights_m;
  ASSERT_EQ(expected[2100 * 1099 + 2099], (2099 * 31 + 1099 * 17) % 5003);
  for (const std::vector<std::string>& layout :
       {std::vector<std::string>{"TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=64"},
        {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=1600", "COMPRESS=DEFLATE"},
        {"BLOCKYSIZE=1100"},
        {"BLOCKYSIZE=7"}}) {
    raster.creation_options = layout;
    DemOptions options;
    EXPECT_EQ(read_open(raster, options).grid->heights_m, expected) << layout[0];
    options.window = {3, 5, 2000, 1050};
    const Dem part = read_open(raster, options);
    EXPECT_EQ(part.grid->at(0, 0), expected[5 * 2100 + 3]);
    EXPECT_EQ(part.grid->at(1999, 1049), expected[1054 * 2100 + 2002]);
  }
}

TEST_F(DemHeights, EveryFormatGivesTheSameHeightsAndLeavesNothingBeside) {
  TestRaster raster;
  raster.nodata = -9999;
  const Dem expected = read_open(raster);
  for (const auto& [driver, name] : {std::pair{"COG", "cog.tif"},
                                     {"VRT", "virtual.vrt"},
                                     {"EHdr", "ehdr.bil"},
                                     {"ENVI", "envi.img"},
                                     {"HFA", "imagine.img"},
                                     {"AAIGrid", "ascii.asc"},
                                     {"GSBG", "surfer.grd"},
                                     {"netCDF", "net.nc"},
                                     {"XYZ", "points.xyz"}}) {
    if (GetGDALDriverManager()->GetDriverByName(driver) == nullptr) continue;
    const std::string path = folder_ / name;
    if (driver == std::string("VRT")) {
      build_vrt(path, {folder_ / "a.tif"});
    } else {
      raster.write(path, driver);
    }
    const auto files = names_in(folder_.path());
    DemOptions options;
    options.crs = "EPSG:32632";  // some formats keep none
    const Dem dem = read_one(path, options);
    EXPECT_EQ(dem.grid->heights_m, expected.grid->heights_m) << driver;
    EXPECT_NEAR(dem.placement.origin.x, expected.placement.origin.x, 1e-6) << driver;
    EXPECT_NEAR(dem.placement.origin.y, expected.placement.origin.y, 1e-6) << driver;
    EXPECT_EQ(names_in(folder_.path()), files) << driver;
  }
}

TEST_F(DemHeights, FilesInArchivesAreRead) {
  const std::string path = TestRaster{}.write(folder_ / "a.tif");
  const std::string zip = "/vsizip/" + (folder_ / "a.zip") + "/inside.tif";
  VSILFILE* archive = VSIFOpenL(zip.c_str(), "wb");
  ASSERT_NE(archive, nullptr);
  const std::string bytes = read_text(path);
  EXPECT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), archive), bytes.size());
  VSIFCloseL(archive);
  EXPECT_EQ(read_one(zip).grid->at(3, 2), 132);
}

TEST_F(DemHeights, AnAsciiGridWhoseDecimalsComeLateIsNotRounded) {
  std::string text = "ncols 200\nnrows 700\nxllcorner 400000\nyllcorner 5300000\ncellsize 50\n";
  for (int row = 0; row < 700; ++row) {
    for (int column = 0; column < 200; ++column) text += row < 699 ? "12 " : "12.75 ";
    text += "\n";
  }
  write_text(folder_ / "a.asc", text);
  EXPECT_EQ(read_one(folder_ / "a.asc").grid->at(7, 699), 12.75F);
}

}  // namespace
}  // namespace terrview
