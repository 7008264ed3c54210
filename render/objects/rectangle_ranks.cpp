#include "render/objects/rectangle_ranks.h"

#include <algorithm>
#include <utility>

namespace terrview {
namespace {

// A side of a box: 2 * box, or 2 * box + 1 for the higher one.
struct Side {
  double at_m;
  int id;
};

bool before(const Side& a, const Side& b) { return a.at_m < b.at_m; }

// Shares out the sides to buckets along the axis, and sorts each.
std::vector<Side> sorted(const std::vector<Side>& sides) {
  const auto [first, last] = std::minmax_element(sides.begin(), sides.end(), before);
  const double low_m = first->at_m;
  const std::size_t buckets = sides.size();
  // Halved, so that no two finite coordinates are infinitely far apart.
  const double width = last->at_m / 2 - low_m / 2;
  const auto bucket_of = [&](const Side& side) {
    const double share = width > 0 ? (side.at_m / 2 - low_m / 2) / width : 0;
    return static_cast<std::size_t>(share * static_cast<double>(buckets - 1));
  };
  std::vector<std::size_t> ends(buckets + 1);
  for (const Side& side : sides) ++ends[bucket_of(side) + 1];
  for (std::size_t i = 1; i <= buckets; ++i) ends[i] += ends[i - 1];
  std::vector<Side> result(sides.size());
  for (const Side& side : sides) result[ends[bucket_of(side)]++] = side;
  for (std::size_t i = 0, begin = 0; i < buckets; begin = ends[i++]) {
    const auto at = [&](std::size_t k) { return result.begin() + static_cast<std::ptrdiff_t>(k); };
    std::sort(at(begin), at(ends[i]), before);
  }
  return result;
}

std::vector<Side> sides_of(const std::vector<Box>& boxes, int axis) {
  std::vector<Side> sides;
  sides.reserve(2 * boxes.size());
  for (const Box& box : boxes) {
    // Adding 0 makes one of the two zeros.
    sides.push_back({box.lowest_m[axis] + 0.0, static_cast<int>(sides.size())});
    sides.push_back({box.highest_m[axis] + 0.0, static_cast<int>(sides.size())});
  }
  return sides;
}

}  // namespace

RankedAxis rank_axis(const std::vector<Box>& boxes, int axis) {
  std::vector<double> lines_m;
  lines_m.reserve(2 * boxes.size());
  std::vector<Interval> intervals(boxes.size());
  for (const Side& side : sorted(sides_of(boxes, axis))) {
    if (lines_m.empty() || lines_m.back() != side.at_m) lines_m.push_back(side.at_m);
    const int line = static_cast<int>(lines_m.size()) - 1;
    Interval& interval = intervals[static_cast<std::size_t>(side.id) / 2];
    if (side.id % 2 == 0) {
      interval.low = 2 * line;
    } else {
      interval.high = 2 * line + 1;
    }
  }
  return {Lines(std::move(lines_m)), std::move(intervals)};
}

}  // namespace terrview
