#include "render/antialias.h"

#include <algorithm>
#include <atomic>
#include <vector>

#include <glm/common.hpp>

#include "render/contrast.h"
#include "render/parallel.h"

namespace terrview {
namespace {

constexpr int kFew = 4;
constexpr int kMany = 16;
constexpr int kPixelsAtOnce = 64;

enum class Need { one, few, many };

// What a traced pixel needs, by its eight neighbours: at an outline, many rays; few may miss it.
Need need_of(const Raster<Sample>& base, const Image& seen, glm::ivec2 pixel, float contrast) {
  const Sample& here = base.at(pixel.x, pixel.y);
  Need need = Need::one;
  for (int row = std::max(0, pixel.y - 1); row <= std::min(base.height_px() - 1, pixel.y + 1);
       ++row) {
    for (int column = std::max(0, pixel.x - 1);
         column <= std::min(base.width_px() - 1, pixel.x + 1); ++column) {
      const Sample& other = base.at(column, row);
      if (!other.traced()) continue;
      if (depth_steps(here, other)) return Need::many;
      // The sky is smooth within a pixel.
      if (!here.ground() && !other.ground()) continue;
      if (contrast_between(seen.at(pixel.x, pixel.y), seen.at(column, row)) > contrast)
        need = Need::few;
    }
  }
  return need;
}

struct NeedyPixel {
  glm::ivec2 pixel;
  Need need;
};

std::vector<NeedyPixel> needy_pixels(const Raster<Sample>& base, float contrast, int threads) {
  const Image seen = seen_colors(base, threads);
  std::vector<std::vector<NeedyPixel>> rows(static_cast<std::size_t>(base.height_px()));
  parallel_for(base.height_px(), threads, [&](int row) {
    for (int column = 0; column < base.width_px(); ++column) {
      if (!base.at(column, row).traced()) continue;
      const Need need = need_of(base, seen, {column, row}, contrast);
      if (need != Need::one) rows[static_cast<std::size_t>(row)].push_back({{column, row}, need});
    }
  });
  std::vector<NeedyPixel> pixels;
  for (const auto& row : rows) pixels.insert(pixels.end(), row.begin(), row.end());
  return pixels;
}

// The samples of one pixel.
struct PixelRays {
  glm::ivec2 pixel;
  std::vector<Sample> samples;

  [[nodiscard]] bool differ(float contrast) const {
    glm::vec3 low(2);
    glm::vec3 high(-1);
    for (const Sample& sample : samples) {
      const glm::vec3 seen = seen_color(sample.color);
      low = glm::min(low, seen);
      high = glm::max(high, seen);
    }
    return contrast_between(low, high) > contrast;
  }

  [[nodiscard]] glm::vec3 mean(const Resolve& resolve) const {
    glm::vec3 sum(0);
    for (const Sample& sample : samples) sum += resolve(pixel, sample);
    return sum / static_cast<float>(samples.size());
  }
};

// Brings the samples of each pixel to `count`, all rays together.
void add_rays(const Sampler& sampler, std::span<PixelRays*> pixels, int count,
              RenderCounts& counts) {
  std::vector<glm::dvec2> points_px;
  for (const PixelRays* pixel : pixels) {
    for (int i = static_cast<int>(pixel->samples.size()); i < count; ++i)
      points_px.push_back(glm::dvec2(pixel->pixel) + sample_offset(i));
  }
  const std::vector<Sample> samples = sampler.trace_points(points_px, counts);
  auto next = samples.begin();
  for (PixelRays* pixel : pixels) {
    while (static_cast<int>(pixel->samples.size()) < count) pixel->samples.push_back(*next++);
  }
}

// Pixels that one thread takes at a time.
std::vector<PixelRays> refined(const Sampler& sampler, std::span<const NeedyPixel> pixels,
                               float contrast, const Raster<Sample>& base, RenderCounts& counts) {
  std::vector<PixelRays> rays;
  for (const auto& [pixel, need] : pixels) rays.push_back({pixel, {base.at(pixel.x, pixel.y)}});
  std::vector<PixelRays*> few;
  for (PixelRays& pixel : rays) few.push_back(&pixel);
  add_rays(sampler, few, kFew, counts);
  std::vector<PixelRays*> many;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (pixels[i].need == Need::many || rays[i].differ(contrast)) many.push_back(&rays[i]);
  }
  add_rays(sampler, many, kMany, counts);
  return rays;
}

}  // namespace

void antialias(Sampler& sampler, float contrast, const Raster<Sample>& base, const Resolve& resolve,
               Image& image) {
  const std::vector<NeedyPixel> pixels = needy_pixels(base, contrast, sampler.threads());
  const std::size_t groups = (pixels.size() + kPixelsAtOnce - 1) / kPixelsAtOnce;
  std::vector<RenderCounts> counts(groups);
  std::atomic<int> done{0};
  parallel_for(static_cast<int>(groups), sampler.threads(), [&](int index) {
    const auto group = static_cast<std::size_t>(index);
    const std::size_t first = group * kPixelsAtOnce;
    const std::size_t count = std::min<std::size_t>(kPixelsAtOnce, pixels.size() - first);
    for (const PixelRays& rays :
         refined(sampler, std::span(pixels).subspan(first, count), contrast, base, counts[group]))
      image.at(rays.pixel.x, rays.pixel.y) = rays.mean(resolve);
    sampler.report(static_cast<double>(++done) / static_cast<double>(groups));
  });
  for (const RenderCounts& group : counts) sampler.total += group;
}

void supersample(Sampler& sampler, int samples, const Raster<Sample>& base, const Resolve& resolve,
                 Image& image) {
  const auto is_traced = [&](glm::ivec2 pixel) { return base.at(pixel.x, pixel.y).traced(); };
  for (int index = 1; index < samples; ++index) {
    sampler.set_progress(static_cast<double>(index) / samples,
                         static_cast<double>(index + 1) / samples);
    sampler.trace_lattice(
        index, 1, is_traced, [&](glm::ivec2 pixel, const ShadedRay& shaded, const Seen&) {
          image.at(pixel.x, pixel.y) += resolve(pixel, {shaded.color, shaded.distance_m});
        });
  }
  for (int row = 0; row < image.height_px(); ++row) {
    for (int column = 0; column < image.width_px(); ++column)
      if (is_traced({column, row})) image.at(column, row) /= static_cast<float>(samples);
  }
}

}  // namespace terrview
