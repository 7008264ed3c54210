#include "tests/ingest/test_raster.h"

#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "terrain/error.h"

namespace terrview {
namespace {

void place(GDALDataset& dataset, const TestRaster& raster) {
  if (raster.geotransform) {
    std::array<double, 6> transform = *raster.geotransform;
    dataset.SetGeoTransform(transform.data());
  }
  if (raster.crs.empty()) return;
  OGRSpatialReference crs;
  if (crs.SetFromUserInput(raster.crs.c_str()) != OGRERR_NONE) {
    throw std::runtime_error("no CRS: " + raster.crs);
  }
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  dataset.SetSpatialRef(&crs);
}

void set_band(GDALRasterBand& band, const TestRaster& raster) {
  std::vector<double> numbers;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      numbers.push_back(raster.number(column, row) + 1000 * (band.GetBand() - 1));
    }
  }
  if (band.RasterIO(GF_Write, 0, 0, raster.columns, raster.rows, numbers.data(), raster.columns,
                    raster.rows, GDT_Float64, 0, 0, nullptr) != CE_None) {
    throw std::runtime_error("test raster not filled");
  }
  if (raster.nodata && raster.type == GDT_Int64) {
    band.SetNoDataValueAsInt64(static_cast<std::int64_t>(*raster.nodata));
  } else if (raster.nodata) {
    band.SetNoDataValue(*raster.nodata);
  }
  if (raster.scale) band.SetScale(*raster.scale);
  if (raster.offset) band.SetOffset(*raster.offset);
  if (!raster.unit.empty()) band.SetUnitType(raster.unit.c_str());
}

}  // namespace

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

std::string TestRaster::write(const std::string& path, const std::string& driver) const {
  GDALAllRegister();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  const GDALDatasetUniquePtr memory(
      drivers.GetDriverByName("MEM")->Create("", columns, rows, bands, type, nullptr));
  place(*memory, *this);
  for (const auto& [key, value] : metadata) memory->SetMetadataItem(key.c_str(), value.c_str());
  for (int band = 1; band <= bands; ++band) set_band(*memory->GetRasterBand(band), *this);
  if (change) change(*memory);
  CPLStringList options;
  for (const std::string& option : creation_options) options.AddString(option.c_str());
  const GDALDatasetUniquePtr file(
      drivers.GetDriverByName(driver.c_str())
          ->CreateCopy(path.c_str(), memory.get(), FALSE, options.List(), nullptr, nullptr));
  if (!file) throw std::runtime_error("test raster not written: " + path);
  return path;
}

std::string build_vrt(const std::string& path, const std::vector<std::string>& paths) {
  GDALAllRegister();
  CPLStringList names;
  for (const std::string& name : paths) names.AddString(name.c_str());
  int error = 0;
  const GDALDatasetUniquePtr vrt(GDALDataset::FromHandle(GDALBuildVRT(
      path.c_str(), static_cast<int>(paths.size()), nullptr, names.List(), nullptr, &error)));
  return path;
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Dem read_one(const std::string& path, const DemOptions& options) {
  std::vector<Dem> dems = read_dems({path}, options);
  EXPECT_EQ(dems.size(), 1U) << path;
  return std::move(dems.front());
}

std::string refusal(const std::vector<std::string>& paths, const DemOptions& options) {
  try {
    const auto dems = read_dems(paths, options);
    return "";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
}

testing::AssertionResult says(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) {
      return testing::AssertionFailure() << '"' << text << "\" does not say \"" << part << '"';
    }
  }
  return testing::AssertionSuccess();
}

namespace {

std::string shared_folder() {
  const char* named = std::getenv("TERRVIEW_TEST_DATA");
  return named != nullptr ? named : TERRVIEW_SOURCE_DIR "/../shared/data";
}

}  // namespace

std::string shared_data(const std::string& name) {
  const std::string path = shared_folder() + "/" + name;
  if (!std::filesystem::exists(path)) throw std::runtime_error("no " + path);
  return path;
}

bool has_shared_data() { return std::filesystem::is_directory(shared_folder()); }

}  // namespace terrview
