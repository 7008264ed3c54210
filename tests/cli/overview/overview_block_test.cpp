// Blocks framed by themselves, and what is written beside them: docs/overview.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <ogr_spatialref.h>

#include "cli/overview_block.h"
#include "cli/overview_furniture.h"
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

}  // namespace
}  // namespace terrview
