#include "render/map_ink.h"

#include <gtest/gtest.h>

#include <array>

namespace terrview {
namespace {

double ink_on(const Image& image) {
  double sum = 0;
  for (const glm::vec3& pixel : image.pixels()) sum += 1 - pixel.x;
  return sum;
}

TEST(MapInk, CoversAnArea) {
  Image image(40, 30, glm::vec3(1));
  const std::array<glm::dvec2, 3> triangle{glm::dvec2(5, 5), {35, 8}, {12, 25}};
  ink_polygon(triangle, glm::vec3(0), image);
  EXPECT_NEAR(ink_on(image), (30 * 20 - 7 * 3) / 2.0, 3);
}

TEST(MapInk, IsCutAtThePicturesEdge) {
  Image image(20, 20, glm::vec3(1));
  ink_line({-10, 10}, {30, 10}, 2, glm::vec3(0), image);
  EXPECT_NEAR(ink_on(image), 40, 1e-4);
}

TEST(MapInk, LettersStandInTheirBox) {
  const Font font(usual_font(), 14);
  for (const glm::dvec2 anchor : {glm::dvec2(0, 0), {1, 0.5}, {0.5, 1}}) {
    Image image(200, 100, glm::vec3(1));
    const InkText text{"49.5° N", {100, 50}, anchor};
    ink_text(text, font, glm::vec3(0), image);
    const PixelRect box = text_box(text, font);
    EXPECT_GT(ink_on(image), 50);
    for (int row = 0; row < 100; ++row) {
      for (int column = 0; column < 200; ++column) {
        const glm::ivec2 at = glm::ivec2(column, row) - box.first_px;
        const bool inside =
            at.x >= -1 && at.y >= -1 && at.x <= box.size_px.x && at.y <= box.size_px.y;
        if (!inside) {
          EXPECT_EQ(image.at(column, row).x, 1) << column << " " << row;
        }
      }
    }
  }
}

}  // namespace
}  // namespace terrview
