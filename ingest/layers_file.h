// Per-pixel data of a view as a GeoTIFF, through GDAL.
#pragma once

#include <string>
#include <vector>

namespace terrview {

// A named plane of doubles, row by row; NaN = nothing hit.
struct LayerBand {
  std::string name;
  std::vector<double> values;
};

// Writes Float64 bands with their names as descriptions and NaN as nodata. The picture is a
// perspective one, so the file carries no geotransform. Throws std::runtime_error with the reason,
// but not the path.
void write_layers(const std::string& path, int width_px, int height_px,
                  const std::vector<LayerBand>& bands, const std::string& camera_json);

}  // namespace terrview
