#include "render/map_ink.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace terrview {
namespace {

// Of samples across a pixel.
constexpr int kSamples = 4;

void blend(Image& image, glm::ivec2 pixel, const glm::vec3& color, float share) {
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= image.width_px() || pixel.y >= image.height_px())
    return;
  glm::vec3& under = image.at(pixel.x, pixel.y);
  under = glm::mix(under, color, share);
}

// By the parity of the sides to its right.
bool is_inside(std::span<const glm::dvec2> corners, glm::dvec2 point) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a = corners[i];
    const glm::dvec2 b = corners[(i + 1) % corners.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

float share_inside(std::span<const glm::dvec2> corners, glm::ivec2 pixel) {
  int inside = 0;
  for (int i = 0; i < kSamples * kSamples; ++i) {
    const glm::dvec2 sample((i % kSamples + 0.5) / kSamples,
                            (static_cast<double>(i / kSamples) + 0.5) / kSamples);
    if (is_inside(corners, glm::dvec2(pixel) + sample)) ++inside;
  }
  return static_cast<float>(inside) / (kSamples * kSamples);
}

}  // namespace

void ink_polygon(std::span<const glm::dvec2> corners_px, const glm::vec3& color, Image& image) {
  glm::dvec2 low(image.width_px(), image.height_px());
  glm::dvec2 high(0);
  for (const glm::dvec2& corner : corners_px) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  const glm::ivec2 first(glm::max(glm::floor(low), glm::dvec2(0)));
  const glm::ivec2 end(glm::min(glm::ceil(high), glm::dvec2(image.width_px(), image.height_px())));
  for (int row = first.y; row < end.y; ++row) {
    for (int column = first.x; column < end.x; ++column) {
      const glm::ivec2 pixel(column, row);
      blend(image, pixel, color, share_inside(corners_px, pixel));
    }
  }
}

void ink_line(glm::dvec2 from_px, glm::dvec2 to_px, double width_px, const glm::vec3& color,
              Image& image) {
  const glm::dvec2 along = to_px - from_px;
  const double length_px = glm::length(along);
  if (length_px == 0) return;
  const glm::dvec2 aside = glm::dvec2(-along.y, along.x) * (width_px / 2 / length_px);
  const std::array<glm::dvec2, 4> corners{from_px + aside, to_px + aside, to_px - aside,
                                          from_px - aside};
  ink_polygon(corners, color, image);
}

PixelRect text_box(const InkText& text, const Font& font) {
  const glm::ivec2 size(font.width_px(text.text), font.ascent_px() + font.descent_px());
  return {glm::ivec2(glm::round(text.at_px - text.anchor * glm::dvec2(size))), size};
}

void ink_text(const InkText& text, const Font& font, const glm::vec3& color, Image& image) {
  const glm::ivec2 start = text_box(text, font).first_px + glm::ivec2(0, font.ascent_px());
  font.draw(text.text,
            [&](glm::ivec2 offset, float share) { blend(image, start + offset, color, share); });
}

}  // namespace terrview
