#include <libimagequant.h>

#include <stdexcept>

#include "bench/quantize/quantize_contender.h"

namespace terrview {
namespace {

constexpr int kMostColors = 256;
constexpr int kDefaultSpeed = 4;
constexpr int kFastestSpeed = 10;

template <class Type, void (*destroy)(Type*)>
using Owned = std::unique_ptr<Type, decltype([](Type* object) { destroy(object); })>;

void check(liq_error error) {
  if (error != LIQ_OK) throw std::runtime_error("libimagequant: error " + std::to_string(error));
}

class ImagequantJob : public QuantizeJob {
 public:
  ImagequantJob(const Picture& picture, int colors, int speed)
      : picture_(picture), colors_(colors), speed_(speed), indices_(picture.pixels.size()) {
    rgba_.reserve(4 * picture.pixels.size());
    for (const Rgb8 color : picture.pixels)
      rgba_.insert(rgba_.end(), {color.r, color.g, color.b, std::uint8_t{255}});
  }

  void run() override {
    attributes_.reset(liq_attr_create());
    check(liq_set_max_colors(attributes_.get(), colors_));
    check(liq_set_speed(attributes_.get(), speed_));
    image_.reset(liq_image_create_rgba(attributes_.get(), rgba_.data(), picture_.width_px,
                                       picture_.height_px, 0));
    liq_result* result = nullptr;
    check(liq_image_quantize(image_.get(), attributes_.get(), &result));
    result_.reset(result);
    check(liq_set_dithering_level(result, 0));
    check(liq_write_remapped_image(result, image_.get(), indices_.data(), indices_.size()));
  }

  [[nodiscard]] Rewritten result() override {
    Rewritten rewritten;
    const liq_palette& palette = *liq_get_palette(result_.get());
    for (unsigned i = 0; i < palette.count; ++i)
      rewritten.palette.emplace_back(palette.entries[i].r, palette.entries[i].g,
                                     palette.entries[i].b);
    rewritten.indices.assign(indices_.begin(), indices_.end());
    return rewritten;
  }

 private:
  const Picture& picture_;
  int colors_;
  int speed_;
  std::vector<std::uint8_t> rgba_;
  std::vector<std::uint8_t> indices_;
  Owned<liq_attr, liq_attr_destroy> attributes_;
  Owned<liq_image, liq_image_destroy> image_;
  Owned<liq_result, liq_result_destroy> result_;
};

QuantizeContender contender(const char* name, int speed) {
  return {name, kMostColors, [speed](const Picture& picture, int colors) {
            return std::make_unique<ImagequantJob>(picture, colors, speed);
          }};
}

}  // namespace

std::vector<QuantizeContender> imagequant_quantizers() {
  return {contender("libimagequant", kDefaultSpeed), contender("libimagequant-10", kFastestSpeed)};
}

}  // namespace terrview
