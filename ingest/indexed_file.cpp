#include "ingest/indexed_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_priv.h>

#include "ingest/gdal_scope.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr int kLinesReadBack = 64;

struct Format {
  const char* driver;
  std::array<const char*, 3> names;  // extensions, and what --of may say
  int table_size;                    // 0: no colour tables
  bool has_alpha;                    // of red, green and blue
};

constexpr std::array<Format, 6> kFormats{{{"GTiff", {"tif", "tiff", "gtiff"}, 65536, true},
                                          {"PNG", {"png"}, 256, true},
                                          {"GIF", {"gif"}, 256, false},
                                          {"JPEG", {"jpg", "jpeg"}, 0, false},
                                          {"WEBP", {"webp"}, 0, true},
                                          {"PNM", {"ppm", "pnm"}, 0, false}}};

const Format& format_of(const std::string& path, const IndexedFileOptions& options) {
  std::string name = options.format;
  if (name.empty()) {
    name = std::filesystem::path(path).extension().string();
    if (!name.empty()) name.erase(0, 1);
  }
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Format& format : kFormats)
    for (const char* known : format.names)
      if (known != nullptr && name == known) return format;
  throw InputError("'" + path + "': no picture format is called '" + name +
                   "': use png, tif, gif, jpg, webp or ppm");
}

// Every value that goes into the file, in order.
class Fingerprint {
 public:
  void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001B3U;
  }
  [[nodiscard]] bool operator==(const Fingerprint&) const = default;

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

CPLStringList list_of(const std::map<std::string, std::string>& values) {
  CPLStringList list;
  for (const auto& [key, value] : values) list.SetNameValue(key.c_str(), value.c_str());
  return list;
}

// No file of GDAL's own beside a picture.
class NoSideFiles {
 public:
  NoSideFiles() { CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", "NO"); }
  ~NoSideFiles() { CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", nullptr); }
  NoSideFiles(const NoSideFiles&) = delete;
  NoSideFiles& operator=(const NoSideFiles&) = delete;
};

std::string first_or_nothing(const std::vector<std::string>& lines) {
  return lines.empty() ? std::string() : lines.front();
}

[[noreturn]] void throw_failure(GdalScope& gdal) {
  const std::string reason = gdal.take_failure();
  throw std::runtime_error(reason.empty() ? "GDAL gives no reason" : reason);
}

}  // namespace

void check_indexed_file(const std::string& path, const IndexedFileOptions& options) {
  GdalScope gdal;
  const Format& format = format_of(path, options);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(format.driver);
  if (driver == nullptr)
    throw InputError("'" + path + "': GDAL is without its driver " + format.driver +
                     ": use another format");
  if (GDALValidateCreationOptions(driver, list_of(options.creation).List()) == FALSE)
    throw InputError("--co: " + first_or_nothing(gdal.take_warnings()) +
                     ": see gdalinfo --format " + format.driver);
}

struct IndexedFile::Impl {
  Impl(const std::string& final_path, const IndexedPicture& picture_,
       const IndexedFileOptions& options_)
      : path(final_path),
        picture(picture_),
        options(options_),
        format(format_of(final_path, options_)) {
    const std::size_t entries = picture.palette.size() + (picture.has_nodata ? 1 : 0);
    indexed = entries <= static_cast<std::size_t>(format.table_size);
    copied = std::string(format.driver) != "GTiff";
    bands = indexed ? 1 : (picture.has_nodata && format.has_alpha ? 4 : 3);
    wide = indexed && entries > 256;
    create();
  }

  ~Impl() {
    const GdalScope silent;
    dataset.reset();
    std::error_code ignored;
    if (copied) std::filesystem::remove(written_path(), ignored);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] std::string written_path() const { return copied ? path + ".tif" : path; }

  void create();
  void set_table(GDALRasterBand& band) const;
  void set_place() const;
  void copy(const std::function<void(double)>& progress);
  void read_back(const std::function<void(double)>& progress) const;
  [[nodiscard]] std::vector<std::uint8_t> bytes_of(std::span<const std::uint16_t> indices) const;

