// The whole ground as a block, framed by itself.
#pragma once

#include <optional>
#include <vector>

#include "cli/overview_options.h"
#include "cli/view_setup.h"
#include "ingest/dem.h"
#include "render/text.h"

namespace terrview {

// What is left free about a block.
struct BlockMargins {
  int left_px;
  int right_px;
  int top_px;
  int bottom_px;
};

struct BlockFonts {
  Font words;
  Font title;
};

struct BlockView {
  View view;  // with walls in the ground; its camera shows the part of a picture that holds it
  BlockMargins margins;
  double plinth_z_m;
  double m_per_px;
  double z_scale;
  int letter_px;                    // the size of letters
  std::optional<BlockFonts> fonts;  // none where the block is plain
};

// Throws InputError, also for a picture too small for a block within its margins, or too large, and
// without a font.
[[nodiscard]] BlockView make_block(const OverviewOptions& options, const std::vector<Dem>& dems);

}  // namespace terrview
