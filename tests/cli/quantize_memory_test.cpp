// A picture of 20 000 x 20 000 pixels within 300 MB: docs/quantize.md.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

constexpr int kSide_px = 20000;
constexpr int kStripe_px = 256;

// A smooth picture with noise in its lower bits, so that it has millions of colours; tiled, so that
// GDAL must keep a whole row of blocks.
void write_large_picture(const std::string& path) {
  GDALAllRegister();
  GDALSetCacheMax64(64 << 20);
  const char* const options[] = {"TILED=YES", "COMPRESS=LZW", "INTERLEAVE=PIXEL", nullptr};
  const GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      path.c_str(), kSide_px, kSide_px, 3, GDT_Byte, const_cast<char**>(options)));
  std::vector<std::uint8_t> stripe(std::size_t{kSide_px} * kStripe_px * 3);
  std::uint32_t noise = 1;
  for (int line = 0; line < kSide_px; line += kStripe_px) {
    const int lines = std::min(kStripe_px, kSide_px - line);
    std::size_t at = 0;
    for (int y = line; y < line + lines; ++y) {
      for (int x = 0; x < kSide_px; ++x) {
        for (const int smooth : {x / 100, y / 100, (x + y) / 200}) {
          stripe[at] = static_cast<std::uint8_t>(smooth + static_cast<int>(noise >> 28));
          noise = noise * 1664525U + 1013904223U;
          ++at;
        }
      }
    }
    ASSERT_EQ(file->RasterIO(GF_Write, 0, line, kSide_px, lines, stripe.data(), kSide_px, lines,
                             GDT_Byte, 3, nullptr, 3, 3 * kSide_px, 1, nullptr),
              CE_None);
  }
}

TEST(QuantizeLong, OfFourHundredMegapixelsStaysWithin300Megabytes) {
  const TemporaryFolder folder;
  write_large_picture(folder / "large.tif");
  for (const std::string line : {"-o a.png --colors 256", "-o a.tif --colors 65536 --overwrite"}) {
    SCOPED_TRACE(line);
    // A child's memory is counted from that of its parent; the shell has little.
    const std::string command = "cd '" + folder.path().string() +
                                "' && exec " TERRVIEW_PROGRAM " quantize large.tif -q " + line;
    ASSERT_EQ(std::system(command.c_str()), 0);
    rusage used{};
    ASSERT_EQ(::getrusage(RUSAGE_CHILDREN, &used), 0);
    EXPECT_LT(used.ru_maxrss * 1024L, 300'000'000L);
    RecordProperty("peak_kib", static_cast<int>(used.ru_maxrss));
  }
}

}  // namespace
}  // namespace terrview
