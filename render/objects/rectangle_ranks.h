// Coordinates as integers, so that what is beside what is exact.
//
// Along an axis, every coordinate of a box is a line, and a line is a column of its own between two
// borders: 2r before the r-th line, 2r + 1 behind it. A closed interval of coordinates is then a
// half-open interval of borders, of at least one column even where it is a single point, and
// intervals that touch share a column.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "render/objects/object.h"

namespace terrview {

// The lines of one axis.
class Lines {
 public:
  explicit Lines(std::vector<double> at_m) : at_m_(std::move(at_m)) {}

  [[nodiscard]] std::size_t bytes() const { return at_m_.capacity() * sizeof(double); }
  [[nodiscard]] int borders() const { return 2 * static_cast<int>(at_m_.size()); }
  [[nodiscard]] double border_m(int border) const {
    return at_m_[static_cast<std::size_t>(border) / 2];
  }

 private:
  std::vector<double> at_m_;  // rising
};

// Borders; half-open.
struct Interval {
  int low;
  int high;

  friend bool operator==(const Interval&, const Interval&) = default;
};

struct RankedAxis {
  Lines lines;
  std::vector<Interval> intervals;  // of the boxes
};

// O(n log n); linear for coordinates that are spread evenly.
[[nodiscard]] RankedAxis rank_axis(const std::vector<Box>& boxes, int axis);

}  // namespace terrview
