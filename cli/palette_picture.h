// Rendered pictures with a palette.
#pragma once

#include <string>

#include "cli/quantize_options.h"
#include "ingest/indexed_file.h"
#include "render/image.h"

namespace terrview {

// Writes `image` as 8-bit sRGB with the palette that the options ask for, and returns that. Throws
// InputError for a palette file, and std::runtime_error with the reason, but not the path.
Palette write_palette_image(const std::string& path, const Image& image,
                            const PaletteOptions& palette, const IndexedFileOptions& file);

// Adds the pixels of `image` as they would be written.
void count_colors(const Image& image, ColorCounts& counts);

}  // namespace terrview
