// The strips of a sweep of the lines of a grid away from the sun.
//
// A ray that goes the mean way of its strips keeps p = x + place(line); rays with the same p,
// rounded down, are a strip. Strips are swept kSunStrips at a time, with some of their neighbours
// on both sides, from line to line.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glm/vec2.hpp>

#include "terrain/height_grid.h"
#include "terrain/sun_field.h"

namespace terrview {

inline constexpr int kSunStrips = 448;
// Strips beside them in which other rays begin that may come over the cells of these.
inline constexpr int kSunHalo = 24;
// Lines of cells over which rays go alike.
inline constexpr int kSunPanelLines = 16;

// Cells as places on lines: (x, line), both included.
struct SunPart {
  glm::ivec2 first, last;

  [[nodiscard]] bool has_line(int line) const { return line >= first.y && line <= last.y; }
};

struct SunSweep {
  const HeightGrid& grid;
  const SunField& field;
  double slack;            // more than the rounding of heights along rays
  double low, per_height;  // of codes: SunMap::Codes
  double highest;          // ground, of lines that are not swept
  int first_line;          // of cells
  SunPart part;            // the cells whose words are kept
  // Row by row, from that of this cell on.
  std::uint32_t* words;
  glm::ivec2 first_cell;
  int words_a_row;

  // Of the cell between the lines `line` and `line` + 1, the posts x and x + 1.
  [[nodiscard]] std::uint32_t* at(int x, int line) const {
    const int across = field.from_last() ? field.lines() - 2 - line : line;
    const auto [column, row] = field.over_rows() ? std::pair(x, across) : std::pair(across, x);
    return words + std::ptrdiff_t{row - first_cell.y} * words_a_row + (column - first_cell.x);
  }

  // The row or the column of posts.
  [[nodiscard]] int post_line(int line) const {
    return field.from_last() ? field.lines() - 1 - line : line;
  }
};

// Where strips lie, panel by panel of lines.
class StripTrack {
 public:
  // Of the strips from `first`, at line 0.
  StripTrack(const SunField& field, int first) : field_(field), first_(first) { look_ahead(); }

  void next_panel() {
    place_ += kSunPanelLines * rates_.drift;
    rise_least_ += kSunPanelLines * rates_.rise_least;
    rise_most_ += kSunPanelLines * rates_.rise_most;
    line_ += kSunPanelLines;
    look_ahead();
  }

  [[nodiscard]] const SunRates& rates() const { return rates_; }
  // From line 0 to a line of the panel, or the one after it.
  [[nodiscard]] double place(int line) const { return place_ + (line - line_) * rates_.drift; }
  [[nodiscard]] double rise_least(int line) const {
    return rise_least_ + (line - line_) * rates_.rise_least;
  }
  [[nodiscard]] double rise_most(int line) const {
    return rise_most_ + (line - line_) * rates_.rise_most;
  }
  // The x at which the first strip begins, rounded down to a post.
  [[nodiscard]] int x(int line) const { return first_ - static_cast<int>(std::floor(place(line))); }

 private:
  void look_ahead() {
    const double x = first_ - place_;
    rates_ = field_.rates({x - kSunHalo - kSunPanelLines * 2, line_},
                          {x + kSunStrips + kSunHalo + kSunPanelLines * 2, line_ + kSunPanelLines});
  }

  const SunField& field_;
  int first_;
  int line_ = 0;
  double place_ = 0;
  double rise_least_ = 0;
  double rise_most_ = 0;
  SunRates rates_;
};

}  // namespace terrview
