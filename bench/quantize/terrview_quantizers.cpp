#include <utility>

#include "bench/quantize/quantize_contender.h"
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
  return {contender("thesis", {.method = thesis}),
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
