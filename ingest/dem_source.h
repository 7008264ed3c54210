// One opened raster and how to make heights of its numbers.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ingest/dem.h"
#include "ingest/gdal_scope.h"

class GDALDataset;
class GDALRasterBand;

namespace terrview {

// height_m = (number * scale + offset) * metres_per_unit, unless number is nodata.
struct HeightConversion {
  double scale = 1;
  double offset = 0;
  double metres_per_unit = 1;
  std::optional<double> nodata;
  bool nodata_given = false;  // by the user
};

class DemSource {
 public:
  // Opens `path` and checks everything but the heights. Throws InputError.
  DemSource(const std::string& path, const DemOptions& options, GdalScope& scope);
  ~DemSource();
  DemSource(DemSource&&) noexcept;
  DemSource& operator=(DemSource&&) = delete;

  [[nodiscard]] const DemHeader& header() const { return header_; }
  [[nodiscard]] const HeightConversion& conversion() const { return conversion_; }
  [[nodiscard]] GDALRasterBand& band() const { return *band_; }

 private:
  std::unique_ptr<GDALDataset, void (*)(GDALDataset*)> dataset_;
  GDALRasterBand* band_ = nullptr;
  DemHeader header_;
  HeightConversion conversion_;
};

}  // namespace terrview
