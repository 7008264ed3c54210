#include <cassert>
#include <fstream>
#include <iomanip>
#include <stdexcept>

#include "bench/file_to_png.h"

namespace terrview {

std::string write_dem_file(const BenchDem& dem, const std::string& folder) {
  assert(dem.step_m[0].y == 0 && dem.step_m[1].x == 0);
  const HeightGrid& grid = *dem.grid;
  const glm::dvec2 first_m = dem.scene_xy_m({0, 0});
  std::ofstream header(folder + "/dem.hdr");
  header << std::setprecision(17) << "NROWS " << grid.rows << "\nNCOLS " << grid.columns
         << "\nNBANDS 1\nNBITS 32\nPIXELTYPE FLOAT\nBYTEORDER I\nLAYOUT BIL\nULXMAP " << first_m.x
         << "\nULYMAP " << first_m.y << "\nXDIM " << dem.step_m[0].x << "\nYDIM "
         << -dem.step_m[1].y << '\n';
  const std::string path = folder + "/dem.bil";
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(grid.heights_m.data()),
             static_cast<std::streamsize>(grid.heights_m.size() * sizeof(float)));
  if (!header.flush() || !file.flush()) throw std::runtime_error("cannot write " + path);
  return path;
}

}  // namespace terrview
