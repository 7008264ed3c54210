#include "ingest/height_file.h"

#include <array>
#include <memory>
#include <stdexcept>

#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "ingest/gdal_scope.h"
#include "ingest/memory_file.h"
#include "render/write_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

OGRSpatialReference find_crs(const std::string& crs) {
  OGRSpatialReference reference;
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (reference.SetFromUserInput(
          crs.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE)
    throw InputError("--a-srs " + crs + ": no such coordinate system: give one as EPSG:32632");
  return reference;
}

// GDAL's origin is the corner of the first pixel; posts are the middles of pixels.
std::array<double, 6> geotransform(const HeightGrid& grid, const HeightFileOptions& options) {
  const double north = options.south_west.y + options.spacing.y * (grid.rows - 1);
  return {options.south_west.x - options.spacing.x / 2,
          options.spacing.x,
          0,
          north + options.spacing.y / 2,
          0,
          -options.spacing.y};
}

}  // namespace

void check_crs(const std::string& crs) {
  const GdalScope quiet;
  if (!crs.empty()) static_cast<void>(find_crs(crs));
}

void write_heights(const std::string& path, const HeightGrid& grid,
                   const HeightFileOptions& options) {
  const GdalScope registered;
  const MemoryFile memory;
  const char* const creation[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES",
                                  "BIGTIFF=IF_SAFER", nullptr};
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDatasetUniquePtr dataset(driver->Create(memory.path().c_str(), grid.columns, grid.rows, 1,
                                              GDT_Float32, const_cast<char**>(creation)));
  memory.throw_if_failed();
  if (!options.crs.empty()) {
    const OGRSpatialReference crs = find_crs(options.crs);
    dataset->SetSpatialRef(&crs);
  }
  dataset->SetGeoTransform(geotransform(grid, options).data());
  const CPLErr written = dataset->GetRasterBand(1)->RasterIO(
      GF_Write, 0, 0, grid.columns, grid.rows, const_cast<float*>(grid.heights_m.data()),
      grid.columns, grid.rows, GDT_Float32, 0, 0, nullptr);
  if (written != CE_None) throw std::runtime_error(CPLGetLastErrorMsg());
  dataset.reset();
  memory.throw_if_failed();
  write_file(path, memory.bytes());
}

}  // namespace terrview
