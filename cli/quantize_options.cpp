#include "cli/quantize_options.h"

#include "cli/add_option.h"
#include "cli/palette_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr int kDefaultColors = 256;

int parse_colors(const std::string& name, const std::string& text) {
  const double colors = parse_number(name, text);
  if (colors != static_cast<int>(colors) || colors < 2 || colors > kMaxPaletteColors)
    throw InputError(name + " " + text + ": give a whole number from 2 to 65536");
  return static_cast<int>(colors);
}

// Leaves are those of the picture's own colours.
bool has_leaves(const PaletteOptions& options) {
  const PaletteMethod method = options.method.value_or(PaletteMethod::tree);
  return options.use_palette.empty() && options.dither == Dither::none &&
         (method == PaletteMethod::tree || method == PaletteMethod::thesis);
}

}  // namespace

void add_palette_options(CommandLine& app, const std::string& colors_name,
                         PaletteOptions& options) {
  app.add_option_function<std::string>(
         colors_name,
         [&options, colors_name](const std::string& text) {
           options.colors = parse_colors(colors_name, text);
         },
         "Colours of the picture, 2 to 65536, nodata included")
      ->type_name("N");
  add_choice<Dither>(
      app, "--dither", options.dither,
      {{"none", Dither::none}, {"diffusion", Dither::diffusion}, {"ordered", Dither::ordered}},
      "Mix colours that the palette lacks (default none)");
  app.add_option("--use-palette", options.use_palette, "Take the palette of this file")
      ->type_name("FILE");
  app.add_option("--save-palette", options.save_palette, "Write the palette: .gpl (GIMP) or .json")
      ->type_name("FILE");
}

void add_method_options(CommandLine& app, PaletteOptions& options) {
  add_choice<std::optional<PaletteMethod>>(app, "--method", options.method,
                                           {{"tree", PaletteMethod::tree},
                                            {"thesis", PaletteMethod::thesis},
                                            {"fixed", PaletteMethod::fixed},
                                            {"popularity", PaletteMethod::popularity},
                                            {"median-cut", PaletteMethod::median_cut},
                                            {"variance-cut", PaletteMethod::variance_cut}},
                                           "How the colours are chosen (default tree)");
  add_choice<std::optional<TreeOrder>>(app, "--order", options.order,
                                       {{"error", TreeOrder::error},
                                        {"population", TreeOrder::population},
                                        {"preorder", TreeOrder::preorder}},
                                       "The order in which the tree loses leaves (default error)");
  add_choice<std::optional<Match>>(app, "--match", options.match,
                                   {{"leaf", Match::leaf},
                                    {"rgb", Match::rgb},
                                    {"oklab", Match::oklab},
                                    {"ciede2000", Match::ciede2000}},
                                   "A pixel's colour: the tree's leaf, or the nearest (default "
                                   "leaf; without a tree and with dithering rgb)");
}

bool wants_palette(const PaletteOptions& options) {
  return options.colors || !options.use_palette.empty();
}

void check_palette_options(const PaletteOptions& options) {
  check_palette_name(options.save_palette);
  if (!options.use_palette.empty() && (options.colors || options.method || options.order))
    throw InputError("--use-palette " + options.use_palette +
                     ": the palette is given: leave out the number of colours, --method and "
                     "--order");
  if (options.order && options.method.value_or(PaletteMethod::tree) != PaletteMethod::tree)
    throw InputError("--order: belongs to --method tree: leave out one of them");
  if (options.match == Match::leaf && !has_leaves(options))
    throw InputError(
        "--match leaf: needs a tree of the picture's own colours: use rgb, oklab or ciede2000");
  if (!options.use_palette.empty()) static_cast<void>(read_palette(options.use_palette));
}

bool needs_counts(const PaletteOptions& options) {
  return options.use_palette.empty() && options.method != PaletteMethod::fixed;
}

Quantizer choose_palette(const ColorCounts& counts, const PaletteOptions& options,
                         bool has_nodata) {
  const Match match = options.match.value_or(has_leaves(options) ? Match::leaf : Match::rgb);
  if (!options.use_palette.empty()) {
    Palette palette = read_palette(options.use_palette);
    if (has_nodata && palette.size() == kMaxPaletteColors)
      throw InputError("--use-palette " + options.use_palette +
                       ": has 65536 colours and leaves none for nodata: use a smaller one");
    return make_quantizer(std::move(palette), match);
  }
  if (counts.empty() && needs_counts(options)) return make_quantizer(Palette{Rgb8(0)}, Match::rgb);
  const int colors = options.colors.value_or(kDefaultColors) - (has_nodata ? 1 : 0);
  return make_quantizer(counts, {.colors = colors,
                                 .method = options.method.value_or(PaletteMethod::tree),
                                 .order = options.order.value_or(TreeOrder::error),
                                 .match = match});
}

}  // namespace terrview
