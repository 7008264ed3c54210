// One test per promise of render/image_file.h and render/write_file.h; OpenImageIO reads back.
#include "render/image_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "render/write_file.h"
#include "terrain/error.h"
#include "tests/support/temporary_folder.h"

namespace terrview {
namespace {

const std::string kText = R"({"camera":{"heading":12.5},"dems":["a b.tif"]})";

double linear_of(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

// Grey levels 0 to 255 from left to right, and a darker red below; row 0 at the top.
Image levels() {
  Image image(256, 3);
  for (int column = 0; column < 256; ++column) {
    const auto level = static_cast<float>(linear_of(column / 255.0));
    image.at(column, 0) = glm::vec3(level);
    image.at(column, 1) = {level, 0, 1};
    image.at(column, 2) = {0, level / 4, 0};
  }
  return image;
}

// Row by row, interleaved; expects 3 channels.
template <class Value>
std::vector<Value> read_pixels(const std::string& path, OIIO::TypeDesc type) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input || input->spec().nchannels != 3) {
    ADD_FAILURE() << path << ": " << OIIO::geterror();
    return {};
  }
  const OIIO::ImageSpec& spec = input->spec();
  std::vector<Value> values(static_cast<std::size_t>(spec.width * spec.height * 3));
  EXPECT_TRUE(input->read_image(0, 0, 0, 3, type, values.data()));
  return values;
}

std::string attribute(const std::string& path, const std::string& name) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) return "unreadable";
  return std::string(input->spec().get_string_attribute(name));
}

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class LosslessFormat : public testing::TestWithParam<const char*> {};

TEST_P(LosslessFormat, HoldsTheSrgbBytesExactly) {
  const TemporaryFolder folder;
  const std::string path = folder / (std::string("levels.") + GetParam());
  write_image(path, levels(), {});
  const auto bytes = read_pixels<std::uint8_t>(path, OIIO::TypeUInt8);
  ASSERT_EQ(bytes.size(), 256U * 3 * 3);
  for (std::size_t column = 0; column < 256; ++column) {
    const std::size_t top = column * 3;
    const std::size_t middle = (256 + column) * 3;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(bytes[top + i], column);
    EXPECT_EQ(bytes[middle], column);
    EXPECT_EQ(bytes[middle + 1], 0);
    EXPECT_EQ(bytes[middle + 2], 255);
  }
}

INSTANTIATE_TEST_SUITE_P(ImageFile, LosslessFormat,
                         testing::Values("png", "tif", "tiff", "ppm", "pnm", "PNG"),
                         [](const auto& format) { return std::string(format.param); });

class LossyFormat : public testing::TestWithParam<const char*> {};

TEST_P(LossyFormat, HoldsThePictureAsTheEyeSeesIt) {
  const TemporaryFolder folder;
  const std::string path = folder / (std::string("grey.") + GetParam());
  Image image(64, 32);
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 64; ++column)
      image.at(column, row) =
          glm::vec3(static_cast<float>(linear_of((row < 16 ? 40 : 200) / 255.0)));
  }
  write_image(path, image, {});
  const auto bytes = read_pixels<std::uint8_t>(path, OIIO::TypeUInt8);
  ASSERT_EQ(bytes.size(), 64U * 32 * 3);
  EXPECT_NEAR(bytes[3 * (64 * 5 + 20)], 40, 4);
  EXPECT_NEAR(bytes[3 * (64 * 25 + 20)], 200, 4);
}

INSTANTIATE_TEST_SUITE_P(ImageFile, LossyFormat, testing::Values("jpg", "jpeg", "webp"),
                         [](const auto& format) { return std::string(format.param); });

TEST(ExrFile, HoldsLinearFloats) {
  const TemporaryFolder folder;
  const std::string path = folder / "picture.exr";
  Image image(5, 4, {0.1F, 0.25F, 3.5F});
  image.at(4, 1) = {0, 1e-4F, 12};
  write_image(path, image, {});
  const auto values = read_pixels<float>(path, OIIO::TypeFloat);
  ASSERT_EQ(values.size(), 60U);
  for (std::size_t pixel = 0; pixel < 20; ++pixel) {
    const glm::vec3 read(values[3 * pixel], values[3 * pixel + 1], values[3 * pixel + 2]);
    EXPECT_EQ(read, image.pixels()[pixel]) << pixel;
  }
}

