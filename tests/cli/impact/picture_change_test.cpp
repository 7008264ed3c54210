// One test per promise of cli/impact/picture_change.h.
#include "cli/impact/picture_change.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "render/color_ramp.h"

namespace terrview {
namespace {

// A picture of letters: ' ' the sky, '.' ground, a digit an object; all of one grey.
Frame frame_of(const std::vector<std::string>& rows) {
  const int width = static_cast<int>(rows.front().size());
  const int height = static_cast<int>(rows.size());
  Frame frame{.image = Image(width, height, from_srgb8(100, 100, 100)),
              .samples = Raster<PixelSample>(width, height),
              .counts = {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const char letter = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      frame.samples.at(column, row).object_id = letter == ' '   ? PixelSample::kNothing
                                                : letter == '.' ? PixelSample::kGround
                                                                : letter - '0';
    }
  return frame;
}

TEST(PictureChange, MasksWhatDiffersInEightBits) {
  const Frame before = frame_of({"   ", "..."});
  Frame after = frame_of({" 2 ", ".2."});
  after.image.at(1, 0) = from_srgb8(101, 100, 100);
  after.image.at(0, 1) = from_srgb8(100, 100, 99);
  after.image.at(2, 1).x += 1e-6F;  // the same byte
  const PictureChange change = picture_change(before, after, 1, 2);
  EXPECT_EQ(change.changed_px, 2);
  EXPECT_EQ(change.mask.at(1, 0), glm::vec3(1)) << "the project";
  EXPECT_EQ(change.mask.at(0, 1), from_srgb8(128, 128, 128)) << "its shadow";
  EXPECT_EQ(change.mask.at(1, 1), glm::vec3(0)) << "the project, but of the same colour";
  EXPECT_EQ(change.mask.at(2, 1), glm::vec3(0));
}

TEST(PictureChange, CountsTheProjectsPixelsByBuilding) {
  const PictureChange change =
      picture_change(frame_of({"1..", "..4"}), frame_of({"134", "322"}), 1, 3);
  EXPECT_EQ(change.building_px, (std::map<std::int32_t, std::int64_t>{{2, 2}, {3, 2}}))
      << "4 is a tree";
}

TEST(PictureChange, FindsTheColumnsWhoseHorizonMoves) {
  // A column of sky alone, one of ground alone, one that stays, two that rise: one of them from
  // nothing.
  const PictureChange change = picture_change(frame_of({" .   ", " . . ", " ... "}),
                                              frame_of({" .   ", " . 2 ", " ..22"}), 1, 3);
  EXPECT_EQ(change.horizon_columns, 3);
  EXPECT_EQ(change.changed_columns, 1);
  const PictureChange higher =
      picture_change(frame_of({"   ", "   ", "..."}), frame_of({" 2 ", " 2 ", ".2."}), 1, 3);
  EXPECT_EQ(higher.horizon_columns, 3);
  EXPECT_EQ(higher.changed_columns, 1) << "beyond the picture's top, too";
}

}  // namespace
}  // namespace terrview
