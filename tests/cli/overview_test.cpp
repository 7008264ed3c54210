// Blocks framed by themselves, their ticks, and sheets of maps: docs/overview.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include <ogr_spatialref.h>

#include "cli/overview_block.h"
#include "cli/overview_furniture.h"
#include "cli/overview_sheets.h"
#include "cli/overview_ticks.h"
#include "terrain/error.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

Dem dem_of(int columns, int rows, const std::function<double(int, int)>& height_m) {
  HeightGrid grid{columns, rows, {}};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      grid.heights_m.push_back(static_cast<float>(height_m(column, row)));
  Dem dem;
  dem.name = "test";
  dem.grid = std::make_shared<const HeightGrid>(std::move(grid));
  dem.placement = {{1000, 9000}, {{50, 0}, {0, -80}}};
  return dem;
}

OverviewOptions framed(const std::string& line) { return parse_overview(words("x.tif " + line)); }

// Every post, at the ground and at the plinth, in the picture.
struct Reach {
  glm::dvec2 low_px{1e9, 1e9};
  glm::dvec2 high_px{-1e9, -1e9};
};

Reach reach_of(const BlockView& block) {
  Reach reach;
  const Terrain& terrain = *block.view.scene.terrain;
  const TerrainLayer& layer = terrain.layers().front();
  for (int row = 0; row < layer.grid->rows; ++row) {
    for (int column = 0; column < layer.grid->columns; ++column) {
      const double height_m = layer.grid->at(column, row);
      if (std::isnan(height_m)) continue;
      const glm::dvec2 ground_m((column - (layer.grid->columns - 1) / 2.0) * 50,
                                ((layer.grid->rows - 1) / 2.0 - row) * 80);
      const double top_m = block.z_scale * height_m - terrain.frame().eye_height_m;
      for (const double z_m : {top_m, block.plinth_z_m}) {
        const glm::dvec2 at = *block.view.camera.project({ground_m, z_m});
        reach.low_px = glm::min(reach.low_px, at);
        reach.high_px = glm::max(reach.high_px, at);
      }
    }
  }
  return reach;
}

TEST(OverviewBlock, FillsTheRoomBetweenItsMarginsFromEverySide) {
  const std::vector<Dem> dems{
      dem_of(30, 20, [](int column, int row) { return 200 + 90 * std::sin(column * row * 0.1); })};
  for (const char* side : {"s", "sw", "247", "n", "-30", "e"}) {
    for (const char* tilt : {"5", "35", "62.5", "90"}) {
      for (const char* size : {"--size 640x480", "--size 300x700", ""}) {
        const std::string line = "--from " + std::string(side) + " --tilt " + tilt + " " + size;
        const BlockView block = make_block(framed(line), dems);
        const glm::dvec2 picture(block.view.camera.options().size_px);
        const Reach reach = reach_of(block);
        const BlockMargins& margins = block.margins;
        const glm::dvec2 room_low(margins.left_px, margins.top_px);
        const glm::dvec2 room_high = picture - glm::dvec2(margins.right_px, margins.bottom_px);
        for (const int axis : {0, 1}) {
          EXPECT_GE(reach.low_px[axis], room_low[axis] - 1) << line;
          EXPECT_LE(reach.high_px[axis], room_high[axis] + 1) << line;
        }
        const glm::dvec2 left = (room_high - room_low) - (reach.high_px - reach.low_px);
        EXPECT_LT(std::min(left.x, left.y), 1) << line;
      }
    }
  }
}

TEST(OverviewBlock, IsSeenWholeWithEveryRayInFrontOfIt) {
  const std::vector<Dem> dems{
      dem_of(12, 12, [](int column, int row) { return column == 6 && row == 6 ? 900.0 : 100.0; })};
  for (const char* tilt : {"5", "90"}) {
    const BlockView block = make_block(framed("--tilt " + std::string(tilt)), dems);
    const glm::dvec3 forward = block.view.camera.forward();
    const TerrainLayer& layer = block.view.scene.terrain->layers().front();
    const glm::dvec3 peak(
        25, -40,
        block.z_scale * layer.grid->at(6, 6) - block.view.scene.terrain->frame().eye_height_m);
    EXPECT_GT(glm::dot(peak, forward), 0) << tilt;
  }
}

