// One test per guard of ingest/dem.h against files that lie, break off or carry code.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ingest/gdal_scope.h"
#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

class DemGuards : public testing::Test {
 protected:
  std::string write_vrt(const std::string& size, const std::string& band) {
    write_text(folder_ / "a.vrt", "<VRTDataset " + size +
                                      "><SRS>EPSG:32632</SRS>"
                                      "<GeoTransform>400000,50,0,5300000,0,-50</GeoTransform>" +
                                      band + "</VRTDataset>");
    return folder_ / "a.vrt";
  }

  TemporaryFolder folder_;
};

TEST_F(DemGuards, AClaimOfHugeSizeIsRefusedBeforeAllocation) {
  const std::string path = write_vrt("rasterXSize='100000' rasterYSize='1632895392'",
                                     "<VRTRasterBand dataType='Float32' band='1'/>");
  EXPECT_TRUE(says(refusal({path}), {path, "100000 x 1632895392", "memory", "--window"}));
  DemOptions options;
  options.window = {70000, 1600000000, 3, 2};
  EXPECT_EQ(read_one(path, options).grid->columns, 3);
}

TEST_F(DemGuards, TheMemoryLimitIsHeeded) {
  TestRaster raster;
  raster.columns = raster.rows = 600;
  const std::string path = raster.write(folder_ / "a.tif");
  DemOptions options;
  options.memory_bytes = 1 << 20;
  EXPECT_TRUE(says(refusal({path}, options), {path, "600 x 600", "1 MiB"}));
  options.memory_bytes = 4 << 20;
  EXPECT_EQ(refusal({path}, options), "");
}

TEST_F(DemGuards, FewerThanTwoByTwoPostsAreNoGround) {
  TestRaster raster;
  for (const auto& [columns, rows] : {std::pair{1, 1}, {5, 1}, {1, 5}}) {
    raster.columns = columns;
    raster.rows = rows;
    const std::string path = raster.write(folder_ / "a.tif");
    EXPECT_TRUE(says(refusal({path}), {path, "2 x 2"}));
  }
  raster.columns = raster.rows = 2;
  EXPECT_EQ(refusal({raster.write(folder_ / "a.tif")}), "");
}

TEST_F(DemGuards, FilesThatAreNoRastersAreNamed) {
  EXPECT_TRUE(says(refusal({folder_ / "none.tif"}), {"none.tif", "no such file"}));
  write_text(folder_ / "empty.tif", "");
  EXPECT_TRUE(says(refusal({folder_ / "empty.tif"}), {"empty.tif", "empty"}));
  write_text(folder_ / "letter.tif", "Dear reader,\nthis is no raster.\n");
  EXPECT_TRUE(says(refusal({folder_ / "letter.tif"}), {"letter.tif", "not a raster"}));
  EXPECT_TRUE(says(refusal({folder_ / ""}), {"not a raster"}));
  EXPECT_TRUE(says(refusal({}), {"no DEM"}));
}

TEST_F(DemGuards, AContainerOfRastersIsRefusedNamingOneOfThem) {
  GDALAllRegister();
  ASSERT_NE(GetGDALDriverManager()->GetDriverByName("netCDF"), nullptr);
  TestRaster raster;
  raster.bands = 2;
  const std::string path = raster.write(folder_ / "a.nc", "netCDF");
  EXPECT_TRUE(says(refusal({path}), {path, "NETCDF:", ":Band1"}));
  EXPECT_EQ(refusal({"NETCDF:" + path + ":Band2"}), "");
}

