#include "render/render.h"

#include <cstdint>
#include <utility>

#include "render/antialias.h"
#include "render/haze.h"
#include "render/parallel.h"
#include "render/picture_margin.h"
#include "render/refine.h"
#include "render/sampling.h"
#include "render/shadows.h"

namespace terrview {
namespace {

// A picture in the making: the rays through the pixels' centres first, then what is made of them.
class Picture {
 public:
  Picture(const Scene& scene, const Camera& camera, const RenderOptions& options)
      : options_(options),
        size_(camera.options().size_px),
        sampler_(scene, camera, options),
        base_(size_.x, size_.y),
        haze_(scene.air, base_),
        hazy_(scene.air.haze_px_per_m > 0 && !options.preview) {
    if (options.keep_samples) frame_.samples = Raster<PixelSample>(size_.x, size_.y);
  }

  Frame render() {
    if (options_.preview || options_.improved) trace_blocks();
    if (options_.preview) return finish(mixed_blocks(base_, options_.threads));
    trace_centres();
    if (options_.improved) options_.improved(centres());
    Image image = centres();
    const Resolve resolve = [this](glm::ivec2 pixel, const Sample& sample) {
      return hazy_ ? haze_.blurred(pixel, sample) : sample.color;
    };
    if (options_.samples == 0) {
      sampler_.set_progress(kCentres, 1);
      antialias(sampler_, options_.contrast, base_, resolve, image);
    } else if (options_.samples > 1) {
      supersample(sampler_, options_.samples, base_, resolve, image);
    }
    return finish(std::move(image));
  }

 private:
  // The share of the work that the centres are thought to be, where pixels take what they need.
  static constexpr double kCentres = 0.5;

  [[nodiscard]] double centres_share() const {
    return options_.samples == 0 ? kCentres : 1.0 / options_.samples;
  }

  void keep(glm::ivec2 pixel, const ShadedRay& shaded, const Seen& seen) {
    base_.at(pixel.x, pixel.y) = {shaded.color, shaded.distance_m};
    if (!frame_.samples.empty()) keep_layers(pixel, shaded, seen);
  }

  void keep_layers(glm::ivec2 pixel, const ShadedRay& shaded, const Seen& seen) {
    PixelSample& sample = frame_.samples.at(pixel.x, pixel.y);
    sample.clear = shaded.clear;
    sample.air = shaded.air;
    sample.transmission = shaded.transmission;
    if (seen.id == PixelSample::kNothing) return;
    sample.position_m = seen.position_m;
    sample.normal = shaded.normal;
    sample.object_id = seen.id;
  }

  // Coarse blocks, and finer ones where they differ.
  void trace_blocks() {
    for (int block_px = kFirstBlock_px; block_px >= 1; block_px /= 2) {
      sampler_.set_progress(0, options_.preview ? 1.0 / block_px : 0);
      refine(sampler_, block_px, options_.contrast, base_,
             [&](glm::ivec2 pixel, const ShadedRay& shaded, const Seen& seen) {
               keep(pixel, shaded, seen);
             });
      if (options_.improved) options_.improved(mixed_blocks(base_, options_.threads));
    }
  }

  // What is left of the pixels' centres, but for those that haze fills.
  void trace_centres() {
    const bool sparse = hazy_ && options_.sparse_haze;
    if (sparse) {
      sampler_.set_progress(0, centres_share() / 4);
      trace_untraced(2);
      choose_filled();
    }
    sampler_.set_progress(sparse ? centres_share() / 4 : 0, centres_share());
    trace_untraced(1);
    drop_filled();
  }

  void trace_untraced(int step) {
    const bool layers = !frame_.samples.empty();
    sampler_.trace_lattice(
        0, step,
        [&](glm::ivec2 pixel) {
          return !base_.at(pixel.x, pixel.y).traced() && (layers || !is_filled(pixel));
        },
        [&](glm::ivec2 pixel, const ShadedRay& shaded, const Seen& seen) {
          keep(pixel, shaded, seen);
        });
  }

