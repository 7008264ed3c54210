// --layers and --stats against hand calculation: docs/cli.md.
#include <cmath>
#include <numbers>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

using Json = nlohmann::json;

constexpr double kRadians = std::numbers::pi / 180;

class LayersOfView : public SmallView {};

TEST_F(LayersOfView, AreFloat64BandsWithNamesAndNanForNothing) {
  view("-o a.png --layers a.tif --camera c.json");
  const GDALDatasetUniquePtr file(GDALDataset::Open(path("a.tif").c_str()));
  ASSERT_TRUE(file);
  const std::vector<std::string> names{"distance_m", "latitude", "longitude", "height_m",
                                       "object_id"};
  ASSERT_EQ(file->GetRasterCount(), 5);
  for (int i = 0; i < 5; ++i) {
    GDALRasterBand* band = file->GetRasterBand(i + 1);
    EXPECT_EQ(band->GetDescription(), names[static_cast<std::size_t>(i)]);
    EXPECT_EQ(band->GetRasterDataType(), GDT_Float64);
    EXPECT_TRUE(std::isnan(band->GetNoDataValue()));
  }
  EXPECT_EQ(file->GetRasterXSize(), 64);
  EXPECT_EQ(file->GetRasterYSize(), 48);
  EXPECT_EQ(Json::parse(file->GetMetadataItem("TERRVIEW_CAMERA")), json("c.json"));
}

