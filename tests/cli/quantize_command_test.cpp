// terrview quantize, as docs/cli.md describes it.
#include <sys/resource.h>

#include <filesystem>

#include "cli/palette_file.h"
#include "quantize/color_difference.h"
#include "tests/cli/small_picture.h"

namespace terrview {
namespace {

using Names = std::set<std::string>;
using Quantize = SmallPicture;

// The largest difference of a component between two pictures.
int worst_difference(const ReadPicture& a, const ReadPicture& b) {
  int worst = 0;
  for (std::size_t i = 0; i < a.colors.size(); ++i)
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a.colors[i][c] - b.colors[i][c]));
  return worst;
}

std::size_t colors_used(const ReadPicture& picture) {
  std::set<std::array<int, 3>> colors;
  for (const glm::ivec4& color : picture.colors) colors.insert({color.r, color.g, color.b});
  return colors.size();
}

TEST_F(Quantize, WritesIndicesWhereTheFormatHasThem) {
  const ReadPicture land = read_picture(path("land.tif"));
  ASSERT_GT(colors_used(land), 1000U);
  for (const std::string name : {"a.png", "a.gif", "a.tif"}) {
    SCOPED_TRACE(name);
    const ReadPicture done = quantized("land.tif", name, "--colors 100");
    EXPECT_EQ(done.bands, 1);
    EXPECT_EQ(done.type, GDT_Byte);
    EXPECT_EQ(colors_used(done), 100U);
    EXPECT_LT(worst_difference(land, done), 24);
  }
  EXPECT_EQ(read_picture(path("a.png")).table.size(), 100U);
}

TEST_F(Quantize, WritesUpTo65536ColorsAsIndexedGeotiff) {
  const ReadPicture land = read_picture(path("land.tif"));
  const ReadPicture some = quantized("land.tif", "some.tif", "--colors 500");
  EXPECT_EQ(some.type, GDT_UInt16);
  EXPECT_EQ(colors_used(some), 500U);
  const ReadPicture all = quantized("land.tif", "all.tif", "--colors 65536");
  EXPECT_EQ(all.type, GDT_UInt16);
  EXPECT_EQ(worst_difference(land, all), 0);
}

TEST_F(Quantize, WritesThePalettesColorsWhereATableIsTooShort) {
  const ReadPicture indexed = quantized("land.tif", "a.tif", "--colors 500");
  for (const std::string name : {"a.png", "a.ppm"}) {
    const ReadPicture done = quantized("land.tif", name, "--colors 500");
    EXPECT_EQ(done.bands, 3);
    EXPECT_EQ(worst_difference(indexed, done), 0);
  }
  static_cast<void>(quantized("land.tif", "a.jpg", "--colors 500 --co QUALITY=95"));
  EXPECT_EQ(bytes("a.jpg").substr(0, 2), "\xff\xd8");
}

TEST_F(Quantize, KeepsAPictureOfFewColors) {
  const ReadPicture few = read_picture(path("few.png"));
  for (const std::string options :
       {"", "--method thesis", "--order preorder", "--order population", "--method median-cut",
        "--method variance-cut", "--method popularity", "--match oklab", "--match ciede2000",
        "--dither diffusion"}) {
    SCOPED_TRACE(options);
    EXPECT_EQ(
        worst_difference(few, quantized("few.png", "a.png", "--colors 16 --overwrite " + options)),
        0);
  }
  EXPECT_GT(worst_difference(few, quantized("few.png", "a.png", "--method fixed --overwrite")), 0);
}

TEST_F(Quantize, StaysInPlace) {
  static_cast<void>(quantized("land.tif", "a.tif", "--colors 16"));
  const GDALDatasetUniquePtr before(GDALDataset::Open(path("land.tif").c_str()));
  const GDALDatasetUniquePtr after(GDALDataset::Open(path("a.tif").c_str()));
  std::array<double, 6> expected{};
  std::array<double, 6> found{};
  EXPECT_EQ(before->GetGeoTransform(expected.data()), CE_None);
  EXPECT_EQ(after->GetGeoTransform(found.data()), CE_None);
  EXPECT_EQ(found, expected);
  ASSERT_NE(after->GetSpatialRef(), nullptr);
  EXPECT_TRUE(after->GetSpatialRef()->IsSame(before->GetSpatialRef()));
}

