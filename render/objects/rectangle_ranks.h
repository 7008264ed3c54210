// Coordinates as integers, so that what is beside what is exact.
//
// Along an axis, every coordinate of a range is a line, and a line is a column of its own between
// two borders: 2r before the r-th line, 2r + 1 behind it. A closed range of coordinates is then a
// half-open interval of borders, of at least one column even where it is a single point, and ranges
// that touch share a column.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace terrview {

// Coordinates; closed. In float, rounded outward, so that more of the map fits in the caches.
struct Range {
  float low_m;
  float high_m;
};

// Borders; half-open.
struct Interval {
  int low;
  int high;

  friend bool operator==(const Interval&, const Interval&) = default;
};

// The lines of one axis.
class Lines {
 public:
  explicit Lines(std::vector<float> at_m) : at_m_(std::move(at_m)) {}

  [[nodiscard]] int borders() const { return 2 * static_cast<int>(at_m_.size()); }
  [[nodiscard]] float border_m(int border) const {
    return at_m_[static_cast<std::size_t>(border) / 2];
  }

 private:
  std::vector<float> at_m_;  // rising
};

struct RankedAxis {
  Lines lines;
  std::vector<Interval> intervals;  // of the ranges
};

// O(n log n); linear for coordinates that are spread evenly.
[[nodiscard]] RankedAxis rank_axis(const std::vector<Range>& ranges);

// The range around [low_m, high_m].
[[nodiscard]] Range range_around(double low_m, double high_m);

}  // namespace terrview
