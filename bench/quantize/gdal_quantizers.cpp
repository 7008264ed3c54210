#include <gdal_alg.h>
#include <gdal_priv.h>

#include <stdexcept>

#include "bench/quantize/quantize_contender.h"
#include "quantize/color_map.h"
#include "quantize/nearest_color.h"

namespace terrview {
namespace {

constexpr int kMostColors = 256;  // of GDALComputeMedianCutPCT

GDALDatasetUniquePtr in_memory(const Picture& picture, int bands) {
  GDALAllRegister();
  return GDALDatasetUniquePtr(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
      "", picture.width_px, picture.height_px, bands, GDT_Byte, nullptr));
}

class GdalJob : public QuantizeJob {
 public:
  GdalJob(const Picture& picture, int colors, bool rewrites)
      : picture_(picture),
        colors_(colors),
        rewrites_(rewrites),
        source_(in_memory(picture, 3)),
        target_(in_memory(picture, 1)) {
    std::vector<Rgb8> pixels = picture.pixels;
    const CPLErr copied = source_->RasterIO(
        GF_Write, 0, 0, picture.width_px, picture.height_px, pixels.data(), picture.width_px,
        picture.height_px, GDT_Byte, 3, nullptr, 3, GSpacing{3} * picture.width_px, 1, nullptr);
    if (copied != CE_None) throw std::runtime_error(CPLGetLastErrorMsg());
  }

  void run() override {
    table_ = GDALColorTable();
    int failed = GDALComputeMedianCutPCT(band(1), band(2), band(3), nullptr, colors_, &table_,
                                         GDALDummyProgress, nullptr);
    if (rewrites_)
      failed += GDALDitherRGB2PCT(band(1), band(2), band(3), target_->GetRasterBand(1), &table_,
                                  GDALDummyProgress, nullptr);
    if (failed != 0) throw std::runtime_error(CPLGetLastErrorMsg());
  }

  [[nodiscard]] Rewritten result() override {
    Rewritten rewritten;
    for (int i = 0; i < table_.GetColorEntryCount(); ++i) {
      const GDALColorEntry& entry = *table_.GetColorEntry(i);
      rewritten.palette.emplace_back(entry.c1, entry.c2, entry.c3);
    }
    const NearestColor nearest(rewritten.palette, ColorDifference::rgb);
    ColorMap map([&](Rgb8 color) { return nearest.find(color); });
    for (const Rgb8 color : picture_.pixels) rewritten.indices.push_back(map.address(color));
    return rewritten;
  }

 private:
  [[nodiscard]] GDALRasterBand* band(int i) const { return source_->GetRasterBand(i); }

  const Picture& picture_;
  int colors_;
  bool rewrites_;
  GDALDatasetUniquePtr source_;
  GDALDatasetUniquePtr target_;
  GDALColorTable table_;
};

QuantizeContender contender(const char* name, bool rewrites) {
  return {name, kMostColors, [rewrites](const Picture& picture, int colors) {
            return std::make_unique<GdalJob>(picture, colors, rewrites);
          }};
}

}  // namespace

std::vector<QuantizeContender> gdal_quantizers() {
  return {contender("gdal-median-cut", true), contender("gdal-palette", false)};
}

}  // namespace terrview
