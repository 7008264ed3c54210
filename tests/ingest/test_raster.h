// Small rasters that tests write themselves, and what reading them says.
#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ingest/dem.h"
#include "tests/support/temporary_folder.h"

namespace terrview {

struct TestRaster {
  int columns = 5;
  int rows = 4;
  int bands = 1;
  GDALDataType type = GDT_Float32;
  std::function<double(int column, int row)> number = [](int column, int row) {
    return 100.0 + 10 * column + row;
  };
  std::optional<std::array<double, 6>> geotransform = {{400000, 50, 0, 5300000, 0, -50}};
  std::string crs = "EPSG:32632";
  std::optional<double> nodata;
  std::optional<double> scale;
  std::optional<double> offset;
  std::string unit;
  std::vector<std::pair<std::string, std::string>> metadata;
  std::vector<std::string> creation_options;

  // Anything else that a test does to the raster before it is written.
  std::function<void(GDALDataset&)> change;

  // Writes the file and returns its path. The driver is GDAL's short name.
  std::string write(const std::string& path, const std::string& driver = "GTiff") const;
};

// Writes the mosaic that gdalbuildvrt makes of `paths` (there the last wins) and returns `path`.
std::string build_vrt(const std::string& path, const std::vector<std::string>& paths);

// Of the files in a folder.
[[nodiscard]] std::set<std::string> names_in(const std::filesystem::path& folder);

void write_text(const std::string& path, const std::string& text);
[[nodiscard]] std::string read_text(const std::string& path);

// The only Dem of a file.
[[nodiscard]] Dem read_one(const std::string& path, const DemOptions& options = {});

// The message with which reading is refused; empty if it is not.
[[nodiscard]] std::string refusal(const std::vector<std::string>& paths,
                                  const DemOptions& options = {});

// Whether `text` holds every one of `parts`.
[[nodiscard]] testing::AssertionResult says(const std::string& text,
                                            const std::vector<std::string>& parts);

// A file of the shared test data: the folder named by TERRVIEW_TEST_DATA, or that beside the
// source. Throws where the file is missing.
[[nodiscard]] std::string shared_data(const std::string& name);
[[nodiscard]] bool has_shared_data();

}  // namespace terrview

// The one reason to skip a test: the whole folder of the shared data is not here.
#define NEEDS_SHARED_DATA() \
  if (!terrview::has_shared_data()) GTEST_SKIP() << "the shared test data is not here"