TEST(OverviewBlock, RefusesAPictureWithoutRoom) {
  const std::vector<Dem> dems{dem_of(3, 3, [](int, int) { return 1.0; })};
  EXPECT_THROW(static_cast<void>(make_block(framed("--size 100x60"), dems)), InputError);
  EXPECT_NO_THROW(static_cast<void>(make_block(framed("--size 100x60 --plain"), dems)));
}

TEST(OverviewBlock, IsRefusedWithItsOwnSizeAlone) {
  const std::vector<Dem> dems{dem_of(3, 3, [](int, int) { return 1.0; })};
  try {
    static_cast<void>(make_block(framed("--size 500000x100 --plain"), dems));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(says(error.what(), {"--size: 500000x100"}));
  }
  // However small the ground.
  std::vector<Dem> tiny = dems;
  tiny[0].placement.step[0] *= 1e-3;
  tiny[0].placement.step[1] *= 1e-3;
  EXPECT_NO_THROW(static_cast<void>(make_block(framed("--size 8000x6000"), tiny)));
}

TEST(OverviewBlock, WithoutAFontIsRefusedBeforeItIsDrawn) {
  const std::vector<Dem> dems{dem_of(3, 3, [](int, int) { return 1.0; })};
  EXPECT_THROW(static_cast<void>(make_block(framed("--font none.ttf"), dems)), InputError);
  for (const char* line : {"--font a.ttf", "--title A", "--ticks own"})
    EXPECT_THROW(static_cast<void>(framed("--plain " + std::string(line))), InputError) << line;
}

// Furniture alone, on paper.
class OverviewFurniture : public testing::Test {
 protected:
  OverviewFurniture() {
    dems_[0].crs_wkt = SRS_WKT_WGS84_LAT_LONG;
    dems_[0].placement = {{7, 48}, {{0.001, 0}, {0, -0.001}}};
  }

  [[nodiscard]] Image drawn(const std::string& line) const {
    const OverviewOptions options = framed("--size 500x400 --from sw " + line);
    const BlockView block = make_block(options, dems_);
    Image image(500, 400);
    for (int row = 0; row < 400; ++row)
      for (int column = 0; column < 500; ++column) image.at(column, row) = glm::vec3(1);
    draw_furniture(options, dems_, block, image);
    return image;
  }

  // Pixels of a part of the picture that are other than in another one, or not paper.
  [[nodiscard]] static int inked(const Image& image, const PixelRect& part,
                                 const Image* other = nullptr) {
    int count = 0;
    for (int row = 0; row < part.size_px.y; ++row) {
      for (int column = 0; column < part.size_px.x; ++column) {
        const glm::ivec2 at = part.first_px + glm::ivec2(column, row);
        count += image.at(at.x, at.y) != (other ? other->at(at.x, at.y) : glm::vec3(1)) ? 1 : 0;
      }
    }
    return count;
  }

  std::vector<Dem> dems_{dem_of(60, 40, [](int column, int) { return 200.0 + column; })};
  const PixelRect title_{{0, 0}, {250, 40}};
  const PixelRect arrow_{{430, 0}, {70, 50}};
  const PixelRect scale_{{0, 370}, {200, 30}};
  const PixelRect heights_{{400, 370}, {100, 30}};
  const PixelRect sides_{{0, 50}, {500, 320}};
};

TEST_F(OverviewFurniture, StandsInItsPlaces) {
  const Image image = drawn("--title Hills");
  for (const PixelRect& part : {title_, arrow_, scale_, heights_, sides_})
    EXPECT_GT(inked(image, part), 20) << part.first_px.x << "," << part.first_px.y;
}

TEST_F(OverviewFurniture, FollowsItsOptions) {
  const Image hills = drawn("--title Hills");
  const Image valleys = drawn("--title Valleys");
  EXPECT_GT(inked(hills, title_, &valleys), 20);
  for (const PixelRect& part : {arrow_, scale_, heights_, sides_})
    EXPECT_EQ(inked(hills, part, &valleys), 0);
  const Image named = drawn("");
  EXPECT_GT(inked(hills, title_, &named), 20);
  const Image higher = drawn("--title Hills --z-scale 7.5");
  EXPECT_GT(inked(hills, heights_, &higher), 5);
  EXPECT_EQ(inked(hills, title_, &higher), 0);
}

