// What makes a view impossible, or doubtful, before any geodesy.
#pragma once

#include <string>
#include <vector>

#include "ingest/view_frame.h"

namespace terrview {

// Throws InputError for a request that no view frame can meet, whatever the ground.
void check_request(const std::vector<Dem>& dems, const EyePlace& eye,
                   const ViewFrameOptions& options);

// A line for each DEM whose vertical datum is known and not that of the first one known.
[[nodiscard]] std::vector<std::string> datum_warnings(const std::vector<Dem>& dems);

// A number as printf writes it.
[[nodiscard]] std::string in_words(const char* pattern, double value);

}  // namespace terrview
