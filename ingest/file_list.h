// The files that a file is made of.
#pragma once

#include <string>
#include <vector>

namespace terrview {

// `path` itself, and what GDAL reads with it: side files, the parts of a shapefile, the sources of
// a VRT. Sorted after the first; `path` alone where GDAL cannot open it.
[[nodiscard]] std::vector<std::string> files_of(const std::string& path);

}  // namespace terrview
