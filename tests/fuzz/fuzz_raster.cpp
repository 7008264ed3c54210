#include "tests/fuzz/fuzz_raster.h"

#include <gdal_priv.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "ingest/dem.h"
#include "ingest/gdal_scope.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// MEM is what voids are filled in.
bool keep_only(const std::string& driver) {
  const GdalScope registers_all;
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (int i = drivers.GetDriverCount() - 1; i >= 0; --i) {
    GDALDriver* one = drivers.GetDriver(i);
    const std::string name = one->GetDescription();
    if (name == driver || name == "MEM") continue;
    drivers.DeregisterDriver(one);
    GDALDestroyDriver(one);
  }
  return true;
}

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const Dem& dem) {
  const HeightGrid& grid = *dem.grid;
  require(grid.columns >= 2 && grid.rows >= 2);
  require(grid.heights_m.size() ==
          static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  std::size_t heights = 0;
  for (const float height : grid.heights_m) {
    require(std::isnan(height) || std::abs(height) < kHighest_m);
    if (!std::isnan(height)) ++heights;
  }
  require(heights > 0 && heights + dem.voids_open == grid.heights_m.size());
  require(std::isfinite(dem.placement.origin.x) && std::isfinite(dem.placement.origin.y));
  for (const std::string& warning : dem.warnings) {
    require(warning.find('\n') == std::string::npos);
  }
}

void read(const std::string& path, const DemOptions& options) {
  try {
    for (const Dem& dem : read_dems({path}, options)) check(dem);
  } catch (const InputError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos);
  }
}

}  // namespace

void fuzz_raster(const std::uint8_t* data, std::size_t size, const std::string& driver,
                 const std::string& extension) {
  static const bool once = keep_only(driver);
  static_cast<void>(once);
  // GDAL takes no const memory; a copy of exactly this size lets the sanitizer see its end.
  std::vector<GByte> bytes(data, data + size);
  const std::string path = "/vsimem/fuzz/dem" + extension;
  VSIFCloseL(VSIFileFromMemBuffer(path.c_str(), bytes.data(), bytes.size(), FALSE));
  DemOptions options;
  options.memory_bytes = 8 << 20;
  read(path, options);
  // Once more without what the file says of its place: more files come as far as their heights.
  options.spacing = glm::dvec2(60, 90);
  read(path, options);
  VSIUnlink(path.c_str());
}

}  // namespace terrview
