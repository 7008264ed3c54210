// Files in GDAL's memory: its own lose the error of a full disk.
#pragma once

#include <string>
#include <string_view>

#include <gdal_priv.h>
#include <glm/vec2.hpp>

namespace terrview {

// A name for a file, which goes when the name does.
class MemoryName {
 public:
  explicit MemoryName(const char* extension) : extension_(extension) {}
  ~MemoryName();
  MemoryName(const MemoryName&) = delete;
  MemoryName& operator=(const MemoryName&) = delete;

  // One of its own for every living MemoryName.
  [[nodiscard]] std::string path() const;

  // Of the file; empty = there is none.
  [[nodiscard]] std::string_view bytes() const;

 private:
  const char* extension_;
};

// A GeoTIFF, and GDAL silent.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::string path() const { return name_.path(); }

  // Throws as throw_if_failed().
  [[nodiscard]] GDALDatasetUniquePtr create(glm::ivec2 size, int bands, GDALDataType type,
                                            const char* const* options) const;

  [[nodiscard]] std::string_view bytes() const { return name_.bytes(); }

  // Throws std::runtime_error with what GDAL has complained of.
  void throw_if_failed() const;

 private:
  MemoryName name_{".tif"};
};

}  // namespace terrview
