// `terrview synth`, as a user runs it.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sky/field_part.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class Synth : public SmallView {
 protected:
  struct Grid {
    int columns = 0;
    int rows = 0;
    std::vector<float> heights_m;
    std::array<double, 6> transform{};
    std::string crs;

    [[nodiscard]] float at(int column, int row) const {
      return heights_m[static_cast<std::size_t>(row * columns + column)];
    }
    [[nodiscard]] double mean() const {
      double sum = 0;
      for (const float h : heights_m) sum += static_cast<double>(h);
      return sum / static_cast<double>(heights_m.size());
    }
    [[nodiscard]] double deviation() const {
      double sum = 0;
      const double middle = mean();
      for (const float h : heights_m) sum += std::pow(static_cast<double>(h) - middle, 2);
      return std::sqrt(sum / static_cast<double>(heights_m.size()));
    }
  };

  Grid synth(const std::string& line) const {
    const Finished done = run(words("synth -q --overwrite -o grid.tif " + line));
    EXPECT_EQ(done.exit_code, 0) << done.err;
    GDALAllRegister();
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("grid.tif").c_str()));
    Grid grid;
    grid.columns = file->GetRasterXSize();
    grid.rows = file->GetRasterYSize();
    grid.heights_m.resize(static_cast<std::size_t>(grid.columns) *
                          static_cast<std::size_t>(grid.rows));
    EXPECT_EQ(file->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, grid.columns, grid.rows,
                                               grid.heights_m.data(), grid.columns, grid.rows,
                                               GDT_Float32, 0, 0, nullptr),
              CE_None);
    file->GetGeoTransform(grid.transform.data());
    const OGRSpatialReference* crs = file->GetSpatialRef();
    const char* code = crs != nullptr ? crs->GetAuthorityCode(nullptr) : nullptr;
    if (code != nullptr) grid.crs = code;
    return grid;
  }
};

TEST_F(Synth, WritesTheField) {
  const Grid grid =
      synth("--size 30x20 --levels 3:5 --seed 9 --field midpoint --h 0.4 --height 100 --base 500");
  FieldOptions options;
  options.seed = 9;
  options.levels = {3, 5};
  options.h = {0.4};
  const RandomField field(options);
  const auto values = field_part(field, {0, 0, 30, 20});
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 30; ++column)
      ASSERT_NEAR(
          static_cast<double>(grid.at(column, 19 - row)),
          500 + 100 / field.expected_deviation() *
                    static_cast<double>(values[static_cast<std::size_t>(row * 30 + column)]),
          1e-3);
}

TEST_F(Synth, NeighboursShareTheirBorder) {
  for (const char* relief : {"plain", "ridged"}) {
    const std::string line = std::string("--levels 4 --relief ") + relief;
    const Grid west = synth(line + " --size 65x33");
    const Grid east = synth(line + " --size 50x33 --first 64,0");
    const Grid north = synth(line + " --size 65x20 --first 0,32");
    for (int row = 0; row < 33; ++row) EXPECT_EQ(west.at(64, row), east.at(0, row));
    for (int column = 0; column < 65; ++column) EXPECT_EQ(west.at(column, 0), north.at(column, 19));
  }
}

TEST_F(Synth, PutsPostsWhereItIsTold) {
  const Grid grid =
      synth("--size 11x6 --spacing 60,90 --south-west 400000,5300000 --a-srs EPSG:32632");
  const std::array<double, 6> expected{399970, 60, 0, 5300000 + 5 * 90 + 45, 0, -90};
  EXPECT_EQ(grid.transform, expected);
  EXPECT_EQ(grid.crs, "32632");
}

TEST_F(Synth, EveryReliefHasTheDeviationAskedFor) {
  for (const char* relief : {"plain", "ridged"}) {
    const Grid grid = synth(std::string("--levels 3 --size 600x600 --height 200 --base 1000 "
                                        "--relief ") +
                            relief);
    EXPECT_NEAR(grid.mean(), 1000, 15) << relief;
    EXPECT_NEAR(grid.deviation(), 200, 15) << relief;
  }
}

