// A GeoTIFF in GDAL's memory, and GDAL silent: its own files lose the error of a full disk.
#pragma once

#include <string>
#include <string_view>

#include <gdal_priv.h>
#include <glm/vec2.hpp>

namespace terrview {

class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  // One of its own for every living MemoryFile.
  [[nodiscard]] std::string path() const;

  // Throws as throw_if_failed().
  [[nodiscard]] GDALDatasetUniquePtr create(glm::ivec2 size, int bands, GDALDataType type,
                                            const char* const* options) const;

  [[nodiscard]] std::string_view bytes() const;

  // Throws std::runtime_error with what GDAL has complained of.
  void throw_if_failed() const;
};

}  // namespace terrview