TEST_F(Quantize, GivesNodataTheIndexAfterTheColors) {
  const ReadPicture holes = read_picture(path("holes.png"));
  for (const std::string dither : {"none", "diffusion", "ordered"}) {
    for (const std::string name : {"a.png", "a.tif"}) {
      SCOPED_TRACE(name + " " + dither);
      const ReadPicture done =
          quantized("holes.png", name, "--colors 20 --overwrite --dither " + dither);
      EXPECT_EQ(done.nodata, 19);
      for (std::size_t i = 0; i < done.indices.size(); ++i)
        ASSERT_EQ(done.indices[i] == 19, holes.colors[i].a == 0);
    }
  }
  const ReadPicture many = quantized("holes.png", "many.png", "--colors 600");
  EXPECT_EQ(many.bands, 4);
  for (std::size_t i = 0; i < many.colors.size(); ++i)
    ASSERT_EQ(many.colors[i].a, holes.colors[i].a);
}

TEST_F(Quantize, IgnoresTheColorsOfInvalidPixels) {
  write_picture(
      "nodata.tif", "GTiff", 3, GDT_Byte,
      [](int x, int y, int band) { return x < 10 ? 9 : (x + y) % 4 * 50 + band; },
      [](GDALDataset& dataset) {
        for (int band = 1; band <= 3; ++band) dataset.GetRasterBand(band)->SetNoDataValue(9);
      });
  const ReadPicture done = quantized("nodata.tif", "a.tif", "--colors 5");
  EXPECT_EQ(done.nodata, 4);
  EXPECT_EQ(done.indices.front(), 4);
  EXPECT_EQ(worst_difference(read_picture(path("nodata.tif")), done), 9);  // nodata alone
}

TEST_F(Quantize, OfNothingButNodataIsNothingButNodata) {
  write_picture(
      "empty.tif", "GTiff", 1, GDT_Byte, [](int, int, int) { return 0; },
      [](GDALDataset& dataset) { dataset.GetRasterBand(1)->SetNoDataValue(0); });
  const ReadPicture done = quantized("empty.tif", "a.tif");
  EXPECT_EQ(std::set<int>(done.indices.begin(), done.indices.end()), std::set<int>{1});
}

TEST_F(Quantize, ReadsGreysTablesAndSixteenBits) {
  const auto grey = [](int x, int y, int) { return (x / 30 + y / 20 * 3) * 20; };
  write_picture("grey.tif", "GTiff", 1, GDT_Byte, grey);
  const ReadPicture from_grey = quantized("grey.tif", "g.png");
  write_picture("wide.tif", "GTiff", 3, GDT_UInt16,
                [&](int x, int y, int band) { return grey(x, y, band) * 257; });
  EXPECT_EQ(worst_difference(from_grey, quantized("wide.tif", "w.png")), 0);
  EXPECT_EQ(from_grey.colors.front(), glm::ivec4(0, 0, 0, 255));
  EXPECT_EQ(from_grey.colors.back(), glm::ivec4(220, 220, 220, 255));
  EXPECT_EQ(worst_difference(from_grey, quantized("g.png", "again.png")), 0);
}

TEST_F(Quantize, SharesASavedPalette) {
  for (const std::string kind : {"gpl", "json"}) {
    const std::string saved = "p." + kind;
    const ReadPicture land =
        quantized("land.tif", "a.png", "--colors 40 --overwrite --save-palette " + saved);
    EXPECT_EQ(read_palette(path(saved)), land.table);
    const ReadPicture few = quantized("few.png", "b.png", "--overwrite --use-palette " + saved);
    EXPECT_EQ(few.table, land.table);
    // The nearest colours of that palette.
    const ReadPicture original = read_picture(path("few.png"));
    for (std::size_t i = 0; i < few.indices.size(); i += 97) {
      const auto distance = [&](Rgb8 color) {
        const glm::ivec3 step = glm::ivec3(original.colors[i]) - glm::ivec3(color);
        return step.x * step.x + step.y * step.y + step.z * step.z;
      };
      for (const Rgb8 color : land.table)
        ASSERT_GE(distance(color), distance(land.table[static_cast<std::size_t>(few.indices[i])]));
    }
  }
}

TEST_F(Quantize, WritesTheSameBytesAgain) {
  for (const std::string options : {"--dither diffusion", "--dither ordered", "--match oklab"}) {
    static_cast<void>(quantized("land.tif", "a.png", "--overwrite --colors 30 " + options));
    static_cast<void>(quantized("land.tif", "b.png", "--overwrite --colors 30 " + options));
    EXPECT_TRUE(bytes("a.png") == bytes("b.png")) << options;
  }
}

TEST_F(Quantize, SaysWhatItWrote) {
  const Finished finished = quantize("holes.png -o a.png --colors 64");
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.err, "wrote a.png: 63 colours and nodata\n");
  EXPECT_EQ(outputs(), Names{"a.png"});
}

struct BadLine {
  std::string line;
  std::vector<std::string> parts;
};

