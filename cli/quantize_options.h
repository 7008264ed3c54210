// The options that choose a palette: shared by the commands that write pictures with one.
#pragma once

#include <optional>
#include <string>

#include "quantize/quantizer.h"
#include "quantize/rewriter.h"

namespace terrview {

class CommandLine;

struct PaletteOptions {
  std::optional<int> colors;  // entries of the palette, nodata's included
  std::optional<PaletteMethod> method;
  std::optional<TreeOrder> order;
  std::optional<Match> match;
  Dither dither = Dither::none;
  std::string use_palette;   // a file to take the palette from
  std::string save_palette;  // a file to write it to
};

// Adds `colors_name` (the option of that number), --dither, --use-palette and --save-palette.
void add_palette_options(CommandLine& app, const std::string& colors_name, PaletteOptions& options);

// Adds --method, --order and --match.
void add_method_options(CommandLine& app, PaletteOptions& options);

// Whether a palette is asked for.
[[nodiscard]] bool wants_palette(const PaletteOptions& options);

// Throws InputError for options that contradict each other, for a palette's name, and for a damaged
// palette.
void check_palette_options(const PaletteOptions& options);

// Whether the pixels have to be counted first.
[[nodiscard]] bool needs_counts(const PaletteOptions& options);

// The palette for these pixels (black where there are none), or the one of the file. With
// `has_nodata` one entry is left free.
// Throws InputError for a palette that leaves none, or is damaged.
[[nodiscard]] Quantizer choose_palette(const ColorCounts& counts, const PaletteOptions& options,
                                       bool has_nodata);

}  // namespace terrview
