// Where the names of points go on a picture.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace terrview {

// A line of text over a point of the picture, joined to it by an upright leader.
struct LabelRequest {
  glm::dvec2 anchor_px;
  int width_px;
};

struct LabelBox {
  glm::ivec2 low_px;   // its first column and row
  glm::ivec2 high_px;  // past its last ones
};

struct LabelLayoutOptions {
  glm::ivec2 size_px;  // of the picture
  int line_px = 16;    // the height of a box
  int gap_px = 4;      // at least, between rows, and between a box and another's leader
  // The first row of the picture that is not sky, by column; empty: all is sky.
  std::vector<int> skyline_px = {};
};

// The column that a leader takes: it goes from the box down to the anchor.
[[nodiscard]] int leader_column(const LabelRequest& request);

// The boxes of `requests`, the first most important: each in the lowest row that is free, one above
// its anchor where it covers sky alone, if that is within a quarter of the picture, else any; over
// the middle of the anchor, or at a side of it. No box is left of, right of or above the picture,
// within the gap of a box or leader placed before, or beside a box within half its height; no
// leader crosses a box or touches another leader. nullopt where there is no room.
[[nodiscard]] std::vector<std::optional<LabelBox>> place_labels(
    std::span<const LabelRequest> requests, const LabelLayoutOptions& options);

}  // namespace terrview
