#include "render/refine.h"

#include <algorithm>
#include <array>
#include <optional>

#include <glm/common.hpp>

#include "render/contrast.h"
#include "render/parallel.h"

namespace terrview {
namespace {

// The corners about a pixel of the lattice of blocks of `block_px`; those beyond the picture's last
// are the last.
struct Corners {
  glm::ivec2 low;
  glm::ivec2 high;

  Corners(glm::ivec2 pixel, int block_px, glm::ivec2 size) {
    const glm::ivec2 last = (size - 1) / block_px * block_px;
    low = pixel / block_px * block_px;
    high = glm::min((pixel + block_px - 1) / block_px * block_px, last);
  }

  [[nodiscard]] std::array<glm::ivec2, 4> all() const {
    return {low, glm::ivec2(high.x, low.y), glm::ivec2(low.x, high.y), high};
  }
};

glm::ivec2 size_of(const Raster<Sample>& base) { return {base.width_px(), base.height_px()}; }

// Whether two traced corners about a pixel differ.
bool corners_differ(const Raster<Sample>& base, const Corners& corners, float contrast) {
  const auto all = corners.all();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Sample& a = base.at(all[i].x, all[i].y);
    for (std::size_t j = 0; j < i && a.traced(); ++j) {
      const Sample& b = base.at(all[j].x, all[j].y);
      if (b.traced() && (depth_steps(a, b) ||
                         contrast_between(seen_color(a.color), seen_color(b.color)) > contrast))
        return true;
    }
  }
  return false;
}

// Between the corners about `pixel`, if all are traced.
std::optional<glm::vec3> mixed(const Raster<Sample>& base, glm::ivec2 pixel, int block_px) {
  const Corners corners(pixel, block_px, size_of(base));
  for (const glm::ivec2& corner : corners.all()) {
    if (!base.at(corner.x, corner.y).traced()) return std::nullopt;
  }
  const glm::vec2 share = glm::clamp(glm::vec2(pixel - corners.low) / static_cast<float>(block_px),
                                     glm::vec2(0), glm::vec2(1));
  const auto color = [&](int column, int row) { return base.at(column, row).color; };
  const auto [low, high] = corners;
  return glm::mix(glm::mix(color(low.x, low.y), color(high.x, low.y), share.x),
                  glm::mix(color(low.x, high.y), color(high.x, high.y), share.x), share.y);
}

}  // namespace

void refine(Sampler& sampler, int block_px, float contrast, Raster<Sample>& base,
            const Sampler::Take& take) {
  const bool first = block_px == kFirstBlock_px;
  const auto wanted = [&](glm::ivec2 pixel) {
    return first || (!base.at(pixel.x, pixel.y).traced() &&
                     corners_differ(base, Corners(pixel, 2 * block_px, size_of(base)), contrast));
  };
  // Decided before any is traced, so that the order in which threads trace does not matter.
  Raster<char> is_wanted(base.width_px(), base.height_px(), 0);
  parallel_for((base.height_px() + block_px - 1) / block_px, sampler.threads(), [&](int index) {
    const int row = index * block_px;
    for (int column = 0; column < base.width_px(); column += block_px)
      is_wanted.at(column, row) = wanted({column, row}) ? 1 : 0;
  });
  sampler.trace_lattice(
      0, block_px, [&](glm::ivec2 pixel) { return is_wanted.at(pixel.x, pixel.y) != 0; }, take);
}

Image mixed_blocks(const Raster<Sample>& base, int threads) {
  Image image(base.width_px(), base.height_px());
  parallel_for(base.height_px(), threads, [&](int row) {
    for (int column = 0; column < base.width_px(); ++column) {
      const Sample& sample = base.at(column, row);
      std::optional<glm::vec3> color;
      if (sample.traced()) color = sample.color;
      for (int block_px = 2; !color && block_px <= kFirstBlock_px; block_px *= 2)
        color = mixed(base, {column, row}, block_px);
      image.at(column, row) = color.value_or(sample.color);
    }
  });
  return image;
}

}  // namespace terrview
