#include "ingest/height_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <cpl_error.h>
#include <cpl_string.h>
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

constexpr std::array kCreationKeys{"COMPRESS", "PREDICTOR",  "ZLEVEL",    "TILED",
                                   "BIGTIFF",  "BLOCKXSIZE", "BLOCKYSIZE"};

// Those that lose nothing.
constexpr std::array kCompressions{"NONE", "DEFLATE", "LZW", "PACKBITS", "LZMA", "ZSTD"};

template <std::size_t kCount>
bool is_one_of(const std::array<const char*, kCount>& names, const std::string& text) {
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return EQUAL(text.c_str(), name); });
}

template <std::size_t kCount>
std::string list_of(const std::array<const char*, kCount>& names) {
  std::string list;
  for (const char* name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

// The user's choices over the program's; a predictor is not for every compression.
CPLStringList creation_list(const HeightFileOptions& options) {
  CPLStringList list;
  for (const auto& [key, value] : options.creation) list.SetNameValue(key.c_str(), value.c_str());
  if (list.FetchNameValue("COMPRESS") == nullptr) {
    list.SetNameValue("COMPRESS", "DEFLATE");
    if (list.FetchNameValue("PREDICTOR") == nullptr) list.SetNameValue("PREDICTOR", "3");
  }
  if (list.FetchNameValue("TILED") == nullptr) list.SetNameValue("TILED", "YES");
  if (list.FetchNameValue("BIGTIFF") == nullptr) list.SetNameValue("BIGTIFF", "IF_SAFER");
  return list;
}

void check_format(const std::string& path, const std::string& format) {
  std::string name = format.empty() ? std::filesystem::path(path).extension().string() : format;
  if (name.starts_with('.')) name.erase(0, 1);
  const std::array known{"tif", "tiff", "gtiff"};
  if (!is_one_of(known, name))
    throw InputError("'" + (format.empty() ? path : format) +
                     "': heights are written as GeoTIFF: end the name in .tif, or give --of GTiff");
}

void check_creation(const HeightFileOptions& options) {
  for (const auto& [key, value] : options.creation) {
    if (!is_one_of(kCreationKeys, key))
      throw InputError("--co " + key + "=" + value +
                       ": no such option for heights: " + heights_creation_keys() + " are");
    if (EQUAL(key.c_str(), "COMPRESS") && !is_one_of(kCompressions, value))
      throw InputError("--co " + key + "=" + value +
                       ": does not keep heights as they are: give one of " +
                       list_of(kCompressions));
  }
  GdalScope gdal;
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (GDALValidateCreationOptions(driver, creation_list(options).List()) == FALSE) {
    const std::vector<std::string> said = gdal.take_warnings();
    throw InputError("--co: " + (said.empty() ? "not valid" : said.front()) +
                     ": see gdalinfo --format GTiff");
  }
  // Numbers are not validated.
  const MemoryFile memory;
  try {
    static_cast<void>(memory.create({2, 2}, 1, GDT_Float32, creation_list(options).List()));
  } catch (const std::runtime_error& error) {
    const std::string said = error.what();
    const std::size_t name = said.find(memory.path() + ": ");
    throw InputError(
        "--co: " +
        (name == std::string::npos ? said : said.substr(name + memory.path().size() + 2)) +
        ": give another value");
  }
}

}  // namespace

std::string heights_creation_keys() { return list_of(kCreationKeys); }

void check_heights_file(const std::string& path, const HeightFileOptions& options) {
  const GdalScope quiet;
  check_format(path, options.format);
  check_creation(options);
  if (!options.crs.empty()) static_cast<void>(find_crs(options.crs));
}

void write_heights(const std::string& path, const HeightGrid& grid,
                   const HeightFileOptions& options) {
  const GdalScope registered;
  const MemoryFile memory;
  GDALDatasetUniquePtr dataset =
      memory.create({grid.columns, grid.rows}, 1, GDT_Float32, creation_list(options).List());
  if (!options.description.empty())
    dataset->SetMetadataItem("TIFFTAG_IMAGEDESCRIPTION", options.description.c_str());
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
