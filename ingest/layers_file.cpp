#include "ingest/layers_file.h"

#include <limits>
#include <memory>
#include <stdexcept>

#include <gdal_priv.h>

namespace terrview {

void write_layers(const std::string& path, int width_px, int height_px,
                  const std::vector<LayerBand>& bands, const std::string& camera_json) {
  GDALAllRegister();
  const auto fail = [&] {
    throw std::runtime_error("'" + path + "': writing failed: " + CPLGetLastErrorMsg());
  };
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "INTERLEAVE=BAND",
                                 "BIGTIFF=IF_SAFER", nullptr};
  const GDALDatasetUniquePtr dataset(driver->Create(path.c_str(), width_px, height_px,
                                                    static_cast<int>(bands.size()), GDT_Float64,
                                                    const_cast<char**>(options)));
  if (!dataset) fail();
  dataset->SetMetadataItem("TERRVIEW_CAMERA", camera_json.c_str());
  for (std::size_t i = 0; i < bands.size(); ++i) {
    GDALRasterBand* band = dataset->GetRasterBand(static_cast<int>(i) + 1);
    band->SetDescription(bands[i].name.c_str());
    band->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
    if (band->RasterIO(GF_Write, 0, 0, width_px, height_px,
                       const_cast<double*>(bands[i].values.data()), width_px, height_px,
                       GDT_Float64, 0, 0, nullptr) != CE_None)
      fail();
  }
  dataset->FlushCache(true);
  if (CPLGetLastErrorType() >= CE_Failure) fail();
}

}  // namespace terrview
