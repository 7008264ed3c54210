#include "ingest/memory_file.h"

#include <cstdint>
#include <stdexcept>

#include <cpl_error.h>
#include <cpl_vsi.h>

namespace terrview {

MemoryName::~MemoryName() { VSIUnlink(path().c_str()); }

std::string MemoryName::path() const {
  return "/vsimem/terrview_" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + extension_;
}

std::string_view MemoryName::bytes() const {
  vsi_l_offset size = 0;
  const GByte* data = VSIGetMemFileBuffer(path().c_str(), &size, FALSE);
  return {reinterpret_cast<const char*>(data), static_cast<std::size_t>(size)};
}

MemoryFile::MemoryFile() {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLErrorReset();
}

MemoryFile::~MemoryFile() { CPLPopErrorHandler(); }

GDALDatasetUniquePtr MemoryFile::create(glm::ivec2 size, int bands, GDALDataType type,
                                        const char* const* options) const {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDatasetUniquePtr dataset(
      driver->Create(path().c_str(), size.x, size.y, bands, type, const_cast<char**>(options)));
  throw_if_failed();
  // Libtiff's complaints are lost where another library has taken over its error handler.
  if (!dataset) throw std::runtime_error("GDAL makes no such file");
  return dataset;
}

void MemoryFile::throw_if_failed() const {
  if (CPLGetLastErrorType() >= CE_Failure) throw std::runtime_error(CPLGetLastErrorMsg());
}

}  // namespace terrview
