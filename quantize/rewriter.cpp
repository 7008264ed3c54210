#include "quantize/rewriter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "quantize/nearest_color.h"

namespace terrview {
namespace {

constexpr int kTile = 8;

// 0 to 63, each once.
constexpr std::array<std::array<int, kTile>, kTile> bayer_tile() {
  std::array<std::array<int, kTile>, kTile> tile{};
  for (int size = 1; size < kTile; size *= 2) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const auto r = static_cast<std::size_t>(row);
        const auto c = static_cast<std::size_t>(column);
        const auto s = static_cast<std::size_t>(size);
        const int base = 4 * tile[r][c];
        tile[r][c] = base;
        tile[r + s][c + s] = base + 1;
        tile[r][c + s] = base + 2;
        tile[r + s][c] = base + 3;
      }
    }
  }
  return tile;
}

constexpr auto kBayerTile = bayer_tile();

Rgb8 clamped(const glm::ivec3& color) { return Rgb8(glm::clamp(color, 0, 255)); }

// Thresholds shift all three components alike: a shift by this is as long as the palette's colours
// are, in the mean, away from their nearest neighbours.
double spread_of(const Palette& palette) {
  const NearestColor nearest(palette, ColorDifference::rgb);
  double sum = 0;
  for (std::uint32_t i = 0; i < palette.size(); ++i)
    sum += glm::distance(glm::dvec3(palette[i]), glm::dvec3(palette[nearest.nearest_other(i)]));
  return sum / (std::sqrt(3.0) * static_cast<double>(palette.size()));
}

}  // namespace

Rewriter::Rewriter(Palette palette, ColorMap::Find find, Dither dither, int width_px)
    : palette_(std::move(palette)), map_(std::move(find)), dither_(dither) {
  if (dither_ == Dither::ordered) spread_ = spread_of(palette_);
  if (dither_ != Dither::diffusion) return;
  errors_.assign(static_cast<std::size_t>(width_px) + 2, Error(0));
  next_errors_ = errors_;
}

void Rewriter::rewrite(std::span<const Rgb8> colors, std::span<const std::uint8_t> valid,
                       std::uint16_t nodata, std::span<std::uint16_t> indices) {
  assert(indices.size() == colors.size());
  switch (dither_) {
    case Dither::none:
      map(colors, indices);
      break;
    case Dither::diffusion:
      diffuse(colors, valid, indices);
      break;
    case Dither::ordered:
      order(colors, indices);
      break;
  }
  for (std::size_t i = 0; i < valid.size(); ++i)
    if (valid[i] == 0) indices[i] = nodata;
  ++line_;
}

void Rewriter::map(std::span<const Rgb8> colors, std::span<std::uint16_t> indices) {
  for (std::size_t i = 0; i < colors.size(); ++i) indices[i] = map_.address(colors[i]);
}

void Rewriter::diffuse(std::span<const Rgb8> colors, std::span<const std::uint8_t> valid,
                       std::span<std::uint16_t> indices) {
  assert(colors.size() + 2 == errors_.size());
  const bool backwards = line_ % 2 != 0;
  std::fill(next_errors_.begin(), next_errors_.end(), Error(0));
  for (std::size_t step = 0; step < colors.size(); ++step) {
    const std::size_t i = backwards ? colors.size() - 1 - step : step;
    if (!valid.empty() && valid[i] == 0) continue;
    const std::size_t here = i + 1;
    const std::size_t ahead = backwards ? here - 1 : here + 1;
    const std::size_t behind = backwards ? here + 1 : here - 1;
    // Shifted so that halves round upwards whatever the sign.
    const Rgb8 wanted = clamped(glm::ivec3(colors[i]) + ((errors_[here] + 8) >> 4));
    indices[i] = map_.address(wanted);
    const Error error = glm::ivec3(wanted) - glm::ivec3(palette_[indices[i]]);
    errors_[ahead] += 7 * error;
    next_errors_[behind] += 3 * error;
    next_errors_[here] += 5 * error;
    next_errors_[ahead] += error;
  }
  std::swap(errors_, next_errors_);
}

void Rewriter::order(std::span<const Rgb8> colors, std::span<std::uint16_t> indices) {
  const auto& thresholds = kBayerTile[static_cast<std::size_t>(line_ % kTile)];
  std::array<int, kTile> shifts{};
  for (std::size_t i = 0; i < shifts.size(); ++i)
    shifts[i] = static_cast<int>(std::lround(spread_ * ((thresholds[i] + 0.5) / 64 - 0.5)));
  for (std::size_t i = 0; i < colors.size(); ++i)
    indices[i] = map_.address(clamped(glm::ivec3(colors[i]) + shifts[i % kTile]));
}

}  // namespace terrview
