#include "render/antialias.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>

#include "render/contrast.h"
#include "render/parallel.h"

namespace terrview {
namespace {

constexpr int kFew = 4;
constexpr int kMany = 16;
constexpr int kPixelsAtOnce = 64;
constexpr int kRowsAtOnce = 32;

enum class Need { few, many };

struct NeedyPixel {
  glm::ivec2 pixel;
  Need need;
};

// Traced pixels that need more than one ray, by their eight neighbours: at an outline, many rays;
// few may miss it.
std::vector<NeedyPixel> needy_pixels(const Raster<Sample>& base, float contrast, int threads) {
  const int strips = (base.height_px() + kRowsAtOnce - 1) / kRowsAtOnce;
  std::vector<std::vector<NeedyPixel>> found(static_cast<std::size_t>(strips));
  parallel_for(strips, threads, [&](int strip) {
    const int first = strip * kRowsAtOnce;
    const int end = std::min(first + kRowsAtOnce, base.height_px());
    const SeenRows seen(base, first, end - first);
    const auto width = static_cast<std::size_t>(base.width_px());
    std::vector<float> contrasts(width);
    std::vector<std::int32_t> steps(width);
    for (int row = first; row < end; ++row) {
      seen.compare(row, contrasts, steps);
      for (std::size_t i = 0; i < width; ++i) {
        if (steps[i] == 0 && !(contrasts[i] > contrast)) continue;
        const glm::ivec2 pixel(static_cast<int>(i), row);
        if (base.at(pixel.x, pixel.y).traced())
          found[static_cast<std::size_t>(strip)].push_back(
              {pixel, steps[i] != 0 ? Need::many : Need::few});
      }
    }
  });
  std::vector<NeedyPixel> pixels;
  for (const auto& strip : found) pixels.insert(pixels.end(), strip.begin(), strip.end());
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
