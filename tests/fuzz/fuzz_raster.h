// What the fuzzers of raster formats share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace terrview {

// Reads `size` bytes at `data` as a DEM in the format of one GDAL driver, all others being switched
// off. Ends the program if what comes back is no DEM.
void fuzz_raster(const std::uint8_t* data, std::size_t size, const std::string& driver,
                 const std::string& extension);

}  // namespace terrview
