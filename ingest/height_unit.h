// The units that heights come in.
#pragma once

#include <optional>
#include <string_view>

namespace terrview {

// Metres per unit: m, ft, us-ft, cm, ... as GDAL, GeoTIFF and people write them ("US survey foot",
// "metres"). nullopt = unknown.
[[nodiscard]] std::optional<double> metres_per_height_unit(std::string_view name);

}  // namespace terrview
