// What stands about a block: title, ticks and corners, north arrow and scale.
#pragma once

#include <string>
#include <vector>

#include "cli/overview_block.h"
#include "render/image.h"

namespace terrview {

// As given, or the DEMs' names.
[[nodiscard]] std::string block_title(const OverviewOptions& options);

// Of a block that is not plain. Ticks and corners are those of the first DEM's rectangle. Throws
// InputError.
void draw_furniture(const OverviewOptions& options, const std::vector<Dem>& dems,
                    const BlockView& block, Image& image);

}  // namespace terrview
