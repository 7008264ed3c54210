// Plans land on their DEMs, to the pixel: docs/panoramas.md. GDAL reads them back.
#include <gtest/gtest.h>

#include <cmath>

#include <ogr_spatialref.h>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

struct PlacedPicture {
  int width_px = 0;
  int height_px = 0;
  int bands = 0;
  std::array<double, 6> transform{};
  std::string crs;
  std::vector<std::uint8_t> values;  // band by band

  [[nodiscard]] int at(int band, int column, int row) const {
    return values[static_cast<std::size_t>((band * height_px + row) * width_px + column)];
  }
  // Where a point of the ground lies in the picture.
  [[nodiscard]] glm::dvec2 image_point(glm::dvec2 xy) const {
    std::array<double, 6> forth = transform;
    std::array<double, 6> back{};
    EXPECT_TRUE(GDALInvGeoTransform(forth.data(), back.data()));
    glm::dvec2 point;
    GDALApplyGeoTransform(back.data(), xy.x, xy.y, &point.x, &point.y);
    return point;
  }
};

PlacedPicture read_placed(const std::string& path) {
  GDALAllRegister();
  const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str()));
  if (!file) throw std::runtime_error("no picture in " + path);
  PlacedPicture picture;
  picture.width_px = file->GetRasterXSize();
  picture.height_px = file->GetRasterYSize();
  picture.bands = file->GetRasterCount();
  EXPECT_EQ(file->GetGeoTransform(picture.transform.data()), CE_None);
  if (const OGRSpatialReference* crs = file->GetSpatialRef())
    picture.crs = crs->GetAuthorityCode(nullptr);
  picture.values.resize(
      static_cast<std::size_t>(picture.width_px * picture.height_px * picture.bands));
  EXPECT_EQ(file->RasterIO(GF_Read, 0, 0, picture.width_px, picture.height_px,
                           picture.values.data(), picture.width_px, picture.height_px, GDT_Byte,
                           picture.bands, nullptr, 0, 0, 0, nullptr),
            CE_None);
  return picture;
}

class Plan : public SmallView {
 protected:
  static constexpr int kColumns = 31;
  static constexpr int kRows = 23;
  static constexpr int kSpikeColumn = 19;
  static constexpr int kSpikeRow = 8;

  // Grey ground with one post of red rock.
  void write_spike(const std::array<double, 6>& transform, const std::string& crs) const {
    TestRaster raster;
    raster.columns = kColumns;
    raster.rows = kRows;
    raster.geotransform = transform;
    raster.crs = crs;
    raster.number = [](int column, int row) {
      return column == kSpikeColumn && row == kSpikeRow ? 900.0 : 500.0 + column;
    };
    raster.write(path("spike.tif"));
    write_text(path("red.txt"), "0 120 120 120\n800 120 120 120\n890 250 0 0\n900 250 0 0\n");
  }

  PlacedPicture plan(const std::string& line, const std::string& name = "plan.tif") const {
    const Finished finished = run(words(
        "spike.tif -q --projection plan --colors red.txt --overwrite -o " + name + " " + line));
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return read_placed(path(name));
  }

  // Where the picture is red, as (column, row).
  static std::vector<std::pair<int, int>> red_pixels(const PlacedPicture& picture) {
    std::vector<std::pair<int, int>> found;
    for (int row = 0; row < picture.height_px; ++row)
      for (int column = 0; column < picture.width_px; ++column)
        if (picture.at(0, column, row) > 2 * picture.at(1, column, row))
          found.emplace_back(column, row);
    return found;
  }
};

struct Lie {
  const char* name;
  std::array<double, 6> transform;
  const char* crs;
};

class PlanOfEveryLie : public Plan, public testing::WithParamInterface<Lie> {};

