// Pictures to files, through OpenImageIO.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "render/image.h"

namespace terrview {

struct ImageFileOptions {
  // png, jpg, tif, exr, webp, ppm, or GDAL's name for one; empty = by extension.
  std::string format = {};
  std::map<std::string, std::string> creation = {};  // GDAL's names: QUALITY, ZLEVEL, COMPRESS
  // Text kept where the format keeps any: under its name in png and exr, as the image description
  // in tif and jpg.
  std::map<std::string, std::string> metadata = {};
  double dpi = 0;  // pixels per inch on paper, kept by png, jpg and tif; 0 = not known
};

// Throws InputError if no picture can be written to `path`: unknown extension or option, or too
// large for the format. Called before the work, it spares the user a lost picture.
void check_image_file(const std::string& path, glm::ivec2 size_px, const ImageFileOptions& options);

// Writes 8-bit sRGB, or linear floats for EXR; the same bytes for the same picture. The format is
// that of `options.format` or of the extension of `path`. Throws what check_image_file() throws,
// and std::runtime_error with the reason, but not the path, if writing fails.
void write_image(const std::string& path, const Image& image, const ImageFileOptions& options);

// The bytes of a JPEG file; `quality` from 1 to 100. Throws as write_image() does.
[[nodiscard]] std::string encode_jpeg(const Image& image, int quality);

// A named plane of floats, row by row.
struct FloatChannel {
  std::string name;
  std::vector<float> values;
};

// Writes float channels of equal size as EXR. Throws as write_image() does.
void write_exr(const std::string& path, glm::ivec2 size_px,
               const std::vector<FloatChannel>& channels,
               const std::map<std::string, std::string>& metadata);

}  // namespace terrview
