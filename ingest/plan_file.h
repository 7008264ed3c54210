// Maps as pictures that lie where their ground does, through GDAL.
#pragma once

#include <map>
#include <string>

#include <glm/vec4.hpp>

#include "ingest/dem.h"
#include "render/image.h"

namespace terrview {

struct PlanPicture {
  Raster<glm::u8vec4> colors;  // sRGB and alpha, 0 or 255
  PostPlacement corners;       // of pixels: (0, 0) is the upper left corner of the first
  std::string crs_wkt;         // empty = none
};

struct PlanFileOptions {
  std::string format = {};  // tif, png or jpg, or GDAL's name, as COG; empty = by extension
  std::map<std::string, std::string> creation = {};  // GDAL's names and values
  std::map<std::string, std::string> metadata = {};  // as IndexedFileOptions
  bool always_alpha = false;                         // even where every pixel is covered
};

// The bytes of a picture and of what must lie beside it.
struct PlanFiles {
  std::string picture;
  std::string side;  // NAME.aux.xml: geotransform and CRS; empty for tif, which holds them
};

// Throws InputError if the format or a creation option is not known.
void check_plan_file(const std::string& path, const PlanFileOptions& options);

// Whether the format keeps its place beside the picture.
[[nodiscard]] bool needs_side_files(const std::string& path, const PlanFileOptions& options);

// Where every pixel is covered there is no alpha. jpg, which has none, is white where nothing is.
// Throws InputError as check_plan_file(), and std::runtime_error with GDAL's reason.
[[nodiscard]] PlanFiles encode_plan(const std::string& path, const PlanPicture& picture,
                                    const PlanFileOptions& options);

// The text of a world file: the centre of the first pixel and the steps to the next.
[[nodiscard]] std::string world_file(const PostPlacement& corners);

// NAME.pgw and the like, for a picture's name.
[[nodiscard]] std::string world_file_name(const std::string& path);

}  // namespace terrview
