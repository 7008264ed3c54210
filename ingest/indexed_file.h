// Pictures with a colour table to files, line by line, through GDAL.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/fwd.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

class GDALDataset;

namespace terrview {

struct IndexedFileOptions {
  std::string format = {};  // png, tif, ... or GDAL's name for one; empty = by extension
  std::map<std::string, std::string> creation = {};  // GDAL's names and values
  // Text kept in png, under its name but with _ for colons, and as the image description in tif.
  std::map<std::string, std::string> metadata = {};
};

// What a file gets, and what is known of it before the first line.
struct IndexedPicture {
  glm::ivec2 size_px{};
  std::vector<glm::u8vec3> palette = {};
  bool has_nodata = false;       // its index is the first beyond the palette
  GDALDataset* place = nullptr;  // whose coordinates a GeoTIFF takes over
};

// Throws InputError if the format or a creation option is not known.
void check_indexed_file(const std::string& path, const IndexedFileOptions& options);

// png, gif and tif get indices and a colour table as long as it has room (256 colours, 65536 in
// tif); beyond it, and in jpg, webp and ppm, the pixels get the palette's colours themselves.
// Nodata is transparent where the format can say so and black elsewhere. Memory is bounded by
// GDAL's block cache: formats that GDAL writes only as a whole are copied from a temporary GeoTIFF
// beside `path`.
class IndexedFile {
 public:
  // Throws InputError as check_indexed_file() does, and std::runtime_error as write() does.
  IndexedFile(const std::string& path, const IndexedPicture& picture,
              const IndexedFileOptions& options);
  ~IndexedFile();
  IndexedFile(const IndexedFile&) = delete;
  IndexedFile& operator=(const IndexedFile&) = delete;

  // Whole lines from `first_line` down, in order. Throws std::runtime_error with the reason, but
  // not the path.
  void write(int first_line, std::span<const std::uint16_t> indices);

  // Completes the file, and reads it back: a full disk is noticed. `progress` gets shares from 0 to
  // 1. Throws as write() does.
  void finish(const std::function<void(double)>& progress);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace terrview
