// A quantiser, as the benchmark sees it: from pixels to a palette and indices, without dithering.
//
// To add one, append it in terrview_quantizers() or give it a function like gdal_quantizers().
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/quantize/picture.h"

namespace terrview {

// One picture and number of colours, set up for a contender: what is not timed is done.
class QuantizeJob {
 public:
  virtual ~QuantizeJob() = default;

  // What is timed.
  virtual void run() = 0;

  // Of the last run.
  [[nodiscard]] virtual Rewritten result() = 0;
};

struct QuantizeContender {
  std::string name;
  int max_colors;
  std::function<std::unique_ptr<QuantizeJob>(const Picture&, int colors)> prepare;
};

[[nodiscard]] std::vector<QuantizeContender> terrview_quantizers();

// GDALComputeMedianCutPCT. `gdal-median-cut` rewrites with GDALDitherRGB2PCT, which always dithers:
// its time is GDAL's own, and its result is replaced by the nearest colours of its palette.
// `gdal-palette` is timed without rewriting.
[[nodiscard]] std::vector<QuantizeContender> gdal_quantizers();

// libimagequant at its default speed and at its fastest; none where it is not installed.
[[nodiscard]] std::vector<QuantizeContender> imagequant_quantizers();

}  // namespace terrview
