#include "render/image_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "render/color_ramp.h"
#include "render/write_file.h"
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
    else if (key == "zlevel" && format == "png") {
      spec.attribute("compression", "default");
      spec.attribute("png:compressionLevel", whole_number(name, value, 0, 9));
    } else if (key == "compress" && format == "tiff")
      spec.attribute("compression", compression_of(value));
    else
      throw InputError("--co " + name + "=" + value + ": no such option for " + format +
                       ": QUALITY is for jpg and webp, ZLEVEL for png, COMPRESS for tif");
  }
}

// The same picture makes the same bytes: neither OpenImageIO's version nor the time goes into it.
void apply_metadata(OIIO::ImageSpec& spec, const std::string& format,
                    const std::map<std::string, std::string>& metadata) {
  spec.attribute("Software", "terrview");
  if (format == "openexr") spec.attribute("DateTime", "");
  // An unknown date, as Exif writes it.
  if (format == "tiff") spec.attribute("DateTime", "    :  :     :  :  ");
  std::string description;
  for (const auto& [key, value] : metadata) {
    spec.attribute(key, value);
    description += (description.empty() ? "" : "\n") + value;
  }
  // These keep no text but under names of their own.
  if (!description.empty() && (format == "tiff" || format == "jpeg"))
    spec.attribute("ImageDescription", description);
}

void apply_dpi(OIIO::ImageSpec& spec, double dpi) {
  if (dpi <= 0) return;
  spec.attribute("XResolution", static_cast<float>(dpi));
  spec.attribute("YResolution", static_cast<float>(dpi));
  spec.attribute("ResolutionUnit", "in");
}

constexpr int kPngFilterSub = 0x10;  // libpng's PNG_FILTER_SUB

OIIO::ImageSpec image_spec(glm::ivec2 size_px, const std::string& format,
                           const ImageFileOptions& options) {
  const bool linear = format == "openexr";
  OIIO::ImageSpec spec(size_px.x, size_px.y, 3, linear ? OIIO::TypeFloat : OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  if (format == "png") {
    // Landscapes come out 1 to 13 % larger, maps a quarter, than where zlib also looks for bytes
    // repeated far away, in a third of the time.
    spec.attribute("png:filter", kPngFilterSub);
    spec.attribute("compression", "rle");
  }
  apply_metadata(spec, format, options.metadata);
  apply_dpi(spec, options.dpi);
  apply_creation(spec, format, options.creation);
  return spec;
}

// What the formats and their libraries allow; libjpeg would end the program.
void check_size(glm::ivec2 size_px, const std::string& format) {
  static const std::map<std::string, int> kLongestSide_px{
      {"jpeg", 65500}, {"png", 1'000'000}, {"webp", 16383}};
  const auto limit = kLongestSide_px.find(format);
  const int side_px = std::max(size_px.x, size_px.y);
  if (limit != kLongestSide_px.end() && side_px > limit->second)
    throw InputError("--size: " + std::to_string(size_px.x) + "x" + std::to_string(size_px.y) +
                     ": a " + format + " picture has at most " + std::to_string(limit->second) +
                     " pixels a side: choose .tif or .exr");
}

std::unique_ptr<OIIO::ImageOutput> create(const std::string& format) {
  auto output = OIIO::ImageOutput::create(format);
  if (!output)
    throw InputError("this build cannot write " + format + ": choose another extension (" +
                     OIIO::geterror() + ")");
  return output;
}

template <class Value>
void write_pixels(OIIO::ImageOutput& output, const std::string& path, const OIIO::ImageSpec& spec,
                  const std::vector<Value>& values) {
  const OIIO::TypeDesc type = OIIO::BaseTypeFromC<Value>::value;
  if (!output.open(path, spec) || !output.write_image(type, values.data()) || !output.close())
    throw std::runtime_error(output.geterror());
}

// The bytes of a file; `path` is for the library's messages.
template <class Value>
std::string encode_picture(const std::string& path, const std::string& format, OIIO::ImageSpec spec,
                           const std::vector<Value>& values) {
  OIIO::Filesystem::IOVecOutput memory;
  OIIO::Filesystem::IOProxy* proxy = &memory;
  spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  write_pixels(*create(format), path, spec, values);
  const std::vector<unsigned char>& bytes = memory.buffer();
  return {bytes.begin(), bytes.end()};
}

template <class Value>
void write_picture(const std::string& path, const std::string& format, const OIIO::ImageSpec& spec,
                   const std::vector<Value>& values) {
  // OpenImageIO 2.4 writes broken TIFF to memory, and libtiff notices a full disk by itself.
  if (format == "tiff") return write_pixels(*create(format), path, spec, values);
  write_file(path, encode_picture(path, format, spec, values));
}

}  // namespace

void check_image_file(const std::string& path, glm::ivec2 size_px,
                      const ImageFileOptions& options) {
  const std::string format = format_of(path, options.format);
  static_cast<void>(image_spec(size_px, format, options));
  check_size(size_px, format);
}

void write_image(const std::string& path, const Image& image, const ImageFileOptions& options) {
  const std::string format = format_of(path, options.format);
  const OIIO::ImageSpec spec = image_spec({image.width_px(), image.height_px()}, format, options);
  if (format == "openexr") {
    std::vector<float> values;
    values.reserve(image.pixels().size() * 3);
    for (const glm::vec3& pixel : image.pixels())
      values.insert(values.end(), &pixel.x, &pixel.x + 3);
    write_picture(path, format, spec, values);
  } else {
    write_picture(path, format, spec, to_srgb8(image.pixels()));
  }
}

std::string encode_jpeg(const Image& image, int quality) {
  const OIIO::ImageSpec spec = image_spec({image.width_px(), image.height_px()}, "jpeg",
                                          {.creation = {{"QUALITY", std::to_string(quality)}}});
  return encode_picture("picture.jpg", "jpeg", spec, to_srgb8(image.pixels()));
}

void write_exr(const std::string& path, glm::ivec2 size_px,
               const std::vector<FloatChannel>& channels,
               const std::map<std::string, std::string>& metadata) {
  const std::size_t count = channels.size();
  OIIO::ImageSpec spec(size_px.x, size_px.y, static_cast<int>(count), OIIO::TypeFloat);
  spec.channelnames.clear();
  for (const FloatChannel& channel : channels) spec.channelnames.push_back(channel.name);
  apply_metadata(spec, "openexr", metadata);
  const std::size_t pixels =
      static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y);
  std::vector<float> values(pixels * count);
  for (std::size_t c = 0; c < count; ++c) {
    for (std::size_t p = 0; p < pixels; ++p) values[p * count + c] = channels[c].values[p];
  }
  write_picture(path, "openexr", spec, values);
}

}  // namespace terrview
