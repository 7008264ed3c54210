// What a map says beside its ground: lines, areas and words on a picture.
#pragma once

#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/camera.h"
#include "render/image.h"
#include "render/text.h"

namespace terrview {

// Points are image points: pixel (i, j) has its centre at (i + 0.5, j + 0.5). What lies beside the
// picture is cut off. Colours are linear.
void ink_polygon(std::span<const glm::dvec2> corners_px, const glm::vec3& color, Image& image);
void ink_line(glm::dvec2 from_px, glm::dvec2 to_px, double width_px, const glm::vec3& color,
              Image& image);

// A line of text about a point: the point lies at `anchor` of its box, from (0, 0), upper left, to
// (1, 1).
struct InkText {
  std::string text;
  glm::dvec2 at_px;
  glm::dvec2 anchor{0, 0};
};

[[nodiscard]] PixelRect text_box(const InkText& text, const Font& font);
void ink_text(const InkText& text, const Font& font, const glm::vec3& color, Image& image);

}  // namespace terrview
