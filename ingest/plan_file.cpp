#include "ingest/plan_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include "ingest/dataset_place.h"
#include "ingest/gdal_scope.h"
#include "terrain/error.h"

namespace terrview {
namespace {

std::string driver_of(const std::string& path, const std::string& format) {
  static const std::map<std::string, std::string> kDrivers{
      {"tif", "GTiff"}, {"tiff", "GTiff"}, {"gtiff", "GTiff"}, {"cog", "COG"},
      {"png", "PNG"},   {"jpg", "JPEG"},   {"jpeg", "JPEG"}};
  std::string name = format;
  if (name.empty()) {
    name = std::filesystem::path(path).extension().string();
    if (!name.empty()) name.erase(0, 1);
  }
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = kDrivers.find(name);
  if (found == kDrivers.end())
    throw InputError("'" + path + "': a plan is no '" + name +
                     "': end the name in .tif, .png or .jpg, or name one, or COG, with --of");
  return found->second;
}

bool is_tiff(const std::string& driver) { return driver == "GTiff" || driver == "COG"; }

CPLStringList creation_list(const std::map<std::string, std::string>& values) {
  CPLStringList list;
  for (const auto& [key, value] : values) list.SetNameValue(key.c_str(), value.c_str());
  return list;
}

// A file in GDAL's memory, and what GDAL writes beside it.
class MemoryPicture {
 public:
  MemoryPicture() = default;
  ~MemoryPicture() {
    VSIUnlink(path().c_str());
    VSIUnlink(side_path().c_str());
  }
  MemoryPicture(const MemoryPicture&) = delete;
  MemoryPicture& operator=(const MemoryPicture&) = delete;

  [[nodiscard]] std::string path() const {
    return "/vsimem/terrview_plan_" + std::to_string(reinterpret_cast<std::uintptr_t>(this));
  }
  [[nodiscard]] std::string side_path() const { return path() + ".aux.xml"; }

  static std::string bytes(const std::string& path) {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(path.c_str(), &size, FALSE);
    if (data == nullptr) return {};
    return {reinterpret_cast<const char*>(data), static_cast<std::size_t>(size)};
  }
};

// Red, green, blue and perhaps alpha, in GDAL's memory.
GDALDatasetUniquePtr dataset_of(const PlanPicture& picture, int bands, GdalScope& gdal) {
  const int width = picture.colors.width_px();
  const int height = picture.colors.height_px();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDatasetUniquePtr dataset(driver->Create("", width, height, bands, GDT_Byte, nullptr));
  if (!dataset) gdal.throw_failure();
  const auto* first = reinterpret_cast<const GByte*>(picture.colors.pixels().data());
  if (dataset->RasterIO(GF_Write, 0, 0, width, height, const_cast<GByte*>(first), width, height,
                        GDT_Byte, bands, nullptr, 4, GSpacing{4} * width, 1, nullptr) != CE_None)
    gdal.throw_failure();
  constexpr std::array<GDALColorInterp, 4> kMeanings{GCI_RedBand, GCI_GreenBand, GCI_BlueBand,
                                                     GCI_AlphaBand};
  for (int band = 1; band <= bands; ++band)
    dataset->GetRasterBand(band)->SetColorInterpretation(
        kMeanings[static_cast<std::size_t>(band - 1)]);
  return dataset;
}

bool has_gaps(const PlanPicture& picture) {
  const auto& colors = picture.colors.pixels();
  return std::any_of(colors.begin(), colors.end(),
                     [](const glm::u8vec4& color) { return color.a == 0; });
}

PlanPicture on_white(PlanPicture picture) {
  for (int row = 0; row < picture.colors.height_px(); ++row) {
    for (int column = 0; column < picture.colors.width_px(); ++column) {
      glm::u8vec4& color = picture.colors.at(column, row);
      if (color.a == 0) color = glm::u8vec4(255);
    }
  }
  return picture;
}

void set_metadata(GDALDataset& dataset, const std::string& driver,
                  const std::map<std::string, std::string>& metadata) {
  for (const auto& [key, value] : metadata) {
    std::string name = is_tiff(driver) ? "TIFFTAG_IMAGEDESCRIPTION" : key;
    std::replace(name.begin(), name.end(), ':', '_');  // to GDAL a name ends there
    dataset.SetMetadataItem(name.c_str(), value.c_str());
  }
}

CPLStringList creation_of(const std::string& driver, const PlanFileOptions& options) {
  CPLStringList creation = creation_list(options.creation);
  if (is_tiff(driver) && creation.FetchNameValue("COMPRESS") == nullptr)
    creation.SetNameValue("COMPRESS", "DEFLATE");
  if (is_tiff(driver) && creation.FetchNameValue("BIGTIFF") == nullptr)
    creation.SetNameValue("BIGTIFF", "IF_SAFER");
  if (driver == "PNG") creation.SetNameValue("WRITE_METADATA_AS_TEXT", "YES");
  return creation;
}

}  // namespace

void check_plan_file(const std::string& path, const PlanFileOptions& options) {
  GdalScope gdal;
  const std::string name = driver_of(path, options.format);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name.c_str());
  if (driver == nullptr)
    throw InputError("'" + path + "': GDAL is without its driver " + name + ": use another format");
  if (GDALValidateCreationOptions(driver, creation_list(options.creation).List()) == FALSE) {
    const std::vector<std::string> reasons = gdal.take_warnings();
    throw InputError("--co: " + (reasons.empty() ? "unknown" : reasons.front()) +
                     ": see gdalinfo --format " + name);
  }
}

bool needs_side_files(const std::string& path, const PlanFileOptions& options) {
  return !is_tiff(driver_of(path, options.format));
}

PlanFiles encode_plan(const std::string& path, const PlanPicture& picture,
                      const PlanFileOptions& options) {
  GdalScope gdal;
  const std::string name = driver_of(path, options.format);
  const bool gaps = options.always_alpha || has_gaps(picture);
  const bool whitened = gaps && name == "JPEG";
  const GDALDatasetUniquePtr source =
      dataset_of(whitened ? on_white(picture) : picture, gaps && !whitened ? 4 : 3, gdal);
  set_place(*source, picture.corners, picture.crs_wkt);
  set_metadata(*source, name, options.metadata);
  const CPLConfigOptionSetter with_side_file("GDAL_PAM_ENABLED", "YES", false);
  const MemoryPicture memory;
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name.c_str());
  GDALDatasetUniquePtr written(driver->CreateCopy(memory.path().c_str(), source.get(), FALSE,
                                                  creation_of(name, options).List(), nullptr,
                                                  nullptr));
  if (!written) gdal.throw_failure();
  written.reset();
  if (const std::string reason = gdal.take_failure(); !reason.empty())
    throw std::runtime_error(reason);
  return {MemoryPicture::bytes(memory.path()), MemoryPicture::bytes(memory.side_path())};
}

std::string world_file(const PostPlacement& corners) {
  const glm::dvec2 centre = corners.at({0.5, 0.5});
  char text[256];
  std::snprintf(text, sizeof text, "%.17g\n%.17g\n%.17g\n%.17g\n%.17g\n%.17g\n", corners.step[0].x,
                corners.step[0].y, corners.step[1].x, corners.step[1].y, centre.x, centre.y);
  return text;
}

std::string world_file_name(const std::string& path) {
  const std::filesystem::path name(path);
  const std::string extension = name.extension().string();
  // The first and the last letter of the extension, and a w.
  const std::string ending =
      extension.size() > 2 ? std::string{'.', extension[1], extension.back(), 'w'} : ".wld";
  return std::filesystem::path(name).replace_extension(ending).string();
}

}  // namespace terrview
