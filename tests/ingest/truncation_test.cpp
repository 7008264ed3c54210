// Every reader faces every truncation: a file cut short anywhere is read or refused in one line.
#include <gtest/gtest.h>

#include <string>

#include "ingest/color_ramp_file.h"
#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

class Truncation : public testing::Test {
 protected:
  // How many truncations of `whole` were refused.
  std::size_t refused_truncations(const std::string& whole, const std::string& name) {
    std::size_t refused = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
      write_text(folder_ / name, whole.substr(0, length));
      if (!refusal({folder_ / name}).empty()) ++refused;
    }
    return refused;
  }

  TemporaryFolder folder_;
};

TEST_F(Truncation, OfAGeoTiffIsRefused) {
  const std::string whole = read_text(TestRaster{}.write(folder_ / "a.tif"));
  // GDAL puts the numbers last: each of them is missed.
  EXPECT_EQ(refused_truncations(whole, "cut.tif"), whole.size());
}

TEST_F(Truncation, OfACompressedTiledGeoTiffIsReadOrRefused) {
  TestRaster raster;
  raster.type = GDT_Int16;
  raster.nodata = -1;
  raster.creation_options = {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16", "COMPRESS=DEFLATE"};
  const std::string whole = read_text(raster.write(folder_ / "a.tif"));
  EXPECT_GT(refused_truncations(whole, "cut.tif"), whole.size() / 2);
}

TEST_F(Truncation, OfAnAsciiGridIsReadOrRefused) {
  const std::string whole =
      "ncols 4\nnrows 3\nxllcorner 400000\nyllcorner 5300000\ncellsize 50\nNODATA_value -9999\n"
      "101.5 102 103 104\n105 106 -9999 108\n109 110 111 112\n";
  // The last number may lose digits unnoticed.
  EXPECT_GE(refused_truncations(whole, "cut.asc"), whole.size() - 4);
  write_text(folder_ / "whole.asc", whole);
  EXPECT_EQ(refusal({folder_ / "whole.asc"}), "");
}

TEST_F(Truncation, OfAColourTableIsReadOrRefused) {
  for (const std::string whole :
       {"# heights\n-20.5 0 0 255\n0% red\n50%,10,20,30,255\nnv 0 0 0 0\n1e3:white\n",
        "# QGIS Generated Color Map Export File\nINTERPOLATION:DISCRETE\n"
        "500,0,97,71,255,low ground\ninf,255,255,255,255,high\n"}) {
    std::size_t refused = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
      try {
        const ColorRamp ramp =
            parse_color_ramp(whole.substr(0, length), "ramp.txt", {0, 100, false});
        EXPECT_FALSE(ramp.stops.empty());
      } catch (const InputError&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, 10U);
    EXPECT_LT(refused, whole.size());
  }
}

}  // namespace
}  // namespace terrview
