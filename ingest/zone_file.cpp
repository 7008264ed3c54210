#include "ingest/zone_file.h"

#include <numbers>
#include <stdexcept>
#include <vector>

#include <cpl_error.h>
#include <gdal_priv.h>

#include "ingest/dataset_place.h"
#include "ingest/memory_file.h"
#include "render/write_file.h"

namespace terrview {
namespace {

void write_band(GDALRasterBand& band, const char* name, const std::vector<float>& values) {
  band.SetDescription(name);
  const CPLErr written = band.RasterIO(GF_Write, 0, 0, band.GetXSize(), band.GetYSize(),
                                       const_cast<float*>(values.data()), band.GetXSize(),
                                       band.GetYSize(), GDT_Float32, 0, 0, nullptr);
  if (written != CE_None) throw std::runtime_error(CPLGetLastErrorMsg());
}

std::vector<float> degrees(std::vector<float> angles_rad) {
  for (float& angle : angles_rad)
    if (angle != Zone::kNoData) angle *= static_cast<float>(180 / std::numbers::pi);
  return angles_rad;
}

}  // namespace

void write_zone(const std::string& path, const Zone& zone, const std::string& description) {
  const MemoryFile memory;
  const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3",      "TILED=YES",
                                 "INTERLEAVE=BAND",  "BIGTIFF=IF_SAFER", nullptr};
  GDALDatasetUniquePtr dataset = memory.create({zone.columns, zone.rows}, 2, GDT_Float32, options);
  if (!description.empty())
    dataset->SetMetadataItem("TIFFTAG_IMAGEDESCRIPTION", description.c_str());
  const PostPlacement& posts = zone.placement;
  set_place(*dataset, {posts.at({-0.5, -0.5}), posts.step}, zone.crs_wkt);
  dataset->GetRasterBand(1)->SetNoDataValue(Zone::kNoData);  // of all bands of a GeoTIFF
  write_band(*dataset->GetRasterBand(1), "targets seen", zone.counts);
  dataset->GetRasterBand(2)->SetUnitType("degree");
  write_band(*dataset->GetRasterBand(2), "angle subtended", degrees(zone.angles_rad));
  dataset.reset();
  memory.throw_if_failed();
  write_file(path, memory.bytes());
}

}  // namespace terrview