// By PROJ through OGR: where a place of UTM zone 32 lies on the Earth.
TEST(OverviewTicks, LieWherePROJHasTheirCoordinates) {
  OGRSpatialReference utm;
  OGRSpatialReference wgs84;
  ASSERT_EQ(utm.importFromEPSG(32632), OGRERR_NONE);
  ASSERT_EQ(wgs84.importFromEPSG(4326), OGRERR_NONE);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> transform(
      OGRCreateCoordinateTransformation(&utm, &wgs84));
  const PostPlacement placement{{351037.5, 5325462.5}, {{75, 0}, {0, -75}}};
  const Coordinates degrees = [&](glm::dvec2 uv) {
    glm::dvec2 at = placement.at(uv);
    transform->Transform(1, &at.x, &at.y);
    return at;
  };
  const Ticks south = ticks_along({0, 299}, {199, 299}, degrees, 6);
  EXPECT_EQ(south.axis, 0);
  EXPECT_EQ(south.step, 0.05);
  ASSERT_EQ(south.ticks.size(), 4U);  // 7.05, 7.10, 7.15, 7.20 of 7.008 to 7.207
  for (const Tick& tick : south.ticks) EXPECT_NEAR(degrees(tick.uv).x, tick.value, 1e-12);
  EXPECT_NEAR(south.ticks.front().value, 7.05, 1e-12);
  const Ticks west = ticks_along({0, 0}, {0, 299}, degrees, 6);
  EXPECT_EQ(west.axis, 1);
  for (const Tick& tick : west.ticks) EXPECT_NEAR(degrees(tick.uv).y, tick.value, 1e-12);

  const Coordinates own = [&](glm::dvec2 uv) { return placement.at(uv); };
  const Ticks metres = ticks_along({0, 299}, {199, 299}, own, 6);
  EXPECT_EQ(metres.step, 5000);
  ASSERT_EQ(metres.ticks.size(), 3U);
  EXPECT_EQ(metres.ticks[0].value, 355000);
  EXPECT_NEAR(metres.ticks[0].uv.x, (355000 - 351037.5) / 75, 1e-9);
}

TEST(OverviewTicks, AreToldInWords) {
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 0, -7.2, 0.2), "7.2° W");
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 1, 48, 0.25), "48.0° N");
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 0, -1e-12, 0.5), "0.0° E");
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 0, 180.0329, 0.0008), "179.9671° W");
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 0, 180, 0.01), "180.00° E");
  EXPECT_EQ(coordinate_text(CoordinateKind::grid, 1, 776000, 2000), "776000 N");
  EXPECT_EQ(coordinate_text(CoordinateKind::plain, 0, -0.5, 0.1), "x -0.5");
  EXPECT_EQ(round_length(4999), 2000);
  EXPECT_EQ(round_length(5000), 5000);
  EXPECT_EQ(round_length(0.3), 0.2);
}

struct MapPixels {
  glm::ivec2 size_px;
  std::array<double, 6> transform;
  std::vector<std::uint8_t> values;  // red, green and blue of each pixel
};

MapPixels read_map(const std::string& path) {
  const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str()));
  if (!file) throw std::runtime_error("no map in " + path);
  MapPixels map{{file->GetRasterXSize(), file->GetRasterYSize()}, {}, {}};
  file->GetGeoTransform(map.transform.data());  // a block has none
  map.values.resize(static_cast<std::size_t>(map.size_px.x * map.size_px.y) * 3);
  EXPECT_EQ(file->RasterIO(GF_Read, 0, 0, map.size_px.x, map.size_px.y, map.values.data(),
                           map.size_px.x, map.size_px.y, GDT_Byte, 3, nullptr, 3,
                           GSpacing{3} * map.size_px.x, 1, nullptr),
            CE_None);
  return map;
}