TEST_F(Quantize, RefusesInOneLineAndWritesNothing) {
  write_picture("float.tif", "GTiff", 1, GDT_Float32, [](int x, int, int) { return x; });
  write_text(path("bad.gpl"), "GIMP Palette\n1 2\n");
  write_text(path("bad.json"), "{\"colors\": [[1, 2, 300]]}");
  write_text(path("none.json"), "{\"colors\": []}");
  const Names inputs = outputs();
  for (const BadLine& bad : std::vector<BadLine>{
           {"land.tif", {"-o"}},
           {"-o a.png", {"IN"}},
           {"gone.tif -o a.png", {"gone.tif", "cannot be opened"}},
           {"bad.gpl -o a.png", {"bad.gpl", "cannot be opened"}},
           {"float.tif -o a.png", {"float.tif", "Float32", "gdal_translate"}},
           {"land.tif -o a.xyz", {"a.xyz", "'xyz'", "png"}},
           {"land.tif -o a", {"'a'", "png"}},
           {"land.tif -o a.png --of bmp2", {"bmp2"}},
           {"land.tif -o land.tif --overwrite", {"land.tif", "input"}},
           {"land.tif -o no/a.png", {"no/a.png", "folder"}},
           {"land.tif -o a.png --colors 1", {"--colors 1", "2 to 65536"}},
           {"land.tif -o a.png --colors 65537", {"65536"}},
           {"land.tif -o a.png --colors 2.5", {"--colors 2.5", "whole"}},
           {"land.tif -o a.png --colors many", {"--colors", "many"}},
           {"land.tif -o a.png --method magic", {"--method", "magic"}},
           {"land.tif -o a.png --method fixed --order error", {"--order", "tree"}},
           {"land.tif -o a.png --match leaf --dither ordered", {"--match leaf", "rgb"}},
           {"land.tif -o a.png --method fixed --match leaf", {"--match leaf", "rgb"}},
           {"land.tif -o a.png --use-palette p.gpl --colors 9", {"--use-palette", "colours"}},
           {"land.tif -o a.png --use-palette p.gpl", {"p.gpl", "cannot be read"}},
           {"land.tif -o a.png --use-palette bad.gpl", {"bad.gpl", "line 2"}},
           {"land.tif -o a.png --use-palette bad.json", {"bad.json", "entry 0", "255"}},
           {"land.tif -o a.png --use-palette none.json", {"none.json", "0 colours"}},
           {"land.tif -o a.png --use-palette land.tif", {"land.tif", "no palette"}},
           {"land.tif -o a.png --save-palette p.txt", {"p.txt", ".gpl"}},
           {"land.tif -o a.json --of png --save-palette ./a.json", {"a.json", "two outputs"}},
           {"land.tif -o a.png --co NONSENSE=1", {"--co", "NONSENSE"}}}) {
    SCOPED_TRACE(bad.line);
    expect_refused(quantize(bad.line), bad.parts);
    EXPECT_EQ(outputs(), inputs);
  }
}

TEST_F(Quantize, ReplacesAnOutputOnlyWhenAsked) {
  write_text(path("a.png"), "precious");
  write_text(path("p.gpl"), "precious too");
  expect_refused(quantize("land.tif -o a.png"), {"a.png", "--overwrite"});
  expect_refused(quantize("land.tif -o b.png --save-palette p.gpl"), {"p.gpl", "--overwrite"});
  EXPECT_EQ(bytes("a.png") + bytes("p.gpl"), "preciousprecious too");
  EXPECT_EQ(quantize("land.tif -q -o a.png --save-palette p.gpl --overwrite").exit_code, 0);
  EXPECT_EQ(outputs(), (Names{"a.png", "p.gpl"}));
}

TEST_F(Quantize, RefusesABrokenPictureWithOneLine) {
  const std::string whole = bytes("land.tif");
  write_text(path("half.tif"), whole.substr(0, whole.size() / 2));
  const Finished finished = quantize("half.tif -o a.png");
  expect_refused(finished, {"half.tif", "cannot be"});
  EXPECT_EQ(outputs(), Names{"half.tif"});
}

TEST_F(Quantize, NoticesAFullDisk) {
  for (const std::string name : {"full.tif", "full.png", "full.gif", "full.ppm", "full.jpg"}) {
    SCOPED_TRACE(name);
    const FullDisk disk(1500);
    const Finished finished = quantize("land.tif -q -o " + name);
    EXPECT_EQ(finished.exit_code, 1);
    EXPECT_TRUE(says(finished.err, {"terrview: 'full.", "writing failed"}));
    EXPECT_EQ(finished.err.find('\n'), finished.err.size() - 1) << finished.err;
    EXPECT_EQ(outputs(), Names());
  }
}

}  // namespace
}  // namespace terrview
