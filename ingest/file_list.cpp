#include "ingest/file_list.h"

#include <set>

#include <cpl_string.h>
#include <gdal_priv.h>

#include "ingest/gdal_scope.h"

namespace terrview {

std::vector<std::string> files_of(const std::string& path) {
  const GdalScope silence;
  const GDALDatasetUniquePtr dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_VECTOR | GDAL_OF_READONLY));
  std::set<std::string> others;
  if (dataset) {
    const CPLStringList list(dataset->GetFileList());
    for (int i = 0; i < list.size(); ++i) others.insert(list[i]);
  }
  others.erase(path);
  std::vector<std::string> files{path};
  files.insert(files.end(), others.begin(), others.end());
  return files;
}

}  // namespace terrview
