#include "tests/cli/small_picture.h"

#include <ogr_spatialref.h>

#include <array>
#include <stdexcept>

namespace terrview {
namespace {

int land(int x, int y, int band) {
  if (y < 30)
    return std::array{110 + y * 2 + x / 9, 140 + y * 2, 215 + y}[static_cast<std::size_t>(band)];
  const int hill = (x * x / 40 + y * 3 + (x * 7 + y * 13) % 5) % 256;
  return std::array{60 + hill / 2, 90 + x / 3, 40 + y / 5}[static_cast<std::size_t>(band)];
}

bool in_hole(int x, int y) { return x > 30 && x < 60 && y > 20 && y < 50; }

void place(GDALDataset& dataset) {
  std::array<double, 6> transform{400000, 30, 0, 5300000, 0, -30};
  dataset.SetGeoTransform(transform.data());
  OGRSpatialReference crs;
  crs.importFromEPSG(32632);
  dataset.SetSpatialRef(&crs);
}

std::vector<int> read_band(GDALRasterBand& band) {
  std::vector<int> values(static_cast<std::size_t>(band.GetXSize()) *
                          static_cast<std::size_t>(band.GetYSize()));
  if (band.RasterIO(GF_Read, 0, 0, band.GetXSize(), band.GetYSize(), values.data(), band.GetXSize(),
                    band.GetYSize(), GDT_Int32, 0, 0, nullptr) != CE_None)
    throw std::runtime_error("band not read");
  return values;
}

void read_colors(GDALDataset& dataset, ReadPicture& picture) {
  const GDALColorTable* table = dataset.GetRasterBand(1)->GetColorTable();
  if (table != nullptr) {
    for (int i = 0; i < table->GetColorEntryCount(); ++i) {
      const GDALColorEntry* entry = table->GetColorEntry(i);
      picture.table.emplace_back(entry->c1, entry->c2, entry->c3);
    }
    for (const int index : picture.indices) {
      const GDALColorEntry* entry = table->GetColorEntry(index);
      picture.colors.emplace_back(entry->c1, entry->c2, entry->c3, entry->c4);
    }
    return;
  }
  picture.colors.assign(picture.indices.size(), glm::ivec4(0, 0, 0, 255));
  for (int band = 0; band < picture.bands; ++band) {
    const std::vector<int> values = read_band(*dataset.GetRasterBand(band + 1));
    for (std::size_t i = 0; i < values.size(); ++i) picture.colors[i][band] = values[i];
  }
}

}  // namespace

ReadPicture read_picture(const std::string& path) {
  const GDALDatasetUniquePtr dataset(GDALDataset::Open(path.c_str()));
  if (!dataset) throw std::runtime_error("not opened: " + path);
  ReadPicture picture;
  picture.width_px = dataset->GetRasterXSize();
  picture.height_px = dataset->GetRasterYSize();
  picture.bands = dataset->GetRasterCount();
  GDALRasterBand& first = *dataset->GetRasterBand(1);
  picture.type = first.GetRasterDataType();
  int has_nodata = FALSE;
  const double nodata = first.GetNoDataValue(&has_nodata);
  if (has_nodata != FALSE) picture.nodata = nodata;
  picture.indices = read_band(first);
  read_colors(*dataset, picture);
  return picture;
}

SmallPicture::SmallPicture() {
  GDALAllRegister();
  write_picture("land.tif", "GTiff", 3, GDT_Byte, land, place);
  write_picture("few.png", "PNG", 3, GDT_Byte,
                [](int x, int y, int band) { return (x / 30 * 4 + y / 20) * 20 + 7 * band; });
  write_picture("holes.png", "PNG", 4, GDT_Byte, [](int x, int y, int band) {
    if (band == 3) return in_hole(x, y) ? 0 : 255;
    return land(x, y, band);
  });
  inputs_ = names_in(folder_.path());
}

void SmallPicture::write_picture(const std::string& name, const std::string& driver, int bands,
                                 GDALDataType type,
                                 const std::function<int(int x, int y, int band)>& value,
                                 const std::function<void(GDALDataset&)>& change) const {
  GDALDriverManager& drivers = *GetGDALDriverManager();
  const GDALDatasetUniquePtr memory(
      drivers.GetDriverByName("MEM")->Create("", kWidth_px, kHeight_px, bands, type, nullptr));
  for (int band = 0; band < bands; ++band) {
    std::vector<int> values;
    for (int y = 0; y < kHeight_px; ++y)
      for (int x = 0; x < kWidth_px; ++x) values.push_back(value(x, y, band));
    if (memory->GetRasterBand(band + 1)->RasterIO(GF_Write, 0, 0, kWidth_px, kHeight_px,
                                                  values.data(), kWidth_px, kHeight_px, GDT_Int32,
                                                  0, 0, nullptr) != CE_None)
      throw std::runtime_error("band not written");
  }
  if (change) change(*memory);
  const GDALDatasetUniquePtr file(
      drivers.GetDriverByName(driver.c_str())
          ->CreateCopy(path(name).c_str(), memory.get(), FALSE, nullptr, nullptr, nullptr));
  if (!file) throw std::runtime_error("not written: " + name);
}

ReadPicture SmallPicture::quantized(const std::string& input, const std::string& output,
                                    const std::string& options) const {
  const Finished finished = quantize(input + " -q -o " + output + " " + options);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out + finished.err, "");
  return read_picture(path(output));
}

std::set<std::string> SmallPicture::outputs() const {
  std::set<std::string> names = names_in(folder_.path());
  for (const std::string& input : inputs_) names.erase(input);
  return names;
}

}  // namespace terrview
