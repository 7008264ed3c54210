#include "quantize/quantizer.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "quantize/box_cut.h"
#include "quantize/color_tree.h"
#include "quantize/pruned_tree.h"
#include "quantize/simple_palettes.h"

namespace terrview {
namespace {

// What a ColorMap keeps must be copied, and a tree need not be.
template <class Tree>
Quantizer with_leaves(Palette palette, std::shared_ptr<const Tree> tree) {
  return {std::move(palette), [tree](Rgb8 color) { return tree->address(color); }};
}

Quantizer thesis_quantizer(const ColorCounts& counts, int colors) {
  auto tree = std::make_shared<ColorTree>(colors);
  counts.for_each(
      [&](std::uint32_t triplets, std::uint32_t) { tree->insert(color_of_triplets(triplets)); });
  Palette palette = tree->number_leaves();
  return with_leaves<ColorTree>(std::move(palette), tree);
}

// The thesis's leaves with the means of their pixels.
Quantizer preorder_quantizer(const ColorCounts& counts, int colors) {
  Quantizer quantizer = thesis_quantizer(counts, colors);
  std::vector<ColorSum> sums(quantizer.palette.size());
  counts.for_each([&](std::uint32_t triplets, std::uint32_t count) {
    const Rgb8 color = color_of_triplets(triplets);
    sums[quantizer.find(color)].add(color, count);
  });
  for (std::size_t i = 0; i < sums.size(); ++i) quantizer.palette[i] = sums[i].mean();
  return quantizer;
}

Quantizer pruned_quantizer(const ColorCounts& counts, int colors, DeletionOrder order) {
  const auto cells = static_cast<std::size_t>(std::clamp(16 * colors, 1 << 15, 1 << 18));
  auto tree = std::make_shared<PrunedTree>(gather_cells(counts, cells), colors, order);
  return with_leaves<PrunedTree>(tree->palette(), tree);
}

Quantizer tree_quantizer(const ColorCounts& counts, const QuantizeOptions& options) {
  switch (options.order) {
    case TreeOrder::preorder:
      return preorder_quantizer(counts, options.colors);
    case TreeOrder::population:
      return pruned_quantizer(counts, options.colors, DeletionOrder::population);
    case TreeOrder::error:
      break;
  }
  return pruned_quantizer(counts, options.colors, DeletionOrder::error);
}

Palette palette_without_tree(const ColorCounts& counts, const QuantizeOptions& options) {
  switch (options.method) {
    case PaletteMethod::popularity:
      return popular_colors(counts, options.colors);
    case PaletteMethod::median_cut:
      return cut_boxes(gather_cells(counts), options.colors, BoxCut::median);
    case PaletteMethod::variance_cut:
      return cut_boxes(gather_cells(counts), options.colors, BoxCut::variance);
    default:
      return fixed_palette(options.colors);
  }
}

ColorDifference difference_of(Match match) {
  switch (match) {
    case Match::oklab:
      return ColorDifference::oklab;
    case Match::ciede2000:
      return ColorDifference::ciede2000;
    default:
      return ColorDifference::rgb;
  }
}

}  // namespace

Quantizer make_quantizer(Palette palette, Match match) {
  const auto nearest = std::make_shared<const NearestColor>(palette, difference_of(match));
  return {std::move(palette), [nearest](Rgb8 color) { return nearest->find(color); }};
}

Quantizer make_quantizer(const ColorCounts& counts, const QuantizeOptions& options) {
  const bool has_tree =
      options.method == PaletteMethod::tree || options.method == PaletteMethod::thesis;
  if (!has_tree) return make_quantizer(palette_without_tree(counts, options), options.match);
  Quantizer quantizer = options.method == PaletteMethod::thesis
                            ? thesis_quantizer(counts, options.colors)
                            : tree_quantizer(counts, options);
  if (options.match == Match::leaf) return quantizer;
  return make_quantizer(std::move(quantizer.palette), options.match);
}

}  // namespace terrview