TEST_F(Synth, RidgesAreSharpAndRiversRunDown) {
  const auto sharpest = [](const Grid& grid, float sign) {
    float most = 0;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 1; column + 1 < grid.columns; ++column)
        most = std::max(most, sign * (2 * grid.at(column, row) - grid.at(column - 1, row) -
                                      grid.at(column + 1, row)));
    return most;
  };
  const Grid ridged = synth("--levels 6 --h 1.2 --size 129x129 --relief ridged");
  EXPECT_GT(sharpest(ridged, 1), 2 * sharpest(ridged, -1));
  // A hollow is lower than all around it: rivers leave few.
  const auto hollows = [](const Grid& grid) {
    int count = 0;
    for (int row = 1; row + 1 < grid.rows; ++row) {
      for (int column = 1; column + 1 < grid.columns; ++column) {
        bool lowest = true;
        for (int j = -1; j <= 1; ++j)
          for (int i = -1; i <= 1; ++i)
            lowest = lowest && (grid.at(column + i, row + j) >= grid.at(column, row));
        count += lowest ? 1 : 0;
      }
    }
    return count;
  };
  const int before = hollows(synth("--levels 5 --size 129x129"));
  const int after = hollows(synth("--levels 5 --size 129x129 --relief eroded"));
  EXPECT_GT(before, 10);
  EXPECT_LT(after, before / 2);
}

TEST_F(Synth, WritesTheSameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(run(words("synth --size 200x300 -q -o a.tif --threads 1")).exit_code, 0);
  ASSERT_EQ(run(words("synth --size 200x300 -q -o b.tif --threads 4")).exit_code, 0);
  EXPECT_TRUE(bytes("a.tif") == bytes("b.tif"));
}

TEST_F(Synth, ViewsShowWhatItMakes) {
  static_cast<void>(synth("--size 129x129"));
  EXPECT_EQ(run(words("grid.tif --eye-xy 2000,200,+300 --size 40x30 -q -o v.png")).exit_code, 0);
}

TEST_F(Synth, IsWrittenAsToldWithTheSameHeights) {
  const Grid usual = synth("--size 200x100");
  const std::string deflated = bytes("grid.tif");
  for (const char* choice : {"--co COMPRESS=NONE", "--co compress=lzw --co TILED=NO"}) {
    EXPECT_EQ(synth(std::string("--size 200x100 ") + choice).heights_m, usual.heights_m) << choice;
    EXPECT_GT(bytes("grid.tif").size(), deflated.size()) << choice;
  }
  ASSERT_EQ(run(words("synth --size 200x100 -q --of GTiff -o grid.dem")).exit_code, 0);
  EXPECT_TRUE(bytes("grid.dem") == deflated);
}

TEST_F(Synth, SaysInTheFileAllThatMakesIt) {
  static_cast<void>(
      synth("--size 9x8 --seed 7 --first -3,4 --relief ridged --height 50 --base 10"));
  const GDALDatasetUniquePtr file(GDALDataset::Open(path("grid.tif").c_str()));
  const nlohmann::json said =
      nlohmann::json::parse(file->GetMetadataItem("TIFFTAG_IMAGEDESCRIPTION"));
  EXPECT_EQ(said.at("field").at("seed"), 7);
  EXPECT_EQ(said.at("field").at("levels"), nlohmann::json({8, 8}));
  EXPECT_EQ(said.at("first"), nlohmann::json({-3, 4}));
  EXPECT_EQ(said.at("relief"), "ridged");
  EXPECT_EQ(said.at("height_m"), 50);
  EXPECT_EQ(said.at("base_m"), 10);
}

TEST_F(Synth, ShowsItsProgressWhereAsked) {
  const std::string line = "synth --size 90x90 --relief eroded -o ";
  EXPECT_TRUE(says(run(words(line + "a.tif --progress")).err, {"eroding [#", " %", "wrote a.tif"}));
  EXPECT_EQ(run(words(line + "b.tif")).err, "wrote b.tif\n");
}

TEST_F(Synth, RefusesInOneLine) {
  expect_refused(run(words("synth --of PNG")), {"PNG", "GTiff"});
  expect_refused(run(words("synth --co TFW=YES")), {"TFW=YES", "COMPRESS"});
  expect_refused(run(words("synth --co COMPRESS=ROCK")), {"COMPRESS=ROCK", "DEFLATE"});
  expect_refused(run(words("synth --co COMPRESS=JPEG")), {"COMPRESS=JPEG", "DEFLATE"});
  expect_refused(run(words("synth --co TILED=PERHAPS")), {"--co", "PERHAPS"});
  expect_refused(run(words("synth --co BLOCKXSIZE=17")), {"--co", "another value"});
  expect_refused(run(words("synth --size 1x5")), {"--size"});
  expect_refused(run(words("synth -o grid.asc")), {"grid.asc", ".tif"});
  expect_refused(run(words("synth --a-srs EPSG:1")), {"--a-srs EPSG:1"});
  expect_refused(run(words("synth --first 0.5,1")), {"--first 0.5,1"});
  expect_refused(run(words("synth --spacing 0")), {"--spacing 0"});
  expect_refused(run(words("synth --relief lunar")), {"--relief"});
}

}  // namespace
}  // namespace terrview