  // Lines of all bands, from or to `bytes`.
  [[nodiscard]] CPLErr transfer(GDALDataset& from, GDALRWFlag direction, int first_line, int lines,
                                std::uint8_t* bytes) const {
    const int size = wide ? 2 : 1;
    return from.RasterIO(direction, 0, first_line, picture.size_px.x, lines, bytes,
                         picture.size_px.x, lines, wide ? GDT_UInt16 : GDT_Byte, bands, nullptr,
                         GSpacing{size} * bands, GSpacing{size} * bands * picture.size_px.x, size,
                         nullptr);
  }

  std::string path;
  IndexedPicture picture;
  IndexedFileOptions options;
  Format format;
  NoSideFiles no_side_files;
  bool indexed = false;  // else red, green, blue and perhaps alpha
  bool copied = false;   // from the temporary GeoTIFF
  bool wide = false;     // indices of 16 bits
  int bands = 1;
  Fingerprint fingerprint;
  GDALDatasetUniquePtr dataset;
};

void IndexedFile::Impl::create() {
  GdalScope gdal;
  CPLStringList creation = copied ? CPLStringList() : list_of(options.creation);
  if (creation.FetchNameValue("COMPRESS") == nullptr) {
    creation.SetNameValue("COMPRESS", "DEFLATE");
    if (copied) creation.SetNameValue("ZLEVEL", "1");
  }
  creation.SetNameValue("BIGTIFF", "IF_SAFER");
  if (bands == 4) creation.SetNameValue("ALPHA", "YES");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  dataset.reset(driver->Create(written_path().c_str(), picture.size_px.x, picture.size_px.y, bands,
                               wide ? GDT_UInt16 : GDT_Byte, creation.List()));
  if (!dataset) throw_failure(gdal);
  if (indexed) set_table(*dataset->GetRasterBand(1));
  set_place();
  for (const auto& [key, value] : options.metadata) {
    std::string name = copied ? key : "TIFFTAG_IMAGEDESCRIPTION";
    std::replace(name.begin(), name.end(), ':', '_');  // to GDAL a name ends there
    dataset->SetMetadataItem(name.c_str(), value.c_str());
  }
}

void IndexedFile::Impl::set_table(GDALRasterBand& band) const {
  GDALColorTable table;
  int index = 0;
  for (const glm::u8vec3 color : picture.palette) {
    const GDALColorEntry entry{color.r, color.g, color.b, 255};
    table.SetColorEntry(index++, &entry);
  }
  if (picture.has_nodata) {
    const GDALColorEntry entry{0, 0, 0, 0};
    table.SetColorEntry(index, &entry);
    band.SetNoDataValue(index);
  }
  band.SetColorTable(&table);
}

void IndexedFile::Impl::set_place() const {
  if (picture.place == nullptr) return;
  std::array<double, 6> transform{};
  if (picture.place->GetGeoTransform(transform.data()) == CE_None)
    dataset->SetGeoTransform(transform.data());
  if (picture.place->GetSpatialRef() != nullptr)
    dataset->SetSpatialRef(picture.place->GetSpatialRef());
}

// Indices of 16 bits as the machine has them, indices of 8 bits, or colours.
std::vector<std::uint8_t> IndexedFile::Impl::bytes_of(
    std::span<const std::uint16_t> indices) const {
  std::vector<std::uint8_t> bytes;
  if (wide) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(indices.data());
    bytes.assign(first, first + indices.size_bytes());
    return bytes;
  }
  bytes.reserve(indices.size() * static_cast<std::size_t>(bands));
  if (indexed) {
    for (const std::uint16_t index : indices) bytes.push_back(static_cast<std::uint8_t>(index));
    return bytes;
  }
  for (const std::uint16_t index : indices) {
    const bool is_nodata = picture.has_nodata && index == picture.palette.size();
    const glm::u8vec3 color = is_nodata ? glm::u8vec3(0) : picture.palette[index];
    bytes.insert(bytes.end(), {color.r, color.g, color.b});
    if (bands == 4) bytes.push_back(is_nodata ? 0 : 255);
  }
  return bytes;
}

