// Writes the sample landscape as <folder>/vosges_like.tif and <folder>/vosges_like.asc (+ .prj).
#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

#include "samples/mountains.h"

namespace terrview {
namespace {

GDALDriver& driver(const char* name) {
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName(name);
  if (found == nullptr) throw std::runtime_error(std::string("GDAL lacks the driver ") + name);
  return *found;
}

// GDAL's origin is the corner of the first pixel; posts are the middles of pixels.
std::array<double, 6> geotransform() {
  constexpr double half = kSampleSize_posts / 2.0;
  return {kSampleMiddleLongitude_deg - half * kSampleLongitudeStep_deg,
          kSampleLongitudeStep_deg,
          0,
          kSampleMiddleLatitude_deg + half * kSampleLatitudeStep_deg,
          0,
          -kSampleLatitudeStep_deg};
}

void write_geotiff(HeightGrid grid, const std::string& path) {
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "2");
  options.SetNameValue("ZLEVEL", "9");
  const GDALDatasetUniquePtr file(
      driver("GTiff").Create(path.c_str(), grid.columns, grid.rows, 1, GDT_Int16, options.List()));
  if (!file) throw std::runtime_error("cannot write " + path);
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  file->SetSpatialRef(&wgs84);
  file->SetGeoTransform(geotransform().data());
  if (file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, grid.columns, grid.rows,
                                       grid.heights_m.data(), grid.columns, grid.rows, GDT_Float32,
                                       0, 0, nullptr) != CE_None)
    throw std::runtime_error("cannot write " + path);
}

void convert_to_ascii(const std::string& geotiff_path, const std::string& path) {
  // GDAL warns that some readers want square cells; the sample is there to show others.
  const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);
  const GDALDatasetUniquePtr source(GDALDataset::Open(geotiff_path.c_str()));
  const GDALDatasetUniquePtr file(
      source
          ? driver("AAIGrid").CreateCopy(path.c_str(), source.get(), 1, nullptr, nullptr, nullptr)
          : nullptr);
  if (!file) throw std::runtime_error("cannot write " + path);
}

}  // namespace
}  // namespace terrview

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("which folder? make_sample FOLDER");
  CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
  GDALAllRegister();
  const std::string stem = std::string(argv[1]) + "/vosges_like";
  terrview::write_geotiff(terrview::make_mountains(), stem + ".tif");
  terrview::convert_to_ascii(stem + ".tif", stem + ".asc");
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << "make_sample: " << error.what() << '\n';
  return EXIT_FAILURE;
}
