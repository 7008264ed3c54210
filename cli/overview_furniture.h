// What stands about a block: title, ticks and corners, north arrow and scale.
#pragma once

#include "cli/overview_block.h"
#include "render/image.h"

namespace terrview {

// Ticks and corners are those of the first DEM's rectangle. Throws InputError without a font.
void draw_furniture(const OverviewOptions& options, const std::vector<Dem>& dems,
                    const BlockView& block, Image& image);

}  // namespace terrview