// GDAL's progress function for a std::function: an exception must not pass through GDAL.
struct Reporter {
  const std::function<void(double)>& report;
  std::exception_ptr error = nullptr;

  static int call(double share, const char*, void* self) {
    auto& reporter = *static_cast<Reporter*>(self);
    try {
      reporter.report(share);
      return TRUE;
    } catch (...) {
      reporter.error = std::current_exception();
      return FALSE;
    }
  }
};

void IndexedFile::Impl::copy(const std::function<void(double)>& progress) {
  GdalScope gdal;
  CPLStringList creation = list_of(options.creation);
  if (std::string(format.driver) == "PNG" && !options.metadata.empty())
    creation.SetNameValue("WRITE_METADATA_AS_TEXT", "YES");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(format.driver);
  GDALDatasetUniquePtr source(GDALDataset::Open(written_path().c_str()));
  if (!source) throw_failure(gdal);
  // A TIFF's table always has 256 entries or 65536; the copy's shall have those that are used.
  GDALDatasetUniquePtr exact(GetGDALDriverManager()->GetDriverByName("VRT")->CreateCopy(
      "", source.get(), FALSE, nullptr, nullptr, nullptr));
  if (!exact) throw_failure(gdal);
  if (indexed) set_table(*exact->GetRasterBand(1));
  Reporter reporter{progress};
  GDALDatasetUniquePtr result(driver->CreateCopy(path.c_str(), exact.get(), FALSE, creation.List(),
                                                 &Reporter::call, &reporter));
  if (reporter.error) std::rethrow_exception(reporter.error);
  if (!result) throw_failure(gdal);
  result.reset();
  if (const std::string reason = gdal.take_failure(); !reason.empty())
    throw std::runtime_error(reason);
}

void IndexedFile::Impl::read_back(const std::function<void(double)>& progress) const {
  GdalScope gdal;
  const GDALDatasetUniquePtr result(GDALDataset::Open(path.c_str()));
  if (!result || result->GetRasterCount() < bands) throw_failure(gdal);
  Fingerprint found;
  const std::size_t line_bytes = static_cast<std::size_t>(picture.size_px.x) *
                                 static_cast<std::size_t>(bands * (wide ? 2 : 1));
  std::vector<std::uint8_t> bytes(line_bytes * kLinesReadBack);
  for (int line = 0; line < picture.size_px.y; line += kLinesReadBack) {
    const int lines = std::min(kLinesReadBack, picture.size_px.y - line);
    if (transfer(*result, GF_Read, line, lines, bytes.data()) != CE_None) throw_failure(gdal);
    found.add(std::span(bytes).first(line_bytes * static_cast<std::size_t>(lines)));
    progress(static_cast<double>(line + lines) / picture.size_px.y);
  }
  const std::string driver = format.driver;
  const bool exact = driver != "JPEG" && driver != "WEBP";
  if (exact && !(found == fingerprint))
    throw std::runtime_error("the file does not hold what was written to it");
}

IndexedFile::IndexedFile(const std::string& path, const IndexedPicture& picture,
                         const IndexedFileOptions& options)
    : impl_(std::make_unique<Impl>(path, picture, options)) {}

IndexedFile::~IndexedFile() = default;

void IndexedFile::write(int first_line, std::span<const std::uint16_t> indices) {
  GdalScope gdal;
  std::vector<std::uint8_t> bytes = impl_->bytes_of(indices);
  impl_->fingerprint.add(bytes);
  const auto lines =
      static_cast<int>(indices.size() / static_cast<std::size_t>(impl_->picture.size_px.x));
  if (impl_->transfer(*impl_->dataset, GF_Write, first_line, lines, bytes.data()) != CE_None)
    throw_failure(gdal);
}

void IndexedFile::finish(const std::function<void(double)>& progress) {
  {
    GdalScope gdal;
    impl_->dataset.reset();
    if (const std::string reason = gdal.take_failure(); !reason.empty())
      throw std::runtime_error(reason);
  }
  if (impl_->copied) impl_->copy([&](double share) { progress(share / 2); });
  impl_->read_back([&](double share) { progress(impl_->copied ? (1 + share) / 2 : share); });
}

}  // namespace terrview
