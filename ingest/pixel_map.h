// Where a DEM's posts lie in a picture that has its own coordinate reference system.
#pragma once

#include <memory>
#include <string>

#include <glm/vec2.hpp>

#include "ingest/dem.h"
#include "render/drape.h"

namespace terrview {

struct PicturePlace {
  std::string name;       // as given by the user
  std::string crs_wkt;    // as split_crs() writes it; empty = none
  PostPlacement corners;  // of pixels: (0, 0) is the upper left corner of the first
  glm::ivec2 size_px{0, 0};
};

// Affine where the two share their CRS; else polynomials within kMapError_px of the operations of
// PROJ, which are not called again. Where a turn of longitude brings the DEM to the picture, it is
// taken. Throws InputError where only one has a CRS, or where PROJ knows no exact operation.
[[nodiscard]] std::shared_ptr<const PixelMap> map_to_picture(const Dem& dem,
                                                             const PicturePlace& picture);

inline constexpr double kMapError_px = 1e-3;

}  // namespace terrview