// plain.asc reaches from (0, 0) to (790, 590) at 300 m.
TEST_F(LayersOfView, OfAPlainAreThoseOfPaperAndPencil) {
  ASSERT_EQ(run(words("plain.asc -q --eye-xy 390,50,340 --heading 0 --pitch -5 --fov 50 "
                      "--size 64x48 -o a.png --layers a.tif"))
                .exit_code,
            0);
  const Layers found = layers("a.tif");
  EXPECT_EQ(found.names,
            (std::vector<std::string>{"distance_m", "x", "y", "height_m", "object_id"}));
  const double k = std::tan(25 * kRadians) / 32;
  int hits = 0;
  for (int row = 0; row < 48; ++row) {
    for (int column = 0; column < 64; ++column) {
      const double right = (column + 0.5 - 32) * k;
      const double rise = (24 - row - 0.5) * k;
      const double north = std::cos(5 * kRadians) + rise * std::sin(5 * kRadians);
      const double up = -std::sin(5 * kRadians) + rise * std::cos(5 * kRadians);
      const double reach = -40 / up;
      const double x = 390 + reach * right;
      const double y = 50 + reach * north;
      const bool hit = up < 0 && x >= 0 && x <= 790 && y <= 590;
      ASSERT_EQ(std::isnan(found.at("distance_m", column, row)), !hit) << column << ' ' << row;
      ASSERT_EQ(std::isnan(found.at("object_id", column, row)), !hit);
      if (!hit) continue;
      ++hits;
      ASSERT_NEAR(found.at("distance_m", column, row), reach * std::hypot(right, north, up), 1e-6);
      ASSERT_NEAR(found.at("x", column, row), x, 1e-6);
      ASSERT_NEAR(found.at("y", column, row), y, 1e-6);
      ASSERT_NEAR(found.at("height_m", column, row), 300, 1e-6);
      ASSERT_EQ(found.at("object_id", column, row), 0);
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_LT(hits, 2500);
}

// Ground that rises 1000 m per degree of longitude: a plane of the grid, under every surface model.
class LayersOfASlope : public LayersOfView {
 protected:
  LayersOfASlope() {
    TestRaster slope;
    slope.columns = 61;
    slope.rows = 51;
    slope.number = [](int column, int) { return 500.0 + column; };
    slope.geotransform = {{7 - 0.0005, 0.001, 0, 48.0255, 0, -0.001}};
    slope.crs = "EPSG:4326";
    slope.write(path("slope.tif"));
  }

  void expect_heights_of_the_slope(const std::string& line) const {
    SCOPED_TRACE(line);
    ASSERT_EQ(run(words("slope.tif -q --size 64x48 --eye 48,7.03,2000 --pitch -60 --overwrite "
                        "-o a.png --layers a.tif " +
                        line))
                  .exit_code,
              0);
    const Layers found = layers("a.tif");
    int hits = 0;
    for (int row = 0; row < 48; ++row) {
      for (int column = 0; column < 64; ++column) {
        if (std::isnan(found.at("distance_m", column, row))) continue;
        ++hits;
        const double longitude = found.at("longitude", column, row);
        // A ray's track stays within 0.02 of a cell, which rises by 1 m.
        ASSERT_NEAR(found.at("height_m", column, row), 500 + (longitude - 7) * 1000, 0.02);
        ASSERT_GT(found.at("latitude", column, row), 47.975 - 1e-9);
        ASSERT_LT(found.at("latitude", column, row), 48.025 + 1e-9);
      }
    }
    EXPECT_GT(hits, 1000);
  }
};

TEST_F(LayersOfASlope, HaveTheDemsHeightAtTheirPlace) {
  for (const char* line : {"--surface hyperboloid", "--surface band", "--surface triangles",
                           "--surface bilinear", "--earth flat", "--refraction 0.5"})
    expect_heights_of_the_slope(line);
}

TEST_F(LayersOfASlope, HaveHeightsThatAreNotExaggerated) {
  expect_heights_of_the_slope("--z-scale 2.5");
}

TEST_F(LayersOfView, HaveDistancesOfTheExaggeratedScene) {
  const std::string line = "plain.asc -q --size 5x5 --pitch -90 -o ";
  // 340 x 2 - 300 x 2 = 80 m above the ground; +40 stays 40 m.
  ASSERT_EQ(run(words(line + "a.png --eye-xy 400,300,340 --z-scale 2 --layers a.tif")).exit_code,
            0);
  EXPECT_NEAR(layers("a.tif").at("distance_m", 2, 2), 80, 1e-9);
  ASSERT_EQ(run(words(line + "b.png --eye-xy 400,300,+40 --z-scale 2 --layers b.tif")).exit_code,
            0);
  EXPECT_NEAR(layers("b.tif").at("distance_m", 2, 2), 40, 1e-9);
}

TEST_F(LayersOfView, DependOnNothingThatOnlyChangesThePicture) {
  write_text(path("map.txt"), "0 0 0 0\n2000 255 255 255\n");
  view("-o a.png --layers a.tif");
  for (const std::string line : {"-o b.jpg", "-o b.png --sun 10,5", "-o b.png --no-shadows",
                                 "-o b.png --normals facet", "-o b.png --colors map.txt"}) {
    view(line + " --overwrite --layers b.tif");
    EXPECT_TRUE(bytes("a.tif") == bytes("b.tif")) << line;
  }
}

TEST_F(LayersOfView, MayBeNamedInAnyCase) {
  view("-o a.png --layers a.TIF");
  view("-o b.png --layers b.tiff");
  EXPECT_TRUE(bytes("a.TIF") == bytes("b.tiff"));
}

TEST_F(LayersOfView, AreNothingWhereThereIsNothing) {
  ASSERT_EQ(run(words("plain.asc -q --eye-xy -500,300,400 --heading 270 --pitch -20 --size 16x12 "
                      "-o a.png --layers a.tif --stats s.json"))
                .exit_code,
            0);
  const Layers found = layers("a.tif");
  for (const auto& band : found.bands)
    for (const double value : band) ASSERT_TRUE(std::isnan(value));
  EXPECT_EQ(json("s.json").at("hits"), 0);
}

TEST_F(LayersOfView, GoWithStatisticsOfTheSameRays) {
  view("--samples 1 -o a.png --layers a.tif --stats s.json");
  const Json stats = json("s.json");
  std::int64_t hits = 0;
  const Layers found = layers("a.tif");
  for (const double distance_m : found.bands[0]) hits += std::isnan(distance_m) ? 0 : 1;
  EXPECT_GT(hits, 100);
  EXPECT_EQ(stats.at("hits"), hits);
  EXPECT_EQ(stats.at("rays"), 64 * 48);
}

TEST_F(LayersOfView, GoWithStatisticsOfEveryPromisedField) {
  view("--eye 47.985,6.99,+300 -o a.png --stats s.json --refraction 0.2");
  const Json stats = json("s.json");
  for (const char* field : {"tests_per_ray", "nodes_per_ray", "peak_memory_mib"})
    EXPECT_GE(stats.at(field).get<double>(), 0) << field;
  EXPECT_GT(stats.at("tests_per_ray").get<double>(), 0);
  EXPECT_GT(stats.at("peak_memory_mib").get<double>(), 1);
  for (const char* stage : {"read", "build", "trace", "shade", "write"}) {
    EXPECT_GE(stats.at("seconds").at(stage).get<double>(), 0) << stage;
    EXPECT_LT(stats.at("seconds").at(stage).get<double>(), 60) << stage;
  }
  const Json& eye = stats.at("eye");
  EXPECT_EQ(eye.at("latitude"), 47.985);
  EXPECT_EQ(eye.at("longitude"), 6.99);
  EXPECT_NEAR(eye.at("height_m").get<double>() - eye.at("ground_m").get<double>(), 300, 1e-9);
  EXPECT_DOUBLE_EQ(stats.at("refraction_multiplier").get<double>(), 0.8);
  EXPECT_GE(stats.at("errors").at("track_cells").get<double>(), 0);
  EXPECT_LE(stats.at("errors").at("track_cells").get<double>(), 0.02);
  EXPECT_GE(stats.at("errors").at("pixel").get<double>(), 0);
  EXPECT_LT(stats.at("errors").at("pixel").get<double>(), 0.1);
  EXPECT_EQ(stats.at("voids"), Json({{"filled", 0}, {"open", 0}}));
}

TEST_F(LayersOfView, GoWithStatisticsThatCountVoids) {
  TestRaster holed;
  holed.columns = 9;
  holed.rows = 9;
  holed.nodata = -1;
  holed.number = [](int column, int row) { return column == 4 && row >= 3 && row < 6 ? -1 : 200; };
  holed.write(path("holed.tif"));
  const auto voids = [&](const std::string& choice) {
    EXPECT_EQ(run(words("holed.tif -q --eye-xy 400100,5299900,+90 --size 8x8 --overwrite -o a.png "
                        "--stats s.json --voids " +
                        choice))
                  .exit_code,
              0);
    return json("s.json").at("voids");
  };
  EXPECT_EQ(voids("fill"), Json({{"filled", 3}, {"open", 0}}));
  EXPECT_EQ(voids("open"), Json({{"filled", 0}, {"open", 3}}));
}

}  // namespace
}  // namespace terrview
