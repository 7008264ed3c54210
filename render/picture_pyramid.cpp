#include "render/picture_pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/vec3.hpp>

#include "render/color_ramp.h"

namespace terrview {
namespace {

glm::vec4 linear_of(glm::u8vec4 pixel) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i)
      linear[i] = from_srgb8(static_cast<float>(i), 0, 0).x;
    return linear;
  }();
  const float share = static_cast<float>(pixel.a) / 255;
  return {share * table[pixel.r], share * table[pixel.g], share * table[pixel.b], share};
}

std::uint8_t rounded(float share) { return static_cast<std::uint8_t>(255 * share + 0.5F); }

glm::u8vec4 stored(const glm::vec4& linear) {
  if (linear.a <= 0) return glm::u8vec4(0);
  const glm::vec3 color = glm::vec3(linear) / linear.a;
  return {to_srgb8(color.r), to_srgb8(color.g), to_srgb8(color.b),
          rounded(std::min(linear.a, 1.0F))};
}

glm::vec4 pixel_at(const Raster<glm::u8vec4>& level, int column, int row) {
  if (column < 0 || row < 0 || column >= level.width_px() || row >= level.height_px())
    return glm::vec4(0);
  return linear_of(level.at(column, row));
}

Raster<glm::u8vec4> half_of(const Raster<glm::u8vec4>& whole) {
  Raster<glm::u8vec4> half((whole.width_px() + 1) / 2, (whole.height_px() + 1) / 2);
  for (int row = 0; row < half.height_px(); ++row) {
    for (int column = 0; column < half.width_px(); ++column) {
      const glm::vec4 sum =
          pixel_at(whole, 2 * column, 2 * row) + pixel_at(whole, 2 * column + 1, 2 * row) +
          pixel_at(whole, 2 * column, 2 * row + 1) + pixel_at(whole, 2 * column + 1, 2 * row + 1);
      half.at(column, row) = stored(sum / 4.0F);
    }
  }
  return half;
}

// The axes of the ellipse that a circle becomes, the longer first.
struct Axes {
  glm::dvec2 longer;
  double shorter_px;
};

Axes axes_of(const glm::dmat2& sides_px) {
  const glm::dmat2 square = sides_px * glm::transpose(sides_px);
  const double mean = (square[0][0] + square[1][1]) / 2;
  const double half_gap = (square[0][0] - square[1][1]) / 2;
  const double off = square[1][0];
  const double spread = std::hypot(half_gap, off);
  const double angle = std::atan2(off, half_gap) / 2;
  return {std::sqrt(mean + spread) * glm::dvec2(std::cos(angle), std::sin(angle)),
          std::sqrt(std::max(0.0, mean - spread))};
}

}  // namespace

PicturePyramid::PicturePyramid(Raster<glm::u8vec4> picture) {
  levels_.push_back(std::move(picture));
  while (levels_.back().width_px() > 1 || levels_.back().height_px() > 1)
    levels_.push_back(half_of(levels_.back()));
}

glm::vec4 PicturePyramid::bilinear(std::size_t level, glm::dvec2 place_px) const {
  const Raster<glm::u8vec4>& pixels = levels_[level];
  const glm::dvec2 centred = place_px / std::exp2(static_cast<double>(level)) - 0.5;
  const glm::dvec2 size(pixels.width_px(), pixels.height_px());
  // Not a number is beyond as well.
  if (!(centred.x > -1 && centred.y > -1 && centred.x < size.x && centred.y < size.y))
    return glm::vec4(0);
  const glm::dvec2 first = glm::floor(centred);
  const glm::vec2 share(centred - first);
  const glm::ivec2 at(first);
  const glm::vec4 upper =
      glm::mix(pixel_at(pixels, at.x, at.y), pixel_at(pixels, at.x + 1, at.y), share.x);
  const glm::vec4 lower =
      glm::mix(pixel_at(pixels, at.x, at.y + 1), pixel_at(pixels, at.x + 1, at.y + 1), share.x);
  return glm::mix(upper, lower, share.y);
}

glm::vec4 PicturePyramid::at(glm::dvec2 place_px, double level) const {
  const double last = static_cast<double>(levels_.size() - 1);
  const double within = std::clamp(level, 0.0, last);
  const auto finer = static_cast<std::size_t>(within);
  const glm::vec4 color = bilinear(finer, place_px);
  const double share = within - static_cast<double>(finer);
  if (share == 0) return color;
  return glm::mix(color, bilinear(finer + 1, place_px), static_cast<float>(share));
}

glm::vec4 PicturePyramid::mean(glm::dvec2 place_px, const glm::dmat2& sides_px) const {
  const Axes axes = axes_of(sides_px);
  const double longer_px = glm::length(axes.longer);
  if (!(longer_px > 1)) return at(place_px, 0);
  const double width_px = std::max({1.0, axes.shorter_px, longer_px / kMostPlaces});
  const int places = std::clamp(static_cast<int>(std::ceil(longer_px / width_px)), 1, kMostPlaces);
  glm::vec4 sum(0);
  for (int i = 0; i < places; ++i)
    sum += at(place_px + ((i + 0.5) / places - 0.5) * axes.longer, std::log2(width_px));
  return sum / static_cast<float>(places);
}

}  // namespace terrview
