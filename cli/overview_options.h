// The options of `terrview overview`: docs/overview.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/view_options.h"

namespace terrview {

enum class TickSystem { own, degrees };

struct OverviewOptions {
  ViewOptions view;  // what it shares with a view

  // Of a block.
  double from_deg = 180;  // the side of the compass that it is seen from
  double tilt_deg = 35;   // of the view below the horizon
  TickSystem ticks = TickSystem::own;
  std::optional<std::string> title;  // none: the DEMs' names
  bool plain = false;                // nothing beside the block

  // Of a map.
  bool plan = false;
  std::optional<glm::ivec2> tiles;         // columns and rows of sheets
  std::optional<glm::ivec2> tile_size_px;  // of a sheet
  std::string sheets;                      // a file of their outlines
  std::string sheet_name = "name";         // its field

  [[nodiscard]] bool in_sheets() const { return tiles || tile_size_px || !sheets.empty(); }
};

// Throws InputError, also for options that do not go together.
[[nodiscard]] OverviewOptions parse_overview(const std::vector<std::string>& args);

}  // namespace terrview
