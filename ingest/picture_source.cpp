#include "ingest/picture_source.h"

#include <algorithm>
#include <array>

#include <gdal_priv.h>
#include <glm/vec4.hpp>

#include "ingest/gdal_scope.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr int kPixelsAtOnce = 1 << 20;
constexpr int kMostPixelsAtOnce = 1 << 25;  // where the file's blocks want as many

bool is_8_or_16_bits(GDALDataType type) { return type == GDT_Byte || type == GDT_UInt16; }

// The bands of red, green and blue, or the only one of colours.
std::vector<int> color_bands(GDALDataset& dataset) {
  std::array<int, 3> found{};
  std::vector<int> others;
  for (int band = 1; band <= dataset.GetRasterCount(); ++band) {
    const GDALColorInterp meaning = dataset.GetRasterBand(band)->GetColorInterpretation();
    if (meaning >= GCI_RedBand && meaning <= GCI_BlueBand)
      found[static_cast<std::size_t>(meaning - GCI_RedBand)] = band;
    else if (meaning != GCI_AlphaBand)
      others.push_back(band);
  }
  if (std::find(found.begin(), found.end(), 0) == found.end()) return {found.begin(), found.end()};
  if (others.size() >= 3) return {others.begin(), others.begin() + 3};
  return others.empty() ? others : std::vector<int>{others.front()};
}

std::vector<glm::u8vec4> color_table(GDALRasterBand& band) {
  const GDALColorTable* table = band.GetColorTable();
  if (table == nullptr) return {};
  std::vector<glm::u8vec4> colors(band.GetRasterDataType() == GDT_Byte ? 256 : 65536,
                                  glm::u8vec4(0, 0, 0, 255));
  const int count = std::min(table->GetColorEntryCount(), static_cast<int>(colors.size()));
  for (int i = 0; i < count; ++i) {
    const GDALColorEntry* entry = table->GetColorEntry(i);
    colors[static_cast<std::size_t>(i)] = glm::u8vec4(entry->c1, entry->c2, entry->c3, entry->c4);
  }
  return colors;
}

// Nodata is a matter of each band; an alpha band or a mask is one for all.
std::vector<int> masked_bands(GDALDataset& dataset, const std::vector<int>& bands) {
  const int flags = dataset.GetRasterBand(bands.front())->GetMaskFlags();
  if ((flags & GMF_ALL_VALID) != 0) return {};
  return (flags & GMF_NODATA) != 0 ? bands : std::vector<int>{bands.front()};
}

}  // namespace

void PictureSource::Closing::operator()(GDALDataset* dataset) const { GDALClose(dataset); }

PictureSource::PictureSource(const std::string& path) : path_(path) {
  GdalScope gdal;
  dataset_.reset(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr));
  if (!dataset_)
    throw InputError("'" + path + "': cannot be opened (" + gdal.take_failure() +
                     "): name a picture that GDAL reads");
  size_px_ = {dataset_->GetRasterXSize(), dataset_->GetRasterYSize()};
  bands_ = color_bands(*dataset_);
  if (bands_.empty()) throw InputError("'" + path + "': has no bands of colours: name a picture");
  for (const int band : bands_) {
    const GDALDataType type = dataset_->GetRasterBand(band)->GetRasterDataType();
    if (!is_8_or_16_bits(type))
      throw InputError("'" + path + "': is of type " + GDALGetDataTypeName(type) +
                       ", not of 8 or 16 bits: convert it with gdal_translate -ot Byte -scale");
  }
  if (bands_.size() == 1) table_ = color_table(*dataset_->GetRasterBand(bands_.front()));
  mask_bands_ = masked_bands(*dataset_, bands_);
}

PictureSource::~PictureSource() = default;

bool PictureSource::has_mask() const {
  return !mask_bands_.empty() ||
         std::any_of(table_.begin(), table_.end(), [](glm::u8vec4 entry) { return entry.a < 128; });
}

int PictureSource::lines_at_once() const {
  int block_width = 0;
  int block_height = 0;
  dataset_->GetRasterBand(bands_.front())->GetBlockSize(&block_width, &block_height);
  const int few = std::max(1, kPixelsAtOnce / size_px_.x);
  const int most = std::max(1, kMostPixelsAtOnce / size_px_.x);
  const int whole_blocks = std::max(block_height, few / block_height * block_height);
  return std::min(size_px_.y, whole_blocks <= most ? whole_blocks : few);
}