TEST_F(DemGuards, ATruncatedFileIsRefusedWithoutNoise) {
  TestRaster raster;
  raster.columns = raster.rows = 100;
  const std::string path = raster.write(folder_ / "a.tif");
  write_text(path, read_text(path).substr(0, 20000));
  testing::internal::CaptureStderr();
  EXPECT_TRUE(says(refusal({path}), {path, "cannot be read to its end"}));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

constexpr const char* kPythonBand =
    "<VRTRasterBand dataType='Float32' band='1' subClass='VRTDerivedRasterBand'>"
    "<PixelFunctionLanguage>Python</PixelFunctionLanguage>"
    "<PixelFunctionType>f</PixelFunctionType><PixelFunctionCode><![CDATA["
    "def f(*args, **kwargs): open('MARK', 'w')"
    "]]></PixelFunctionCode></VRTRasterBand>";

std::string python_band(const std::string& mark) {
  std::string band = kPythonBand;
  return band.replace(band.find("MARK"), 4, mark);
}

TEST_F(DemGuards, CodeInAVrtIsRefused) {
  const std::string path =
      write_vrt("rasterXSize='4' rasterYSize='4'", python_band(folder_ / "ran"));
  EXPECT_TRUE(says(refusal({path}), {path, "code"}));
  EXPECT_EQ(read_text(folder_ / "ran"), "");
}

TEST_F(DemGuards, CodeInAVrtWithinAVrtIsNotRunEither) {
  const std::string inner =
      write_vrt("rasterXSize='4' rasterYSize='4'", python_band(folder_ / "ran"));
  write_text(folder_ / "outer.vrt",
             "<VRTDataset rasterXSize='4' rasterYSize='4'><SRS>EPSG:32632</SRS>"
             "<GeoTransform>400000,50,0,5300000,0,-50</GeoTransform>"
             "<VRTRasterBand dataType='Float32' band='1'><SimpleSource><SourceFilename>" +
                 inner +
                 "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand>"
                 "</VRTDataset>");
  EXPECT_TRUE(says(refusal({folder_ / "outer.vrt"}), {"outer.vrt", "Python"}));
  EXPECT_EQ(read_text(folder_ / "ran"), "");
}

TEST_F(DemGuards, ScalesThatMakeNoHeightsAreRefused) {
  TestRaster raster;
  for (const double scale : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
    raster.scale = scale;
    const std::string path = raster.write(folder_ / "a.tif");
    EXPECT_TRUE(says(refusal({path}), {path, "scale"}));
  }
}

TEST_F(DemGuards, ProgressRisesToOne) {
  TestRaster raster;
  raster.columns = raster.rows = 1500;
  const std::string path = raster.write(folder_ / "a.tif");
  std::vector<double> shares;
  DemOptions options;
  options.progress = [&](double share) { shares.push_back(share); };
  EXPECT_EQ(read_one(path, options).voids_open, 0U);
  ASSERT_GE(shares.size(), 2U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.front(), 0);
  EXPECT_DOUBLE_EQ(shares.back(), 1);
}

TEST_F(DemGuards, TheCallerMayStopByThrowingFromProgress) {
  const std::string path = TestRaster{}.write(folder_ / "a.tif");
  DemOptions options;
  options.progress = [](double) { throw std::runtime_error("stop"); };
  EXPECT_THROW(static_cast<void>(read_dems({path}, options)), std::runtime_error);
  EXPECT_EQ(refusal({path}), "");
}

TEST(GdalScopeTest, ScopesNest) {
  const std::string before = CPLGetConfigOption("GDAL_VRT_ENABLE_PYTHON", "unset");
  {
    GdalScope outer;
    {
      GdalScope inner;
      CPLError(CE_Failure, CPLE_AppDefined, "inside");
      EXPECT_EQ(inner.take_failure(), "inside");
    }
    EXPECT_STREQ(CPLGetConfigOption("GDAL_VRT_ENABLE_PYTHON", "unset"), "NO");
    CPLError(CE_Failure, CPLE_AppDefined, "outside");
    EXPECT_EQ(outer.take_failure(), "outside");
  }
  EXPECT_EQ(CPLGetConfigOption("GDAL_VRT_ENABLE_PYTHON", "unset"), before);
}

TEST(GdalScopeTest, FailuresAndWarningsBecomeSingleLines) {
  GdalScope scope;
  CPLError(CE_Warning, CPLE_AppDefined, "first\n  second.\n");
  CPLError(CE_Warning, CPLE_AppDefined, "first\n  second.\n");
  CPLError(CE_Failure, CPLE_AppDefined, "broken");
  CPLError(CE_Failure, CPLE_AppDefined, "and more");
  EXPECT_EQ(scope.take_warnings(), std::vector<std::string>{"first second"});
  EXPECT_EQ(scope.take_failure(), "broken");
  EXPECT_EQ(scope.take_failure(), "");
}

}  // namespace
}  // namespace terrview
