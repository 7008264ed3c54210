// Pictures to files, through OpenImageIO.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "render/image.h"

namespace terrview {

struct ImageFileOptions {
  std::string
      format;  // png, jpg, tif, exr, webp, ppm, or GDAL's name for one; empty = by extension
  std::map<std::string, std::string> creation;  // GDAL's names: QUALITY, ZLEVEL, COMPRESS
  std::map<std::string, std::string> metadata;  // text kept where the format keeps any
};

// Throws InputError if no picture can be written to `path`: unknown extension or option. Called
// before the work, it spares the user a lost picture.
void check_image_file(const std::string& path, const ImageFileOptions& options);

// Writes 8-bit sRGB, or linear floats for EXR. `path` is the name written to; the extension that
// decides is that of `options.format` or of `path`. Throws InputError if it can't be written.
void write_image(const std::string& path, const Image& image, const ImageFileOptions& options);

// A named plane of floats, row by row.
struct FloatChannel {
  std::string name;
  std::vector<float> values;
};

// Writes float channels of equal size as EXR.
void write_exr(const std::string& path, int width_px, int height_px,
               const std::vector<FloatChannel>& channels,
               const std::map<std::string, std::string>& metadata);

}  // namespace terrview
