#include "quantize/box_cut.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <queue>
#include <span>

namespace terrview {
namespace {

// What is cut: a cell's mean is its place, so cells are never cut themselves.
struct Point {
  Rgb8 place;
  ColorSum sum;
};

struct Box {
  std::size_t begin;
  std::size_t end;
  ColorSum sum;
  double priority;
};

struct LowerPriority {
  bool operator()(const Box& a, const Box& b) const {
    return a.priority != b.priority ? a.priority < b.priority : a.begin > b.begin;
  }
};

// Points up to and including `last` on the axis go into the first part.
struct Plane {
  int axis;
  std::uint8_t last;
};

// The pixels of a box by their component on one axis.
struct Profile {
  int low = 255;
  int high = 0;
  std::array<ColorSum, 256> sums{};
};

Profile profile_of(std::span<const Point> points, int axis) {
  Profile profile;
  for (const Point& point : points) {
    const int value = point.place[axis];
    profile.low = std::min(profile.low, value);
    profile.high = std::max(profile.high, value);
    profile.sums[static_cast<std::size_t>(value)].add(point.sum);
  }
  return profile;
}

std::optional<Plane> median_plane(std::span<const Point> points) {
  int longest = -1;
  int axis = 0;
  for (int i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(),
        [i](const Point& a, const Point& b) { return a.place[i] < b.place[i]; });
    const int side = high->place[i] - low->place[i];
    if (side > longest) {
      longest = side;
      axis = i;
    }
  }
  if (longest <= 0) return std::nullopt;
  const Profile profile = profile_of(points, axis);
  std::uint64_t total = 0;
  for (const ColorSum& sum : profile.sums) total += sum.count;
  std::uint64_t below = 0;
  int value = profile.low;
  for (; value < profile.high - 1; ++value) {
    below += profile.sums[static_cast<std::size_t>(value)].count;
    if (2 * below >= total) break;
  }
  return Plane{axis, static_cast<std::uint8_t>(value)};
}

ColorSum difference(const ColorSum& all, const ColorSum& part) {
  return {all.count - part.count, all.r - part.r, all.g - part.g, all.b - part.b,
          all.squares - part.squares};
}

std::optional<Plane> variance_plane(std::span<const Point> points, const ColorSum& all) {
  std::optional<Plane> best;
  double least = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Profile profile = profile_of(points, axis);
    ColorSum below;
    for (int value = profile.low; value < profile.high; ++value) {
      const ColorSum& here = profile.sums[static_cast<std::size_t>(value)];
      if (here.count == 0) continue;
      below.add(here);
      const double error = below.error() + difference(all, below).error();
      if (best && error >= least) continue;
      best = Plane{axis, static_cast<std::uint8_t>(value)};
      least = error;
    }
  }
  return best;
}

class Cutter {
 public:
  Cutter(const ColorCells& cells, BoxCut cut) : cut_(cut) {
    points_.reserve(cells.cells.size());
    for (const ColorCell& cell : cells.cells) points_.push_back({cell.sum.mean(), cell.sum});
    queue_.push(box(0, points_.size()));
  }

  Palette cut(std::size_t colors) {
    while (queue_.size() + finished_.size() < colors && !queue_.empty()) {
      const Box largest = queue_.top();
      queue_.pop();
      cut_in_two(largest);
    }
    for (; !queue_.empty(); queue_.pop()) finished_.push_back(queue_.top());
    std::sort(finished_.begin(), finished_.end(),
              [](const Box& a, const Box& b) { return a.begin < b.begin; });
    Palette palette;
    for (const Box& box : finished_) palette.push_back(box.sum.mean());
    return palette;
  }

 private:
  [[nodiscard]] std::span<Point> points_of(const Box& box) {
    return std::span(points_).subspan(box.begin, box.end - box.begin);
  }

  [[nodiscard]] Box box(std::size_t begin, std::size_t end) const {
    ColorSum sum;
    for (std::size_t i = begin; i < end; ++i) sum.add(points_[i].sum);
    return {begin, end, sum, cut_ == BoxCut::median ? static_cast<double>(sum.count) : sum.error()};
  }

  void cut_in_two(const Box& whole) {
    const std::span<Point> points = points_of(whole);
    const auto plane =
        cut_ == BoxCut::median ? median_plane(points) : variance_plane(points, whole.sum);
    if (!plane) {
      finished_.push_back(whole);
      return;
    }
    const auto second = std::stable_partition(
        points.begin(), points.end(),
        [&](const Point& point) { return point.place[plane->axis] <= plane->last; });
    const std::size_t middle = whole.begin + static_cast<std::size_t>(second - points.begin());
    queue_.push(box(whole.begin, middle));
    queue_.push(box(middle, whole.end));
  }

  BoxCut cut_;
  std::vector<Point> points_;
  std::priority_queue<Box, std::vector<Box>, LowerPriority> queue_;
  std::vector<Box> finished_;  // of one place
};

}  // namespace

Palette cut_boxes(const ColorCells& cells, int colors, BoxCut cut) {
  assert(!cells.cells.empty() && colors >= 1);
  return Cutter(cells, cut).cut(static_cast<std::size_t>(colors));
}

}  // namespace terrview