TEST(ExrFile, HoldsNamedChannelsWithNanForNothing) {
  const TemporaryFolder folder;
  const std::string path = folder / "layers.exr";
  const float nan = std::numeric_limits<float>::quiet_NaN();
  write_exr(path, {2, 2}, {{"distance", {1, 2, nan, 4}}, {"E", {-5, 6.5F, nan, 1e9F}}},
            {{"terrview:camera", kText}});
  const auto input = OIIO::ImageInput::open(path);
  ASSERT_TRUE(input);
  const OIIO::ImageSpec& spec = input->spec();
  ASSERT_EQ(spec.nchannels, 2);
  EXPECT_EQ(spec.channelformat(0), OIIO::TypeFloat);
  std::vector<float> values(8);
  ASSERT_TRUE(input->read_image(0, 0, 0, 2, OIIO::TypeFloat, values.data()));
  const auto distance = static_cast<std::size_t>(spec.channelindex("distance"));
  const auto east = static_cast<std::size_t>(spec.channelindex("E"));
  EXPECT_EQ(values[distance], 1);
  EXPECT_EQ(values[2 + east], 6.5F);
  EXPECT_TRUE(std::isnan(values[4 + distance]));
  EXPECT_EQ(values[6 + east], 1e9F);
  EXPECT_EQ(attribute(path, "terrview:camera"), kText);
}

TEST(ImageFile, KeepsItsTextWhereTheFormatKeepsAny) {
  const TemporaryFolder folder;
  for (const std::string name : {"a.png", "a.exr", "a.tif", "a.jpg"}) {
    write_image(folder / name, levels(), {.metadata = {{"terrview:view", kText}}});
    const bool has_names = name == "a.png" || name == "a.exr";
    EXPECT_EQ(attribute(folder / name, has_names ? "terrview:view" : "ImageDescription"), kText)
        << name;
    EXPECT_EQ(attribute(folder / name, "Software"), "terrview") << name;
  }
}

TEST(ImageFile, KnowsItsSizeOnPaper) {
  const TemporaryFolder folder;
  for (const std::string extension : {"png", "jpg", "tif"}) {
    const std::string path = folder / ("a." + extension);
    write_image(path, levels(), {.dpi = 300});
    const auto input = OIIO::ImageInput::open(path);
    ASSERT_TRUE(input);
    const std::string unit = input->spec().get_string_attribute("ResolutionUnit");
    const double per_inch = unit == "cm" ? 2.54 : unit == "m" ? 0.0254 : 1;
    for (const char* name : {"XResolution", "YResolution"})
      EXPECT_NEAR(input->spec().get_float_attribute(name) * per_inch, 300, 0.01) << extension;
  }
}

TEST(ImageFile, HasTheSameBytesASecondLater) {
  const TemporaryFolder folder;
  const std::vector<std::string> extensions{"png", "jpg", "tif", "exr", "ppm", "webp"};
  for (const std::string& extension : extensions)
    write_image(folder / ("a." + extension), levels(), {.metadata = {{"terrview:view", kText}}});
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  for (const std::string& extension : extensions) {
    write_image(folder / ("b." + extension), levels(), {.metadata = {{"terrview:view", kText}}});
    EXPECT_TRUE(bytes_of(folder / ("a." + extension)) == bytes_of(folder / ("b." + extension)))
        << extension;
  }
}

TEST(ImageFile, FollowsAFormatByNameOverTheExtension) {
  const TemporaryFolder folder;
  write_image(folder / "a.dat", levels(), {.format = "PNG"});
  EXPECT_EQ(bytes_of(folder / "a.dat").substr(1, 3), "PNG");
  write_image(folder / "b.png", levels(), {.format = "GTiff"});
  EXPECT_EQ(bytes_of(folder / "b.png").substr(0, 2), "II");
}

std::uintmax_t size_with(const TemporaryFolder& folder, const std::string& name,
                         const std::map<std::string, std::string>& creation) {
  write_image(folder / name, levels(), {.creation = creation});
  return std::filesystem::file_size(folder / name);
}

