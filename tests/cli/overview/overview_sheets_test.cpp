// Maps cut into sheets: docs/overview.md.
#include "cli/overview_sheets.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <set>

#include <glm/common.hpp>

#include "terrain/error.h"
#include "tests/cli/small_picture.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class Sheets : public SmallView {
 protected:
  static constexpr const char* kMap =
      "overview hills.tif -q --plan --resolution 0.0003 --contours 20 --sun 250,12 -o whole.tif";
  static constexpr const char* kSheets =
      "overview hills.tif -q --resolution 0.0003 --contours 20 --sun 250,12";

  [[nodiscard]] glm::dvec2 north_west(const std::string& name) const {
    const GDALDatasetUniquePtr file(GDALDataset::Open(path(name).c_str()));
    std::array<double, 6> transform{};
    EXPECT_EQ(file->GetGeoTransform(transform.data()), CE_None) << name;
    return {transform[0], transform[3]};
  }

  // Every pixel of the whole is in one of the sheets, and the same there.
  void expect_mosaic(const std::vector<std::string>& names) const {
    const ReadPicture whole = read_picture(path("whole.tif"));
    std::vector<int> shown(whole.colors.size(), 0);
    for (const std::string& name : names) {
      const ReadPicture sheet = read_picture(path(name));
      const glm::dvec2 from_corner = north_west(name) - north_west("whole.tif");
      const glm::ivec2 first(glm::round(from_corner / glm::dvec2(0.0003, -0.0003)));
      for (int row = 0; row < sheet.height_px; ++row) {
        for (int column = 0; column < sheet.width_px; ++column) {
          const auto from = static_cast<std::size_t>(row * sheet.width_px + column);
          const auto to =
              static_cast<std::size_t>((row + first.y) * whole.width_px + column + first.x);
          ++shown[to];
          ASSERT_EQ(sheet.colors[from], whole.colors[to]) << name;
        }
      }
    }
    EXPECT_EQ(std::set<int>(shown.begin(), shown.end()), std::set<int>{1});
  }
};

TEST_F(Sheets, AreTheWholeMapToTheByte) {
  ASSERT_EQ(run(words(kMap)).exit_code, 0);
  const ReadPicture whole = read_picture(path("whole.tif"));
  ASSERT_EQ(glm::ivec2(whole.width_px, whole.height_px), glm::ivec2(137, 137));
  const Finished tiles = run(words(std::string(kSheets) + " --tiles 3x2 -o t_{name}.tif"));
  ASSERT_EQ(tiles.exit_code, 0) << tiles.err;
  expect_mosaic({"t_0_0.tif", "t_1_0.tif", "t_2_0.tif", "t_0_1.tif", "t_1_1.tif", "t_2_1.tif"});
  const Finished sized = run(words(std::string(kSheets) + " --tile-size 100x137"));
  ASSERT_EQ(sized.exit_code, 0) << sized.err;
  expect_mosaic({"hills_0_0.tif", "hills_1_0.tif"});
}

TEST_F(Sheets, FollowOutlinesOfAFile) {
  ASSERT_EQ(run(words(kMap)).exit_code, 0);
  const auto outline = [](const std::string& name, double west, double east) {
    const auto at = [](double x, const char* y) { return "[" + std::to_string(x) + "," + y + "]"; };
    return R"({"type":"Feature","properties":{"sheet":")" + name +
           R"("},"geometry":{"type":"Polygon","coordinates":[[)" + at(west, "47.9") + "," +
           at(east, "47.9") + "," + at(east, "48.1") + "," + at(west, "48.1") + "," +
           at(west, "47.9") + "]]}}";
  };
  write_text(path("grid.geojson"),
             R"({"type":"FeatureCollection","features":[)" + outline("West 1", 6.9, 7.0013) + "," +
                 outline("Ost", 7.0013, 7.1) + "," + outline("beside", 8, 9) + "]}");
  const Finished finished = run(words(std::string(kSheets) + " --sheets grid.geojson "
                                                             "--sheet-name sheet -o s-{name}.tif"));
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  expect_mosaic({"s-West 1.tif", "s-Ost.tif"});
  EXPECT_EQ(outputs(),
            (std::vector<std::string>{"grid.geojson", "s-Ost.tif", "s-West 1.tif", "whole.tif"}));
  expect_refused(run(words(std::string(kSheets) + " --sheets grid.geojson")), {"name", "sheet"});
}

