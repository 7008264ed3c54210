#include "render/image_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>

#include <OpenImageIO/imageio.h>

#include "render/color_ramp.h"
#include "terrain/error.h"

namespace terrview {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// OpenImageIO's name of a format, from an extension or from GDAL's name.
std::string format_of(const std::string& path, const std::string& format) {
  static const std::map<std::string, std::string> kFormats{
      {"png", "png"},    {"jpg", "jpeg"},    {"jpeg", "jpeg"}, {"tif", "tiff"}, {"tiff", "tiff"},
      {"gtiff", "tiff"}, {"exr", "openexr"}, {"webp", "webp"}, {"ppm", "pnm"},  {"pnm", "pnm"}};
  std::string key = lower(format);
  if (key.empty()) {
    key = lower(std::filesystem::path(path).extension().string());
    if (!key.empty()) key.erase(0, 1);
  }
  const auto found = kFormats.find(key);
  if (found == kFormats.end())
    throw InputError("'" + (format.empty() ? path : format) +
                     "': no known picture format: end the name in .png, .jpg, .tif, .exr, .webp or "
                     ".ppm, or name one with --of");
  return found->second;
}

std::string compression_of(const std::string& gdal_name) {
  static const std::map<std::string, std::string> kNames{
      {"none", "none"}, {"deflate", "zip"}, {"lzw", "lzw"}, {"packbits", "packbits"}};
  const auto found = kNames.find(lower(gdal_name));
  if (found == kNames.end())
    throw InputError("--co COMPRESS=" + gdal_name +
                     ": unknown: use NONE, DEFLATE, LZW or PACKBITS");
  return found->second;
}

int whole_number(const std::string& key, const std::string& value, int lowest, int highest) {
  std::size_t used = 0;
  int number = lowest - 1;
  try {
    number = std::stoi(value, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used != value.size() || number < lowest || number > highest)
    throw InputError("--co " + key + "=" + value + ": give a whole number from " +
                     std::to_string(lowest) + " to " + std::to_string(highest));
  return number;
}

// Turns GDAL's creation options into OpenImageIO's attributes.
void apply_creation(OIIO::ImageSpec& spec, const std::string& format,
                    const std::map<std::string, std::string>& creation) {
  for (const auto& [name, value] : creation) {
    const std::string key = lower(name);
    if (key == "quality" && (format == "jpeg" || format == "webp"))
      spec.attribute("Compression",
                     format + ":" + std::to_string(whole_number(name, value, 1, 100)));
    else if (key == "zlevel" && format == "png")
      spec.attribute("png:compressionLevel", whole_number(name, value, 0, 9));
    else if (key == "compress" && format == "tiff")
      spec.attribute("compression", compression_of(value));
    else
      throw InputError("--co " + name + "=" + value + ": no such option for " + format +
                       ": QUALITY is for jpg and webp, ZLEVEL for png, COMPRESS for tif");
  }
}

OIIO::ImageSpec image_spec(int width_px, int height_px, const std::string& format,
                           const ImageFileOptions& options) {
  const bool linear = format == "openexr";
  OIIO::ImageSpec spec(width_px, height_px, 3, linear ? OIIO::TypeFloat : OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  // Without a name of its own OpenImageIO would write its version here.
  spec.attribute("Software", "terrview");
  for (const auto& [key, value] : options.metadata) spec.attribute(key, value);
  apply_creation(spec, format, options.creation);
  return spec;
}

std::unique_ptr<OIIO::ImageOutput> open(const std::string& path, const std::string& format,
                                        const OIIO::ImageSpec& spec) {
  auto output = OIIO::ImageOutput::create(format);
  if (!output)
    throw InputError("'" + path + "': this build cannot write " + format +
                     ": choose another extension (" + OIIO::geterror() + ")");
  if (!output->open(path, spec))
    throw InputError("'" + path + "': cannot be written: " + output->geterror());
  return output;
}

template <class Value>
void write_pixels(const std::string& path, OIIO::ImageOutput& output, OIIO::TypeDesc type,
                  const std::vector<Value>& values) {
  if (!output.write_image(type, values.data()) || !output.close())
    throw std::runtime_error("'" + path + "': writing failed: " + output.geterror());
}

std::vector<std::uint8_t> srgb_bytes(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels().size() * 3);
  for (const glm::vec3& pixel : image.pixels()) {
    for (int i = 0; i < 3; ++i)
      bytes.push_back(static_cast<std::uint8_t>(std::lround(to_srgb(pixel[i]) * 255)));
  }
  return bytes;
}

}  // namespace

void check_image_file(const std::string& path, const ImageFileOptions& options) {
  const std::string format = format_of(path, options.format);
  static_cast<void>(image_spec(1, 1, format, options));
}

void write_image(const std::string& path, const Image& image, const ImageFileOptions& options) {
  const std::string format = format_of(path, options.format);
  const OIIO::ImageSpec spec = image_spec(image.width_px(), image.height_px(), format, options);
  const auto output = open(path, format, spec);
  if (format == "openexr") {
    std::vector<float> values;
    values.reserve(image.pixels().size() * 3);
    for (const glm::vec3& pixel : image.pixels())
      values.insert(values.end(), &pixel.x, &pixel.x + 3);
    write_pixels(path, *output, OIIO::TypeFloat, values);
  } else {
    write_pixels(path, *output, OIIO::TypeUInt8, srgb_bytes(image));
  }
}

void write_exr(const std::string& path, int width_px, int height_px,
               const std::vector<FloatChannel>& channels,
               const std::map<std::string, std::string>& metadata) {
  const std::size_t count = channels.size();
  OIIO::ImageSpec spec(width_px, height_px, static_cast<int>(count), OIIO::TypeFloat);
  spec.channelnames.clear();
  for (const FloatChannel& channel : channels) spec.channelnames.push_back(channel.name);
  spec.attribute("Software", "terrview");
  for (const auto& [key, value] : metadata) spec.attribute(key, value);
  const std::size_t pixels =
      static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  std::vector<float> values(pixels * count);
  for (std::size_t c = 0; c < count; ++c) {
    for (std::size_t p = 0; p < pixels; ++p) values[p * count + c] = channels[c].values[p];
  }
  const auto output = open(path, "openexr", spec);
  write_pixels(path, *output, OIIO::TypeFloat, values);
}

}  // namespace terrview
