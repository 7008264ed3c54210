#include "ingest/layers_file.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>

#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include "render/write_file.h"

namespace terrview {
namespace {

// A file in GDAL's memory, and GDAL silent: its own files lose the error of a full disk.
class MemoryFile {
 public:
  MemoryFile() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~MemoryFile() {
    VSIUnlink(path().c_str());
    CPLPopErrorHandler();
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  // One of its own for every living MemoryFile.
  [[nodiscard]] std::string path() const {
    return "/vsimem/terrview_" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + ".tif";
  }

  [[nodiscard]] std::string_view bytes() const {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(path().c_str(), &size, FALSE);
    return {reinterpret_cast<const char*>(data), static_cast<std::size_t>(size)};
  }
};

void throw_if_failed() {
  if (CPLGetLastErrorType() >= CE_Failure) throw std::runtime_error(CPLGetLastErrorMsg());
}

}  // namespace

void write_layers(const std::string& path, int width_px, int height_px,
                  const std::vector<LayerBand>& bands, const std::string& camera_json) {
  GDALAllRegister();
  const MemoryFile memory;
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "INTERLEAVE=BAND",
                                 "BIGTIFF=IF_SAFER", nullptr};
  GDALDatasetUniquePtr dataset(driver->Create(memory.path().c_str(), width_px, height_px,
                                              static_cast<int>(bands.size()), GDT_Float64,
                                              const_cast<char**>(options)));
  throw_if_failed();
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
  throw_if_failed();
  write_file(path, memory.bytes());
}

}  // namespace terrview
