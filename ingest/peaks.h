// Summits and their names, from vector files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "ingest/vector_file.h"

namespace terrview {

struct Peak {
  int number = 0;                     // in file order, from 1
  std::string name;                   // UTF-8, one line
  glm::dvec2 place{0, 0};             // in the coordinates of the file, x to the east
  std::optional<double> elevation_m;  // none: the file does not say
  std::optional<double> prominence_m;
};

struct PeakFile {
  VectorFile file;
  std::vector<Peak> peaks;  // of every point with a name
  int without_name = 0;     // features
  int without_point = 0;
};

// Points with the field `name`; the fields ele, elevation, height or altitude, and prominence, in
// metres, may tell more. A table without geometry (CSV) has the columns lat and lon, latitude and
// longitude, in degrees (WGS 84), or x and y, in the coordinates of the first DEM. Names of fields
// match whatever their case. Throws InputError, naming the fields there are, if it has no such
// columns, or no name at all.
[[nodiscard]] PeakFile read_peaks(const std::string& path);

}  // namespace terrview
