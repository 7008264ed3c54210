#include <utility>

#include "bench/quantize/quantize_contender.h"
#include "quantize/color_tree.h"
#include "quantize/quantizer.h"
#include "quantize/rewriter.h"

namespace terrview {
namespace {

class TerrviewJob : public QuantizeJob {
 public:
  TerrviewJob(const Picture& picture, const QuantizeOptions& options)
      : picture_(picture), options_(options) {
    rewritten_.indices.resize(picture.pixels.size());
  }

  void run() override {
    ColorCounts counts;
    counts.add(picture_.pixels);
    const Quantizer quantizer = make_quantizer(counts, options_);
    Rewriter rewriter(quantizer.palette, quantizer.find, Dither::none, picture_.width_px);
    const auto width = static_cast<std::size_t>(picture_.width_px);
    for (std::size_t at = 0; at < picture_.pixels.size(); at += width)
      rewriter.rewrite(std::span(picture_.pixels).subspan(at, width), {}, 0,
                       std::span(rewritten_.indices).subspan(at, width));
    rewritten_.palette = quantizer.palette;
  }

  [[nodiscard]] Rewritten result() override { return rewritten_; }

 private:
  const Picture& picture_;
  QuantizeOptions options_;
  Rewritten rewritten_;
};

// The thesis's three phases, pixel by pixel: its only short cut is to skip a pixel that is like the
// one before.
class ThesisJob : public QuantizeJob {
 public:
  ThesisJob(const Picture& picture, int colors) : picture_(picture), colors_(colors) {
    rewritten_.indices.resize(picture.pixels.size());
  }

  void run() override {
    const std::vector<Rgb8>& pixels = picture_.pixels;
    ColorTree tree(colors_);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      if (i == 0 || pixels[i] != pixels[i - 1]) tree.insert(pixels[i]);
    rewritten_.palette = tree.number_leaves();
    std::vector<std::uint16_t>& indices = rewritten_.indices;
    for (std::size_t i = 0; i < pixels.size(); ++i)
      indices[i] = i > 0 && pixels[i] == pixels[i - 1]
                       ? indices[i - 1]
                       : static_cast<std::uint16_t>(tree.address(pixels[i]));
  }

  [[nodiscard]] Rewritten result() override { return rewritten_; }

 private:
  const Picture& picture_;
  int colors_;
  Rewritten rewritten_;
};

QuantizeContender contender(std::string name, const QuantizeOptions& options) {
  return {std::move(name), kMaxPaletteColors, [options](const Picture& picture, int colors) {
            QuantizeOptions with_colors = options;
            with_colors.colors = colors;
            return std::make_unique<TerrviewJob>(picture, with_colors);
          }};
}

}  // namespace

std::vector<QuantizeContender> terrview_quantizers() {
  using enum PaletteMethod;
  const auto by_pixel = [](const Picture& picture, int colors) {
    return std::make_unique<ThesisJob>(picture, colors);
  };
  return {{"thesis-by-pixel", kMaxPaletteColors, by_pixel},
          contender("thesis", {.method = thesis}),
          contender("tree-preorder", {.method = tree, .order = TreeOrder::preorder}),
          contender("tree-population", {.method = tree, .order = TreeOrder::population}),
          contender("tree", {.method = tree}),
          contender("tree-rgb", {.method = tree, .match = Match::rgb}),
          contender("tree-oklab", {.method = tree, .match = Match::oklab}),
          contender("fixed", {.method = fixed}),
          contender("popularity", {.method = popularity}),
          contender("median-cut", {.method = median_cut}),
          contender("variance-cut", {.method = variance_cut})};
}

}  // namespace terrview
