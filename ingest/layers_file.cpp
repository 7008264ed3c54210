#include "ingest/layers_file.h"

#include <limits>
#include <stdexcept>

#include <cpl_error.h>
#include <gdal_priv.h>

#include "ingest/memory_file.h"
#include "render/write_file.h"

namespace terrview {

void write_layers(const std::string& path, int width_px, int height_px,
                  const std::vector<LayerBand>& bands, const std::string& camera_json) {
  const MemoryFile memory;
  const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "INTERLEAVE=BAND",
                                 "BIGTIFF=IF_SAFER", nullptr};
  GDALDatasetUniquePtr dataset =
      memory.create({width_px, height_px}, static_cast<int>(bands.size()), GDT_Float64, options);
  dataset->SetMetadataItem("TERRVIEW_CAMERA", camera_json.c_str());
  for (std::size_t i = 0; i < bands.size(); ++i) {
    GDALRasterBand* band = dataset->GetRasterBand(static_cast<int>(i) + 1);
    band->SetDescription(bands[i].name.c_str());
    band->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
    const CPLErr written = band->RasterIO(GF_Write, 0, 0, width_px, height_px,
                                          const_cast<double*>(bands[i].values.data()), width_px,
                                          height_px, GDT_Float64, 0, 0, nullptr);
    if (written != CE_None) throw std::runtime_error(CPLGetLastErrorMsg());
  }
  dataset.reset();
  memory.throw_if_failed();
  write_file(path, memory.bytes());
}

}  // namespace terrview