TEST_P(PlanOfEveryLie, PutsTheSpikeIntoItsPixelAlone) {
  const Lie& lie = GetParam();
  write_spike(lie.transform, lie.crs);
  std::array<double, 6> forth = lie.transform;
  glm::dvec2 spike;
  GDALApplyGeoTransform(forth.data(), kSpikeColumn + 0.5, kSpikeRow + 0.5, &spike.x, &spike.y);
  for (const std::string line : {"", "--window 10,3,15,14", "--shade relief --earth flat"}) {
    const PlacedPicture picture = plan(line);
    EXPECT_EQ(picture.crs, std::string(lie.crs).substr(5));
    const auto red = red_pixels(picture);
    ASSERT_EQ(red.size(), 1U) << line;
    const glm::dvec2 middle = picture.image_point(spike);
    EXPECT_NEAR(middle.x, red[0].first + 0.5, 1e-6) << line;
    EXPECT_NEAR(middle.y, red[0].second + 0.5, 1e-6) << line;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Plan, PlanOfEveryLie,
    testing::Values(Lie{"projected", {400000, 50, 0, 5300000, 0, -50}, "EPSG:32632"},
                    Lie{"south_up", {400000, 50, 0, 5300000, 0, 50}, "EPSG:32632"},
                    Lie{"east_west", {400000, -50, 0, 5300000, 0, -50}, "EPSG:32632"},
                    Lie{"rotated", {400000, 43, 25, 5300000, 25, -43}, "EPSG:32632"},
                    Lie{"geographic", {7.1, 0.001, 0, 48.2, 0, -0.0007}, "EPSG:4326"}),
    [](const auto& test) { return test.param.name; });

TEST_F(Plan, HasTheGeotransformOfItsDem) {
  const std::array<double, 6> transform{7.1, 0.001, 0, 48.2, 0, -0.0007};
  write_spike(transform, "EPSG:4326");
  const PlacedPicture picture = plan("");
  EXPECT_EQ(picture.width_px, kColumns);
  EXPECT_EQ(picture.height_px, kRows);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(picture.transform[i], transform[i], 1e-13) << i;
}

TEST_F(Plan, HasPixelsOfTheResolutionAskedForFromTheSameCorner) {
  write_spike({400000, 50, 0, 5300000, 0, -50}, "EPSG:32632");
  const PlacedPicture picture = plan("--resolution 12.5,25");
  EXPECT_EQ(picture.width_px, 4 * kColumns);
  EXPECT_EQ(picture.height_px, 2 * kRows);
  EXPECT_EQ(picture.transform, (std::array<double, 6>{400000, 12.5, 0, 5300000, 0, -25}));
  // Beyond the outermost posts nothing is.
  EXPECT_EQ(picture.bands, 4);
  EXPECT_EQ(picture.at(3, 1, 1), 0);
  EXPECT_EQ(picture.at(3, 2, 1), 255);
}

TEST_F(Plan, LiesInPicturesThatKeepTheirPlaceBesideThem) {
  write_spike({400000, 50, 0, 5300000, 0, -50}, "EPSG:32632");
  const PlacedPicture tif = plan("");
  const PlacedPicture png = plan("", "plan.png");
  EXPECT_EQ(png.transform, tif.transform);
  EXPECT_EQ(png.crs, tif.crs);
  EXPECT_EQ(png.values, tif.values);
  EXPECT_EQ(bytes("plan.pgw"), "50\n0\n0\n-50\n400025\n5299975\n");
  EXPECT_EQ(plan("", "plan.jpg").crs, tif.crs);
  EXPECT_EQ(bytes("plan.jgw"), bytes("plan.pgw"));
  std::filesystem::remove(path("plan.png"));
  expect_refused(run(words("spike.tif -q --projection plan -o plan.png")), {"plan.pgw", "exists"});
}

TEST_F(Plan, NeedsNoEyeAndTakesNoCamera) {
  write_spike({400000, 50, 0, 5300000, 0, -50}, "EPSG:32632");
  EXPECT_EQ(plan("--eye 47.84,7.67,2000").width_px, kColumns);
  for (const std::string option :
       {"--fov 50", "--size 64x48", "--heading 3", "--shift 0,0.1", "--crop 1,1,3,3", "--preview",
        "--layers a.tif", "--palette 16", "--visibility 20", "--camera c.json"})
    expect_refused(run(words("spike.tif --projection plan -o a.tif " + option)),
                   {option.substr(0, option.find(' '))});
  expect_refused(run(words("spike.tif --eye 47.84,7.67,2000 --resolution 30")), {"--resolution"});
  for (const std::string resolution : {"0", "-5", "0.0001", "1,2,3"})
    expect_refused(run(words("spike.tif --projection plan -o a.tif --resolution=" + resolution)),
                   {"--resolution"});
  expect_refused(run(words("spike.tif --projection plan -o a.exr")), {"exr"});
}

}  // namespace
}  // namespace terrview
