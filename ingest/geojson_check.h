// GeoJSON that is wrong somewhere, before GDAL reads around it.
#pragma once

#include <string>

namespace terrview {

// Throws InputError, naming the feature, if `path` holds a GeoJSON feature collection (or begins
// like JSON) that is cut off, is no JSON, nests deeper than 32, has a feature that is no object, an
// unknown type of geometry, or coordinates that are no nested arrays of finite numbers. Returns
// otherwise, whatever else the file may be.
void check_geojson(const std::string& path);

}  // namespace terrview
