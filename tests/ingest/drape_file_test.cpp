// Georeferenced pictures over DEMs: ingest/drape_file.h.
#include "ingest/drape_file.h"

#include <gtest/gtest.h>

#include <GeographicLib/UTMUPS.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>

#include "ingest/view_frame.h"
#include "render/color_ramp.h"
#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

// Different in each pixel and band.
int noise(int column, int row, int band) {
  const auto key = static_cast<std::uint32_t>((band * 1000 + row) * 1000 + column);
  return static_cast<int>(key * 2654435761U >> 24U);
}

glm::vec3 linear_noise(int column, int row) {
  const auto at = [&](int band) { return static_cast<float>(noise(column, row, band)); };
  return from_srgb8(at(1), at(2), at(3));
}

constexpr glm::vec3 kTint{0.1F, 0.2F, 0.3F};

class DrapeFile : public testing::Test {
 protected:
  // A geographic DEM of 2 x 1.6 km at 48 N 7 E.
  [[nodiscard]] std::vector<Dem> geographic_dem() const {
    TestRaster dem;
    dem.columns = 41;
    dem.rows = 33;
    dem.geotransform = {{7, 0.0007, 0, 48, 0, -0.0005}};
    dem.crs = "EPSG:4326";
    return read_dems({dem.write(folder_ / "dem.tif")});
  }

  // A picture of 25 x 20 pixels without a system, over flat_dem().
  [[nodiscard]] static TestRaster flat_picture(int bands) {
    TestRaster picture;
    picture.columns = 25;
    picture.rows = 20;
    picture.bands = bands;
    picture.type = GDT_Byte;
    picture.number = [](int column, int row) { return noise(column, row, 1); };
    picture.geotransform = {{0, 4, 0, 80, 0, -4}};
    picture.crs = "";
    return picture;
  }

  // 11 x 9 posts 10 m apart from (0, 0), without a system.
  [[nodiscard]] std::vector<Dem> flat_dem() const {
    TestRaster dem;
    dem.columns = 11;
    dem.rows = 9;
    dem.geotransform = {{-5, 10, 0, 85, 0, -10}};
    dem.crs = "";
    return read_dems({dem.write(folder_ / "flat.tif")});
  }

  // What the drape shows at a place in grid coordinates.
  [[nodiscard]] static glm::vec3 seen(const Drape& drape, const std::vector<Dem>& dems,
                                      glm::dvec2 uv) {
    EyePlace eye;
    eye.projected = dems[0].placement.at({2, 2});
    eye.height_m = 9000;
    const ViewFrame frame(dems, eye, {});
    Hit hit{};
    hit.uv = uv;
    return drape.over(kTint, *frame.terrain(), {{0, 0, 0}, {0, 0, -1}}, hit, 0, {0, 0, 1});
  }

  // The same of flat_dem() at the middle of a pixel of flat_picture().
  [[nodiscard]] glm::vec3 at_pixel(const std::string& path, int column, int row) const {
    const std::vector<Dem> dems = flat_dem();
    const glm::dvec2 xy(4 * (column + 0.5), 80 - 4 * (row + 0.5));
    return seen(*read_drape(path, dems), dems, dems[0].placement.posts(xy));
  }

