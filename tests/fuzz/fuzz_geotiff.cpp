#include "tests/fuzz/fuzz_raster.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  terrview::fuzz_raster(data, size, "GTiff", ".tif");
  return 0;
}
