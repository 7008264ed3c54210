#include "render/objects/rectangle_ranks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace terrview {
namespace {

// An end of a range: 2 * range, or 2 * range + 1 for the higher one.
struct Side {
  float at_m;
  int id;
};

bool before(const Side& a, const Side& b) { return a.at_m < b.at_m; }

// Shares out the sides to buckets along the axis, and sorts each.
std::vector<Side> sorted(const std::vector<Side>& sides) {
  const auto [first, last] = std::minmax_element(sides.begin(), sides.end(), before);
  const auto low_m = static_cast<double>(first->at_m);
  const std::size_t buckets = sides.size();
  const double width_m = static_cast<double>(last->at_m) - low_m;
  const auto bucket_of = [&](const Side& side) {
    const double share = width_m > 0 ? (static_cast<double>(side.at_m) - low_m) / width_m : 0;
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

std::vector<Side> sides_of(const std::vector<Range>& ranges) {
  std::vector<Side> sides;
  sides.reserve(2 * ranges.size());
  for (const Range& range : ranges) {
    // Adding 0 makes one of the two zeros.
    sides.push_back({range.low_m + 0.0F, static_cast<int>(sides.size())});
    sides.push_back({range.high_m + 0.0F, static_cast<int>(sides.size())});
  }
  return sides;
}

// The next float toward `toward` where rounding went the other way.
float rounded(double at_m, float toward) {
  const auto nearest_m = static_cast<float>(at_m);
  const bool is_beyond =
      toward < 0 ? static_cast<double>(nearest_m) <= at_m : static_cast<double>(nearest_m) >= at_m;
  return is_beyond ? nearest_m : std::nextafter(nearest_m, toward);
}

}  // namespace

RankedAxis rank_axis(const std::vector<Range>& ranges) {
  std::vector<float> lines_m;
  lines_m.reserve(2 * ranges.size());
  std::vector<Interval> intervals(ranges.size());
  for (const Side& side : sorted(sides_of(ranges))) {
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

Range range_around(double low_m, double high_m) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {rounded(low_m, -kInfinity), rounded(high_m, kInfinity)};
}

}  // namespace terrview
