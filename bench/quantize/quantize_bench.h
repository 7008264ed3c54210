// terrview-bench-quantize: speed against error of every quantiser on the same pictures.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "bench/quantize/picture_errors.h"

namespace terrview {

struct QuantizeResult {
  std::string picture;
  std::string contender;
  int colors = 0;  // asked for
  std::size_t palette = 0;
  double mpixels_per_s = 0;
  PictureErrors errors;
};

// Returns the exit code. Throws InputError.
int run_quantize_bench(const std::vector<std::string>& args);

// Every number of colours: the contenders' means over the pictures.
void print_means(std::ostream& out, const std::vector<QuantizeResult>& results);

// Our tree beside GDAL and libimagequant: its error at 256 colours, its speed at 4096 beside theirs
// at 256, their most.
void print_comparison(std::ostream& out, const std::vector<QuantizeResult>& results);

}  // namespace terrview