class Sheets : public SmallView {
 protected:
  static constexpr const char* kMap =
      "overview hills.tif -q --plan --resolution 0.0003 --contours 20 --sun 250,12 -o whole.tif";
  static constexpr const char* kSheets =
      "overview hills.tif -q --resolution 0.0003 --contours 20 --sun 250,12";

  // Every pixel of the whole is in one of the sheets, and the same there.
  void expect_mosaic(const std::vector<std::string>& names) const {
    const MapPixels whole = read_map(path("whole.tif"));
    std::vector<int> shown(whole.values.size() / 3, 0);
    for (const std::string& name : names) {
      const MapPixels sheet = read_map(path(name));
      const int left =
          static_cast<int>(std::lround((sheet.transform[0] - whole.transform[0]) / 0.0003));
      const int above =
          static_cast<int>(std::lround((sheet.transform[3] - whole.transform[3]) / -0.0003));
      for (int row = 0; row < sheet.size_px.y; ++row) {
        for (int column = 0; column < sheet.size_px.x; ++column) {
          const auto from = static_cast<std::size_t>(row * sheet.size_px.x + column);
          const auto to = static_cast<std::size_t>((row + above) * whole.size_px.x + column + left);
          ++shown[to];
          for (std::size_t band = 0; band < 3; ++band)
            ASSERT_EQ(sheet.values[3 * from + band], whole.values[3 * to + band]) << name;
        }
      }
    }
    EXPECT_EQ(std::set<int>(shown.begin(), shown.end()), std::set<int>{1});
  }
};

TEST_F(Sheets, AreTheWholeMapToTheByte) {
  ASSERT_EQ(run(words(kMap)).exit_code, 0);
  ASSERT_EQ(read_map(path("whole.tif")).size_px, glm::ivec2(137, 137));
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

TEST_F(Sheets, OfOtherKindsOfOverviewAreRefused) {
  expect_refused(run(words("overview hills.tif --plan --tilt 20")), {"--tilt", "block"});
  expect_refused(run(words("overview hills.tif --resolution 5")), {"--resolution", "--plan"});
  expect_refused(run(words("overview hills.tif --from up")), {"--from", "up"});
  expect_refused(run(words("overview hills.tif --tilt 4")), {"--tilt"});
}

TEST_F(Sheets, OrABlockComesOutOfOneCommand) {
  const Finished finished =
      run(words("overview hills.tif --from wsw --size 400x300 --title Hills -o block.png"));
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_NE(finished.err.find("heights x "), std::string::npos);
  const MapPixels plain = read_map(path("block.png"));
  EXPECT_EQ(plain.size_px, glm::ivec2(400, 300));
  const auto corner = std::vector<std::uint8_t>(plain.values.begin(), plain.values.begin() + 3);
  EXPECT_EQ(corner, (std::vector<std::uint8_t>{246, 244, 239}));
  // The title is above, where the block is not.
  EXPECT_LT(*std::min_element(plain.values.begin(), plain.values.begin() + 3 * 400 * 40), 60);
}

TEST_F(Sheets, OrABlockThatSaysAllThatChangesIt) {
  const auto said = [&](const std::string& line) {
    const Finished finished =
        run(words("overview hills.tif -q --size 300x240 --samples 1 --overwrite -o b.png " + line));
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    const std::string text = bytes("b.png");
    const std::size_t at = text.find("terrview:view");
    return text.substr(at, text.find("IDAT") - at);
  };
  const std::set<std::string> texts{said("--title A"), said("--title B"),
                                    said("--title A --ticks degrees"), said("--plain")};
  EXPECT_EQ(texts.size(), 4U);
}

TEST_F(Sheets, OrCloudOptimizedMapsAreGeoTiffs) {
  const Finished finished = run(words("overview hills.tif -q --plan --of COG -o cog.tif"));
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const GDALDatasetUniquePtr file(GDALDataset::Open(path("cog.tif").c_str()));
  ASSERT_TRUE(file);
  EXPECT_STREQ(file->GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"), "COG");
  EXPECT_EQ(outputs(), std::vector<std::string>{"cog.tif"});
}

}  // namespace
}  // namespace terrview