TEST_F(Sheets, AreRefusedBeforeAnyIsWritten) {
  write_text(path("hills_1_1.tif"), "mine");
  expect_refused(run(words("overview hills.tif --tiles 2x2")), {"hills_1_1.tif", "--overwrite"});
  EXPECT_EQ(outputs(), std::vector<std::string>{"hills_1_1.tif"});
  expect_refused(run(words("overview hills.tif --tiles 2x2 -o map.tif")), {"map.tif", "{name}"});
  expect_refused(
      run(words("overview hills.tif --tiles 2x2 -o {name}" + std::string(260, 'x') + ".tif")),
      {"cannot be written"});
  expect_refused(run(words("overview hills.tif --tiles 99x2")), {"--tiles", "41x41"});
  expect_refused(run(words("overview hills.tif --tiles 0x2")), {"--tiles"});
  expect_refused(run(words("overview hills.tif --tile-size 10x0")), {"--tile-size"});
}

TEST_F(Sheets, HaveAlphaThoughTheyHaveNoGap) {
  ASSERT_EQ(run(words("overview hills.tif -q --tiles 3x3 -o {name}.tif")).exit_code, 0);
  const GDALDatasetUniquePtr middle(GDALDataset::Open(path("1_1.tif").c_str()));
  ASSERT_TRUE(middle);
  ASSERT_EQ(middle->GetRasterCount(), 4);
  std::array<double, 2> range{};
  ASSERT_EQ(middle->GetRasterBand(4)->ComputeRasterMinMax(false, range.data()), CE_None);
  EXPECT_EQ(range[0], 255);
}

TEST_F(Sheets, AreRefusedForAFileBesideAPicture) {
  write_text(path("m-1_0.pgw"), "mine");
  expect_refused(run(words("overview hills.tif --tiles 2x1 -o m-{name}.png")),
                 {"m-1_0.pgw", "--overwrite"});
  EXPECT_EQ(outputs(), std::vector<std::string>{"m-1_0.pgw"});
}

TEST_F(Sheets, HaveNamesByTheTemplateOfABatch) {
  const std::vector<Sheet> sheets{{"a", {}}, {"b", {}}};
  EXPECT_EQ(sheet_paths("{name}/{index:02}-{name}{{}}.tif", sheets),
            (std::vector<std::string>{"a/01-a{}.tif", "b/02-b{}.tif"}));
  for (const std::string pattern : {"map.tif", "{{name}}.tif", "{sheet}.tif", "{name.tif"})
    EXPECT_THROW(static_cast<void>(sheet_paths(pattern, sheets)), InputError) << pattern;
  for (const std::string name : {"../up", "", "..", "two\nlines"})
    EXPECT_THROW(static_cast<void>(sheet_paths("{name}.tif", {{name, {}}})), InputError) << name;
  const Finished finished = run(words("overview hills.tif -q --tiles 2x1 -o new/{name}.tif"));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(outputs(), std::vector<std::string>{"new"});
}

TEST_F(Sheets, AreNoFileThatIsRead) {
  std::filesystem::copy_file(path("hills.tif"), path("0_0.tif"));
  write_text(path("1_0.tif"),
             R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":
             {"name":"1_0"},"geometry":{"type":"Polygon","coordinates":[[[6.9,47.9],[7.1,47.9],
             [7.1,48.1],[6.9,48.1],[6.9,47.9]]]}}]})");
  for (const std::string line : {"0_0.tif --tiles 1x1", "hills.tif --sheets 1_0.tif"})
    expect_refused(run(words("overview --overwrite -o {name}.tif " + line)), {"is read by this"});
}

}  // namespace
}  // namespace terrview
