#include <gdal_priv.h>

#include <array>
#include <stdexcept>

#include "bench/file_to_png.h"

namespace terrview {

void write_dem_file(const BenchDem& dem, const std::string& path) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (driver == nullptr) throw std::runtime_error("GDAL lacks the driver GTiff");
  const HeightGrid& grid = *dem.grid;
  const GDALDatasetUniquePtr file(
      driver->Create(path.c_str(), grid.columns, grid.rows, 1, GDT_Float32, nullptr));
  if (!file) throw std::runtime_error("cannot write " + path);
  // GDAL's origin is the corner of the first pixel; posts are the middles of pixels.
  const glm::dvec2 corner = dem.scene_xy_m({-0.5, -0.5});
  const glm::dmat2& step = dem.step_m;
  std::array<double, 6> geotransform{corner.x, step[0].x, step[1].x,
                                     corner.y, step[0].y, step[1].y};
  file->SetGeoTransform(geotransform.data());
  std::vector<float> heights_m = grid.heights_m;
  if (file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, grid.columns, grid.rows, heights_m.data(),
                                       grid.columns, grid.rows, GDT_Float32, 0, 0,
                                       nullptr) != CE_None)
    throw std::runtime_error("cannot write " + path);
}

}  // namespace terrview
