// --drape: docs/cli.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/cli/small_picture.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class DrapeOfView : public SmallView {
 protected:
  // Blue in the west, red in the east of 7 E, over the hills; in Web Mercator.
  DrapeOfView() {
    TestRaster raster;
    raster.columns = 400;
    raster.rows = 60;
    raster.bands = 3;
    raster.type = GDT_Byte;
    raster.number = [](int, int) { return 0; };
    raster.change = [](GDALDataset& file) {
      std::vector<std::uint8_t> row(400, 0);
      std::fill(row.begin(), row.begin() + 200, 220);
      for (const int band : {3, 2, 1}) {
        for (int line = 0; line < 60; ++line)
          ASSERT_EQ(file.GetRasterBand(band)->RasterIO(GF_Write, 0, line, 400, 1, row.data(), 400,
                                                       1, GDT_Byte, 0, 0, nullptr),
                    CE_None);
        if (band == 3) std::fill(row.begin(), row.end(), 10);
        if (band == 2) std::fill(row.begin() + 200, row.end(), 220);
      }
    };
    raster.geotransform = {{779236.435552915 - 200 * 20, 20, 0, 6106855 + 3000, 0, -100}};
    raster.crs = "EPSG:3857";
    raster.write(path("halves.tif"));
  }

  void view_down(const std::string& options) const {
    view(
        "--eye 48,7,9000 --heading 0 --pitch -90 --fov 12 --size 64x48 --visibility inf "
        "--no-shadows --samples 1 --overwrite " +
        options);
  }

  [[nodiscard]] nlohmann::json said_in(const std::string& name) const {
    const GDALDatasetUniquePtr picture(GDALDataset::Open(path(name).c_str()));
    const char* text = picture ? picture->GetMetadataItem("terrview_view") : nullptr;
    return text ? nlohmann::json::parse(text) : nlohmann::json();
  }
};

TEST_F(DrapeOfView, ColorsTheGroundWhereItLies) {
  view_down("--drape halves.tif -o seen.png");
  const ReadPicture seen = read_picture(path("seen.png"));
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column) {
      if (column == 31 || column == 32) continue;
      const glm::ivec4 color = seen.colors[static_cast<std::size_t>(row * 64 + column)];
      EXPECT_EQ(color.b > color.r, column < 32) << column << ' ' << row;
    }
  EXPECT_EQ(said_in("seen.png").at("drape"), "halves.tif");
}

TEST_F(DrapeOfView, IsTheSameForAnyNumberOfThreads) {
  view_down("--drape halves.tif --threads 1 -o one.png");
  view_down("--drape halves.tif --threads 3 -o three.png");
  EXPECT_EQ(bytes("one.png"), bytes("three.png"));
}

TEST_F(DrapeOfView, LiesOverTheTintsOfAnyRamp) {
  view_down("--colors polar -o polar.ppm");
  view_down("--colors arid -o arid.ppm");
  EXPECT_NE(bytes("polar.ppm"), bytes("arid.ppm"));
  view_down("--colors polar --drape halves.tif -o over_polar.ppm");
  view_down("--colors arid --drape halves.tif -o over_arid.ppm");
  EXPECT_EQ(bytes("over_polar.ppm"), bytes("over_arid.ppm"));
}

TEST_F(DrapeOfView, HasContourLinesAsManyMetresApartAsAreAskedFor) {
  view_down("--drape halves.tif -o plain.png");
  view_down("--drape halves.tif --contours 50 -o lines.png");
  EXPECT_NE(read_picture(path("plain.png")).colors, read_picture(path("lines.png")).colors);
  EXPECT_EQ(said_in("lines.png").at("contours"), 50);
  for (const std::string wrong : {"0", "-10", "1e9", "ten"})
    expect_refused(run(words("hills.tif --eye 48,7,9000 -o a.png --contours " + wrong)),
                   {"--contours"});
}

TEST_F(DrapeOfView, GoesAroundTheEarthWithItsDem) {
  TestRaster globe;
  globe.columns = 3600;
  globe.rows = 60;
  globe.number = [](int /*column*/, int row) { return 500 + 100 * ((row % 3)); };
  globe.geotransform = {{-180, 0.1, 0, 3, 0, -0.1}};
  globe.crs = "EPSG:4326";
  globe.write(path("globe.tif"));
  globe.type = GDT_Byte;
  globe.number = [](int, int) { return 90; };
  globe.write(path("grey.tif"));
  const auto picture = [&](const std::string& longitude, const std::string& name) {
    ASSERT_EQ(run(words("globe.tif -q --eye 0," + longitude +
                        ",9000 --heading 90 --pitch -20 --size 40x30 --no-sky --visibility inf "
                        "--drape grey.tif -o " +
                        name))
                  .exit_code,
              0);
  };
  picture("179.75", "seam.png");
  picture("-0.25", "middle.png");
  const ReadPicture seam = read_picture(path("seam.png"));
  const ReadPicture middle = read_picture(path("middle.png"));
  // Between the last column and the first there is no ground.
  int same = 0;
  for (std::size_t i = 0; i < seam.colors.size(); ++i)
    same += seam.colors[i] == middle.colors[i] ? 1 : 0;
  EXPECT_GT(same, 900);
}

TEST_F(DrapeOfView, ThatTheViewReadsIsNeverWritten) {
  const std::string before = bytes("halves.tif");
  expect_refused(
      run(words("hills.tif --eye 48,7,9000 --drape halves.tif -o halves.tif --overwrite")),
      {"halves.tif", "is read by this view"});
  EXPECT_EQ(bytes("halves.tif"), before);
}

TEST_F(DrapeOfView, ThatIsNoPictureIsRefused) {
  expect_refused(run(words("hills.tif -q --eye 48,7,9000 --drape hills.tif -o a.png")),
                 {"hills.tif", "Float32", "8 or 16 bits"});
  expect_refused(run(words("hills.tif -q --eye 48,7,9000 --drape none.tif -o a.png")),
                 {"none.tif", "cannot be opened"});
}

}  // namespace
}  // namespace terrview