namespace {

// The reason that GDAL gave goes into the message.
void check_reading(CPLErr result, const std::string& path, int line, GdalScope& gdal) {
  if (result == CE_None) return;
  throw InputError("'" + path + "': cannot be read at line " + std::to_string(line) + " (" +
                   gdal.take_failure() + "): the file is damaged or incomplete");
}

}  // namespace

void PictureSource::read_band(int band, int first_line, int lines, std::uint8_t* values,
                              int stride) const {
  GdalScope gdal;
  GDALRasterBand& raster = *dataset_->GetRasterBand(band);
  if (raster.GetRasterDataType() == GDT_Byte) {
    check_reading(raster.RasterIO(GF_Read, 0, first_line, size_px_.x, lines, values, size_px_.x,
                                  lines, GDT_Byte, stride, GSpacing{stride} * size_px_.x, nullptr),
                  path_, first_line, gdal);
    return;
  }
  std::vector<std::uint16_t> line(static_cast<std::size_t>(size_px_.x));
  for (int row = first_line; row < first_line + lines; ++row) {
    check_reading(raster.RasterIO(GF_Read, 0, row, size_px_.x, 1, line.data(), size_px_.x, 1,
                                  GDT_UInt16, 0, 0, nullptr),
                  path_, row, gdal);
    for (const std::uint16_t value : line) {
      *values = static_cast<std::uint8_t>((value * 255U + 32767) / 65535);
      values += stride;
    }
  }
}

void PictureSource::read_table_colors(int first_line, int lines, std::vector<glm::u8vec3>& colors,
                                      std::vector<std::uint8_t>& valid) const {
  GdalScope gdal;
  GDALRasterBand& band = *dataset_->GetRasterBand(bands_.front());
  std::vector<std::uint16_t> line(static_cast<std::size_t>(size_px_.x));
  if (has_mask()) valid.assign(colors.size(), 255);
  std::size_t pixel = 0;
  for (int row = first_line; row < first_line + lines; ++row) {
    check_reading(band.RasterIO(GF_Read, 0, row, size_px_.x, 1, line.data(), size_px_.x, 1,
                                GDT_UInt16, 0, 0, nullptr),
                  path_, row, gdal);
    for (const std::uint16_t index : line) {
      const glm::u8vec4 entry = table_[std::min<std::size_t>(index, table_.size() - 1)];
      colors[pixel] = glm::u8vec3(entry);
      if (entry.a < 128) valid[pixel] = 0;
      ++pixel;
    }
  }
}

void PictureSource::read_mask(int first_line, int lines, std::vector<std::uint8_t>& valid) const {
  GdalScope gdal;
  const auto pixels = static_cast<std::size_t>(size_px_.x) * static_cast<std::size_t>(lines);
  if (valid.empty()) valid.assign(pixels, 255);
  std::vector<std::uint8_t> in_one(pixels, 0);
  std::vector<std::uint8_t> mask(pixels);
  for (const int band : mask_bands_) {
    check_reading(dataset_->GetRasterBand(band)->GetMaskBand()->RasterIO(
                      GF_Read, 0, first_line, size_px_.x, lines, mask.data(), size_px_.x, lines,
                      GDT_Byte, 0, 0, nullptr),
                  path_, first_line, gdal);
    for (std::size_t i = 0; i < pixels; ++i) {
      if (mask[i] >= 128) in_one[i] = 255;
    }
  }
  for (std::size_t i = 0; i < pixels; ++i) valid[i] &= in_one[i];
}

void PictureSource::read(int first_line, int lines, std::vector<glm::u8vec3>& colors,
                         std::vector<std::uint8_t>& valid) const {
  colors.resize(static_cast<std::size_t>(size_px_.x) * static_cast<std::size_t>(lines));
  valid.clear();
  std::uint8_t* first = &colors.front().x;
  if (!table_.empty()) {
    read_table_colors(first_line, lines, colors, valid);
  } else {
    for (std::size_t i = 0; i < bands_.size(); ++i)
      read_band(bands_[i], first_line, lines, first + i, sizeof(glm::u8vec3));
    if (bands_.size() == 1)
      for (glm::u8vec3& color : colors) color = glm::u8vec3(color.x);
  }
  if (!mask_bands_.empty()) read_mask(first_line, lines, valid);
}

}  // namespace terrview
