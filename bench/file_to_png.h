// A whole picture with shadows, from the DEM's file to the PNG's.
#pragma once

#include <string>
#include <vector>

#include "bench/bench_result.h"
#include "bench/contender.h"

namespace terrview {

// Writes plain floats behind an ESRI header, in the scene frame and without a coordinate system:
// nothing is sooner read. Returns the path. Throws std::runtime_error.
[[nodiscard]] std::string write_dem_file(const BenchDem& dem, const std::string& folder);

struct PngTask {
  std::string path;  // the file that `dem` is of
  const BenchDem& dem;
  const BenchView& view;
  int threads;
  int repetitions;
};

// Seconds for the program's own `view` command, all of it, on a flat Earth; and, for Embree's
// triangles and for its grid, of reading the same file, filling buffers, building, and tracing the
// rays in the fastest way that `measured` has for that view: no colours, no PNG. Times are of the
// wall clock. Throws std::runtime_error where the command fails.
[[nodiscard]] std::vector<BenchResult> file_to_png(const PngTask& task,
                                                   const std::vector<Contender>& contenders,
                                                   const std::vector<BenchResult>& measured);

}  // namespace terrview
