// Promises of sky/flat_sky.h.
#include "sky/flat_sky.h"

#include <gtest/gtest.h>

#include "sky/field_part.h"

namespace terrview {
namespace {

// A table whose colour tells the address.
ColorTable gauge() {
  ColorTable table;
  for (auto& ramp : table.ramps) ramp = {{0, 0}, {1, 1}};
  return table;
}

FlatSkyOptions options_of(FieldKind kind, glm::ivec2 levels, glm::ivec2 size_px) {
  FlatSkyOptions options;
  options.field.kind = kind;
  options.field.levels = levels;
  options.table = gauge();
  options.size_px = size_px;
  return options;
}

Image painted(const FlatSkyOptions& options, bool backwards = false) {
  const FlatSky sky(options);
  Image image(options.size_px.x, options.size_px.y);
  const glm::ivec2 tiles = sky.tiles();
  const int count = tiles.x * tiles.y;
  for (int i = 0; i < count; ++i) {
    const int index = backwards ? count - 1 - i : i;
    sky.paint({index % tiles.x, index / tiles.x}, image);
  }
  return image;
}

TEST(FlatSky, TilesMayComeInAnyOrder) {
  const FlatSkyOptions options = options_of(FieldKind::smooth, {6, 7}, {300, 270});
  EXPECT_EQ(painted(options).pixels(), painted(options, true).pixels());
}

TEST(FlatSky, NeighboursContinueEachOther) {
  for (const FieldKind kind : {FieldKind::midpoint, FieldKind::displaced, FieldKind::smooth}) {
    FlatSkyOptions west = options_of(kind, {5, 5}, {200, 100});
    west.cells = {1.5, 0.75};
    west.table.noise = 0;
    FlatSkyOptions east = west;
    east.origin = {1, 0};
    FlatSkyOptions both = west;
    both.size_px.x = 400;
    both.cells.x = 3;
    const Image left = painted(west);
    const Image right = painted(east);
    const Image whole = painted(both);
    for (int row = 0; row < 100; row += 7) {
      for (int column = 0; column < 200; ++column) {
        ASSERT_EQ(whole.at(column, row), left.at(column, row));
        ASSERT_NEAR(whole.at(200 + column, row).r, right.at(column, row).r, 2e-3);
      }
    }
  }
}

TEST(FlatSky, ShowsTheFieldNorthUp) {
  FlatSkyOptions options = options_of(FieldKind::midpoint, {4, 4}, {16, 16});
  options.table.window = {0.5, 0.1};
  const Image image = painted(options);
  const RandomField field(options.field);
  const std::vector<float> values = field_part(field, {0, 0, 17, 17});
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 16; ++column) {
      const auto south_west = static_cast<std::size_t>((15 - row) * 17 + column);
      const double middle = static_cast<double>(values[south_west] + values[south_west + 1] +
                                                values[south_west + 17] + values[south_west + 18]) /
                            4;
      const double address = 0.5 + 0.1 * middle / field.expected_deviation();
      ASSERT_NEAR(image.at(column, row).r, linear_from_srgb(address), 1e-3);
    }
  }
}

TEST(FlatSky, StopsDividingUnderAPixel) {
  FlatSkyOptions deep = options_of(FieldKind::smooth, {24, 24}, {256, 256});
  FlatSkyOptions enough = deep;
  enough.field.levels = {8, 8};
  // The window counts in deviations of the whole field.
  const double ratio =
      RandomField(enough.field).expected_deviation() / RandomField(deep.field).expected_deviation();
  enough.table.window.width *= ratio;
  const Image a = painted(deep);
  const Image b = painted(enough);
  for (int i = 0; i < 256; ++i) ASSERT_NEAR(a.at(i, i).r, b.at(i, i).r, 1e-3);
}

TEST(FlatSky, WhiteNoiseChangesPixelsByItsDeviation) {
  FlatSkyOptions plain = options_of(FieldKind::midpoint, {2, 2}, {200, 200});
  plain.table.ramps = {{{{0, 0.5}}, {{0, 0.5}}, {{0, 0}, {1, 1}}}};
  FlatSkyOptions noisy = plain;
  noisy.table.noise = 0.02;
  const Image a = painted(plain);
  const Image b = painted(noisy);
  EXPECT_EQ(a.at(3, 3).r, b.at(3, 3).r);
  int changed = 0;
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 200; ++column)
      changed += std::abs(a.at(column, row).b - b.at(column, row).b) > 1e-4F ? 1 : 0;
  EXPECT_GT(changed, 39000);
}

}  // namespace
}  // namespace terrview
