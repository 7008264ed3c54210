// Labels as ink on a picture: render/draw_labels.h.
#include "render/draw_labels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <glm/common.hpp>

namespace terrview {
namespace {

constexpr float kGround = 0.3F;

class DrawnLabel : public testing::Test {
 protected:
  Font font_{usual_font(), 20};
  LabelInk label_{"Hill", {{30, 10}, {30 + font_.width_px("Hill"), 34}}, {45, 70}};

  [[nodiscard]] Image drawn(glm::ivec2 size_px, glm::ivec2 moved_px = {0, 0}) const {
    Image image(size_px.x, size_px.y, glm::vec3(kGround));
    LabelInk label = label_;
    label.box = {label.box.low_px + moved_px, label.box.high_px + moved_px};
    label.foot_px += moved_px;
    draw_labels({&label, 1}, font_, image);
    return image;
  }

  // The share of each pixel that letters and leader take.
  [[nodiscard]] Raster<float> letters(glm::ivec2 size_px) const {
    Raster<float> ink(size_px.x, size_px.y, 0);
    const glm::ivec2 line(label_.box.low_px.x, label_.box.high_px.y - font_.descent_px());
    font_.draw(label_.text, [&](glm::ivec2 at, float share) {
      float& pixel = ink.at(line.x + at.x, line.y + at.y);
      pixel = std::max(pixel, share);
    });
    return ink;
  }
};

float most_within(const Raster<float>& ink, glm::ivec2 pixel, int reach_px) {
  float most = 0;
  for (int y = std::max(0, pixel.y - reach_px);
       y <= std::min(ink.height_px() - 1, pixel.y + reach_px); ++y)
    for (int x = std::max(0, pixel.x - reach_px);
         x <= std::min(ink.width_px() - 1, pixel.x + reach_px); ++x)
      most = std::max(most, ink.at(x, y));
  return most;
}

constexpr glm::ivec2 kSize_px{120, 90};

TEST_F(DrawnLabel, HasDarkLettersInAHaloOfTwoPixels) {
  const Image image = drawn(kSize_px);
  const Raster<float> ink = letters(kSize_px);
  int dark = 0;
  int light = 0;
  // Above the leader.
  for (int row = 0; row < label_.box.high_px.y - 1; ++row)
    for (int column = 0; column < kSize_px.x; ++column) {
      const float seen = image.at(column, row).g;
      if (ink.at(column, row) == 1) {
        EXPECT_LT(seen, 0.02F);
        ++dark;
      } else if (ink.at(column, row) == 0) {
        const float near = most_within(ink, {column, row}, 2);
        if (near > 0) {
          EXPECT_GT(seen, kGround) << column << ' ' << row;
        } else {
          EXPECT_EQ(seen, kGround) << column << ' ' << row;
        }
        light += near > 0 ? 1 : 0;
      }
    }
  EXPECT_GT(dark, 30);
  EXPECT_GT(light, 100);
}

TEST_F(DrawnLabel, HasADarkLeaderToItsFootInAHaloOfOnePixel) {
  const Image image = drawn(kSize_px);
  const glm::ivec2 foot = label_.foot_px;
  for (int row = label_.box.high_px.y + 3; row <= foot.y; ++row) {
    EXPECT_LT(image.at(foot.x, row).g, 0.02F);
    for (const int side : {-1, 1}) {
      EXPECT_GT(image.at(foot.x + side, row).g, kGround);
      EXPECT_EQ(image.at(foot.x + 2 * side, row).g, kGround);
    }
  }
  EXPECT_GT(image.at(foot.x, foot.y + 1).g, kGround);
  EXPECT_EQ(image.at(foot.x, foot.y + 2).g, kGround);
}

TEST_F(DrawnLabel, IsCutByThePicturesBorders) {
  const Image whole = drawn(kSize_px);
  for (const glm::ivec2 moved_px : {glm::ivec2(-40, -15), {50, 40}, {-200, 0}, {0, -100}}) {
    const Image cut = drawn(kSize_px, moved_px);
    for (int row = 0; row < kSize_px.y; ++row)
      for (int column = 0; column < kSize_px.x; ++column) {
        const glm::ivec2 from = glm::ivec2(column, row) - moved_px;
        const bool within = glm::clamp(from, glm::ivec2(0), kSize_px - 1) == from;
        ASSERT_EQ(cut.at(column, row), within ? whole.at(from.x, from.y) : glm::vec3(kGround));
      }
  }
}

}  // namespace
}  // namespace terrview