  void choose_filled() {
    filled_ = Raster<char>(size_.x, size_.y, 0);
    for_each_pixel(
        [&](glm::ivec2 pixel) { filled_.at(pixel.x, pixel.y) = haze_.fills(pixel) ? 1 : 0; });
  }

  // Pixels that were traced for a block or a layer are filled all the same.
  void drop_filled() {
    if (filled_.empty()) return;
    for_each_pixel([&](glm::ivec2 pixel) {
      if (is_filled(pixel)) base_.at(pixel.x, pixel.y) = Sample{};
    });
  }

  [[nodiscard]] bool is_filled(glm::ivec2 pixel) const {
    return !filled_.empty() && filled_.at(pixel.x, pixel.y) != 0;
  }

  // The picture of one ray a pixel.
  [[nodiscard]] Image centres() const {
    Image image(size_.x, size_.y);
    for_each_pixel([&](glm::ivec2 pixel) {
      const Sample& sample = base_.at(pixel.x, pixel.y);
      image.at(pixel.x, pixel.y) = is_filled(pixel) ? haze_.filled(pixel)
                                   : hazy_          ? haze_.blurred(pixel, sample)
                                                    : sample.color;
    });
    return image;
  }

  template <class Work>
  void for_each_pixel(const Work& work) const {
    parallel_for(size_.y, options_.threads, [&](int row) {
      for (int column = 0; column < size_.x; ++column) work(glm::ivec2(column, row));
    });
  }

  Frame finish(Image image) {
    frame_.image = std::move(image);
    frame_.counts = sampler_.total;
    if (options_.improved) options_.improved(frame_.image);
    if (options_.progress) options_.progress(1);
    return std::move(frame_);
  }

  const RenderOptions& options_;
  glm::ivec2 size_;
  Sampler sampler_;
  Raster<Sample> base_;
  Haze haze_;
  bool hazy_;
  Raster<char> filled_;
  Frame frame_;
};

// The part of an image that the one with a margin was made for.
template <class Pixel>
Raster<Pixel> without_margin(const Raster<Pixel>& image, const PixelRect& margin,
                             glm::ivec2 size_px) {
  if (image.empty()) return {};
  Raster<Pixel> part(size_px.x, size_px.y);
  for (int row = 0; row < size_px.y; ++row) {
    for (int column = 0; column < size_px.x; ++column)
      part.at(column, row) = image.at(column - margin.first_px.x, row - margin.first_px.y);
  }
  return part;
}

PixelRect margin_of(const Scene& scene, const Camera& camera, const RenderOptions& options) {
  const PixelRect alone{{0, 0}, camera.options().size_px};
  if (camera.circle_px() == 0 && camera.whole_px() == alone.size_px) return alone;
  const bool blurs = scene.air.haze_px_per_m > 0;
  const bool compares = options.samples == 0 || options.preview;
  if (!blurs && !compares) return alone;
  return with_margin(camera, blurs ? Haze::kReach_px : kAntialiasReach_px, kFirstBlock_px);
}

}  // namespace

RenderCounts& RenderCounts::operator+=(const RenderCounts& other) {
  rays += other.rays;
  hits += other.hits;
  tests += other.tests;
  nodes += other.nodes;
  shadow_rays += other.shadow_rays;
  objects += other.objects;
  shadow_objects += other.shadow_objects;
  trace_s += other.trace_s;
  shade_s += other.shade_s;
  return *this;
}

Frame render(const Scene& scene, const Camera& camera, const RenderOptions& options) {
  const PixelRect margin = margin_of(scene, camera, options);
  const glm::ivec2 size_px = camera.options().size_px;
  const Scene lit = with_sun_map(scene, camera, options.threads);
  if (margin == PixelRect{{0, 0}, size_px}) return Picture(lit, camera, options).render();
  const Camera wider = camera.part(margin);
  RenderOptions for_wider = options;
  if (options.improved)
    for_wider.improved = [&](const Image& image) {
      options.improved(without_margin(image, margin, size_px));
    };
  Frame frame = Picture(lit, wider, for_wider).render();
  frame.image = without_margin(frame.image, margin, size_px);
  frame.samples = without_margin(frame.samples, margin, size_px);
  return frame;
}

}  // namespace terrview