TEST(ImageFile, ObeysCreationOptions) {
  const TemporaryFolder folder;
  EXPECT_LT(size_with(folder, "a.jpg", {{"QUALITY", "5"}}),
            size_with(folder, "b.jpg", {{"quality", "100"}}));
  EXPECT_LT(size_with(folder, "a.webp", {{"QUALITY", "1"}}),
            size_with(folder, "b.webp", {{"QUALITY", "100"}}));
  EXPECT_LT(size_with(folder, "a.png", {{"ZLEVEL", "9"}}),
            size_with(folder, "b.png", {{"ZLEVEL", "0"}}));
  // Unasked, small files are quick ones: no match for a search at any length.
  EXPECT_LT(size_with(folder, "a.png", {{"ZLEVEL", "9"}}), size_with(folder, "c.png", {}));
  const auto plain = size_with(folder, "none.tif", {{"COMPRESS", "NONE"}});
  EXPECT_GT(plain, 256U * 3 * 3);
  for (const std::string method : {"DEFLATE", "LZW", "PackBits"})
    EXPECT_LT(size_with(folder, method + ".tif", {{"COMPRESS", method}}), plain) << method;
}

struct Refused {
  std::string path;
  ImageFileOptions options;
  glm::ivec2 size_px;
  std::string words;
};

TEST(ImageFile, IsRefusedBeforeTheWorkWithARemedy) {
  const glm::ivec2 small(64, 48);
  const std::vector<Refused> cases{
      {"a.bmp", {}, small, ".png"},
      {"a", {}, small, "--of"},
      {"a.png", {.format = "GIF"}, small, "'GIF'"},
      {"a.png", {.creation = {{"QUALITY", "5"}}}, small, "--co QUALITY=5"},
      {"a.jpg", {.creation = {{"QUALITY", "0"}}}, small, "1 to 100"},
      {"a.jpg", {.creation = {{"QUALITY", "5x"}}}, small, "1 to 100"},
      {"a.png", {.creation = {{"ZLEVEL", "10"}}}, small, "0 to 9"},
      {"a.tif", {.creation = {{"COMPRESS", "JPEG"}}}, small, "DEFLATE"},
      {"a.exr", {.creation = {{"TILED", "YES"}}}, small, "--co TILED=YES"},
      {"a.webp", {}, {16384, 1}, "16383"},
      {"a.jpg", {}, {1, 65501}, "65500"},
      {"a.png", {}, {1000001, 1}, "1000000"}};
  for (const Refused& refused : cases) {
    try {
      check_image_file(refused.path, refused.size_px, refused.options);
      ADD_FAILURE() << refused.path << " accepted, expected " << refused.words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(refused.words), std::string::npos) << error.what();
    }
  }
}

TEST(ImageFile, MayBeAsLargeAsItsFormatAllows) {
  const TemporaryFolder folder;
  for (const std::string name : {"a.webp", "a.jpg", "a.png"}) {
    const int width_px = name == "a.webp" ? 16383 : name == "a.jpg" ? 65500 : 1'000'000;
    ASSERT_NO_THROW(check_image_file(name, {width_px, 1}, {}));
    write_image(folder / name, Image(width_px, 1, glm::vec3(0.5F)), {});
    EXPECT_EQ(read_pixels<std::uint8_t>(folder / name, OIIO::TypeUInt8).size(),
              3 * static_cast<std::size_t>(width_px));
  }
}

TEST(ImageFile, SaysWhyItCannotBeWritten) {
  for (const std::string name : {"a.png", "a.jpg", "a.tif", "a.exr", "a.ppm", "a.webp"}) {
    try {
      write_image("/nonexistent/folder/" + name, levels(), {});
      ADD_FAILURE() << name;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()), "") << name;
    }
  }
}

TEST(WriteFile, WritesEveryByte) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file(folder / "bytes", bytes);
  EXPECT_EQ(bytes_of(folder / "bytes"), bytes);
  write_file(folder / "bytes", "");
  EXPECT_EQ(bytes_of(folder / "bytes"), "");
}

TEST(WriteFile, NoticesAFullDisk) {
  ASSERT_EQ(::access("/dev/full", W_OK), 0);
  try {
    write_file("/dev/full", "some bytes");
    ADD_FAILURE() << "wrote to a full disk";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "No space left on device");
  }
}

}  // namespace
}  // namespace terrview