  [[nodiscard]] std::string refusal_of(const std::string& path,
                                       std::size_t memory_bytes = 0) const {
    try {
      static_cast<void>(read_drape(path, flat_dem(), memory_bytes));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

void expect_color(const glm::vec3& found, const glm::vec3& expected, float tolerance = 1e-6F) {
  EXPECT_LE(glm::distance(found, expected), tolerance)
      << found.r << ' ' << found.g << ' ' << found.b << " instead of " << expected.r << ' '
      << expected.g << ' ' << expected.b;
}

TEST_F(DrapeFile, PixelsOfAnotherSystemLieWhereTheyAreToAThousandthOfAPixel) {
  const std::vector<Dem> dems = geographic_dem();
  int zone = 0;
  bool north = true;
  double east_m = 0;
  double north_m = 0;
  GeographicLib::UTMUPS::Forward(47.992, 7.0145, zone, north, east_m, north_m);
  ASSERT_EQ(zone, 32);
  // 13 m pixels, turned by a quarter of a radian about the DEM's middle.
  const double c = 13 * std::cos(0.25);
  const double s = 13 * std::sin(0.25);
  TestRaster raster;
  raster.columns = 300;
  raster.rows = 260;
  raster.bands = 3;
  raster.type = GDT_Byte;
  raster.number = [](int column, int row) { return noise(column, row, 1); };
  raster.geotransform = {{east_m - 150 * c - 130 * s, c, s, north_m - 150 * s + 130 * c, s, -c}};
  raster.change = [](GDALDataset& file) {
    for (int band = 2; band <= 3; ++band)
      for (int row = 0; row < 260; ++row)
        for (int column = 0; column < 300; ++column) {
          int value = noise(column, row, band);
          ASSERT_EQ(file.GetRasterBand(band)->RasterIO(GF_Write, column, row, 1, 1, &value, 1, 1,
                                                       GDT_Int32, 0, 0, nullptr),
                    CE_None);
        }
  };
  const auto t = *raster.geotransform;
  const auto drape = read_drape(raster.write(folder_ / "utm.tif"), dems);
  int checked = 0;
  for (int row = 5; row < 260; row += 17) {
    for (int column = 5; column < 300; column += 13) {
      const glm::dvec2 px(column + 0.5, row + 0.5);
      double latitude = 0;
      double longitude = 0;
      GeographicLib::UTMUPS::Reverse(32, true, t[0] + t[1] * px.x + t[2] * px.y,
                                     t[3] + t[4] * px.x + t[5] * px.y, latitude, longitude);
      const glm::dvec2 uv = dems[0].placement.posts({longitude, latitude});
      if (uv.x < 0 || uv.y < 0 || uv.x > 40 || uv.y > 32) continue;
      expect_color(seen(*drape, dems, uv), linear_noise(column, row), 3e-3F);
      ++checked;
    }
  }
  EXPECT_GT(checked, 60);
}

TEST_F(DrapeFile, OfTheSameSystemIsPlacedByItsGeotransformAlone) {
  const std::string path = flat_picture(1).write(folder_ / "grey.tif");
  for (const auto& [column, row] : {std::pair(0, 0), std::pair(7, 3), std::pair(24, 19)}) {
    const auto grey = static_cast<float>(noise(column, row, 1));
    expect_color(at_pixel(path, column, row), from_srgb8(grey, grey, grey));
  }
}

TEST_F(DrapeFile, SixteenBitsAreReadByTheirHighByte) {
  TestRaster picture = flat_picture(1);
  picture.type = GDT_UInt16;
  picture.number = [](int column, int row) { return 257 * noise(column, row, 1); };
  const auto grey = static_cast<float>(noise(3, 4, 1));
  expect_color(at_pixel(picture.write(folder_ / "deep.tif"), 3, 4), from_srgb8(grey, grey, grey));
}

TEST_F(DrapeFile, ColorTablesAreFollowed) {
  TestRaster picture = flat_picture(1);
  picture.number = [](int column, int) { return column % 2; };
  picture.change = [](GDALDataset& file) {
    GDALColorTable table;
    const GDALColorEntry first{10, 20, 30, 255};
    const GDALColorEntry second{200, 100, 0, 255};
    table.SetColorEntry(0, &first);
    table.SetColorEntry(1, &second);
    file.GetRasterBand(1)->SetColorTable(&table);
  };
  const std::string path = picture.write(folder_ / "table.tif");
  expect_color(at_pixel(path, 4, 4), from_srgb8(10, 20, 30));
  expect_color(at_pixel(path, 5, 4), from_srgb8(200, 100, 0));
}

TEST_F(DrapeFile, TheTintsShowThroughItsHoles) {
  TestRaster nodata = flat_picture(1);
  nodata.number = [](int column, int) { return column < 10 ? 7 : 90; };
  nodata.nodata = 7;
  const std::string path = nodata.write(folder_ / "nodata.tif");
  expect_color(at_pixel(path, 5, 5), kTint);
  expect_color(at_pixel(path, 15, 5), from_srgb8(90, 90, 90));

  TestRaster alpha = flat_picture(4);
  alpha.number = [](int, int) { return 90; };
  alpha.change = [](GDALDataset& file) {
    for (const int band : {1, 2, 3}) ASSERT_EQ(file.GetRasterBand(band)->Fill(90), CE_None);
    GDALRasterBand* last = file.GetRasterBand(4);
    last->SetColorInterpretation(GCI_AlphaBand);
    ASSERT_EQ(last->Fill(0), CE_None);
    std::uint8_t opaque = 255;
    ASSERT_EQ(last->RasterIO(GF_Write, 15, 5, 1, 1, &opaque, 1, 1, GDT_Byte, 0, 0, nullptr),
              CE_None);
  };
  const std::string transparent = alpha.write(folder_ / "alpha.tif");
  expect_color(at_pixel(transparent, 5, 5), kTint);
  expect_color(at_pixel(transparent, 15, 5), from_srgb8(90, 90, 90));
}

TEST_F(DrapeFile, ATurnOfLongitudeIsTheSamePlace) {
  const std::vector<Dem> dems = geographic_dem();
  TestRaster picture = flat_picture(1);
  picture.geotransform = {{367, 0.001, 0, 48, 0, -0.001}};
  picture.crs = "EPSG:4326";
  const auto grey = static_cast<float>(noise(3, 4, 1));
  expect_color(seen(*read_drape(picture.write(folder_ / "turned.tif"), dems), dems,
                    dems[0].placement.posts({7.0035, 47.9955})),
               from_srgb8(grey, grey, grey), 1e-4F);
}

TEST_F(DrapeFile, WhatCannotBeLaidOverTheGroundIsRefused) {
  TestRaster picture = flat_picture(1);
  picture.geotransform.reset();
  EXPECT_TRUE(says(refusal_of(picture.write(folder_ / "placeless.tif")),
                   {"--drape", "says not where it lies", "gdal_translate"}));
  picture.geotransform = {{1000, 4, 0, 80, 0, -4}};
  EXPECT_TRUE(says(refusal_of(picture.write(folder_ / "beside.tif")),
                   {"--drape", "does not lie on the ground"}));
  picture.crs = "EPSG:32632";
  EXPECT_TRUE(
      says(refusal_of(picture.write(folder_ / "system.tif")), {"--drape", "has none", "--a-srs"}));
  EXPECT_TRUE(says(refusal_of(flat_picture(1).write(folder_ / "large.tif"), 1000),
                   {"--drape", "MiB", "--memory"}));
  picture = flat_picture(1);
  picture.type = GDT_Float32;
  EXPECT_TRUE(says(refusal_of(picture.write(folder_ / "float.tif")), {"Float32", "8 or 16 bits"}));
}

// How much of the picture's brightness the two slopes of the ground explain, the picture moved by
// some pixels: what faces the sun is bright, wherever that stood.
double explained(const Drape& drape, const std::vector<Dem>& dems, glm::dvec2 uv_shift) {
  EyePlace eye;
  eye.projected = dems[0].placement.at({70, 90});
  eye.height_m = 9000;
  const ViewFrame frame(dems, eye, {});
  const HeightGrid& grid = *dems[0].grid;
  double n = 0, su = 0, sv = 0, sg = 0, suu = 0, suv = 0, svv = 0, sug = 0, svg = 0, sgg = 0;
  for (int row = 6; row < grid.rows - 6; ++row) {
    for (int column = 6; column < grid.columns - 6; ++column) {
      Hit hit{};
      hit.uv = glm::dvec2(column, row) + uv_shift;
      const glm::vec3 color =
          drape.over(kTint, *frame.terrain(), {{0, 0, 0}, {0, 0, -1}}, hit, 0, {0, 0, 1});
      const double g = to_srgb(color.g);
      const double u = grid.at(column + 1, row) - grid.at(column - 1, row);
      const double v = grid.at(column, row + 1) - grid.at(column, row - 1);
      n += 1, su += u, sv += v, sg += g;
      suu += u * u, suv += u * v, svv += v * v, sug += u * g, svg += v * g, sgg += g * g;
    }
  }
  const double uu = suu - su * su / n, uv = suv - su * sv / n, vv = svv - sv * sv / n;
  const double ug = sug - su * sg / n, vg = svg - sv * sg / n, gg = sgg - sg * sg / n;
  return (ug * ug * vv - 2 * ug * vg * uv + vg * vg * uu) / ((uu * vv - uv * uv) * gg);
}

TEST_F(DrapeFile, AMountainsPictureLiesOnItsValleysAndNotTwoPixelsBeside) {
  NEEDS_SHARED_DATA();
  const std::string dem = shared_data("rmnp/rmnp-dem.tif");
  const std::vector<Dem> dems = read_dems({dem});
  const auto drape = read_drape(shared_data("rmnp/rmnp-rgb.tif"), dems);
  const glm::dvec2 pixel_uv(0.0015 / 0.00275, 0.0015 / 0.00211);
  const double here = explained(*drape, dems, {0, 0});
  RecordProperty("explained", std::to_string(here));
  EXPECT_GT(here, 0.1);
  for (int x = -2; x <= 2; x += 2)
    for (int y = -2; y <= 2; y += 2) {
      if (x == 0 && y == 0) continue;
      EXPECT_LT(explained(*drape, dems, glm::dvec2(x, y) * pixel_uv), here) << x << ' ' << y;
    }
}

}  // namespace
}  // namespace terrview
