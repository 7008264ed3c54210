#include "render/objects/rectangle_partition.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "render/objects/plane_order.h"
#include "render/objects/rank_set.h"

namespace terrview {

int IntLists::append(std::span<const int> list) {
  values_.insert(values_.end(), list.begin(), list.end());
  ends_.push_back(static_cast<int>(values_.size()));
  return static_cast<int>(ends_.size()) - 2;
}

namespace {

// The rectangles open at the line of the sweep, each known by its lower border in y, its row.
class Sweep {
 public:
  Sweep(const Lines& x, const Lines& y)
      : x_(x), y_(y), end_(y.borders() - 1), rows_(y.borders()), open_(rows_of(y)) {
    rows_.insert(0);
    rows_.insert(end_);
    open_[0] = {0, Rectangle::kEmpty};
  }

  void begin(int object, int x, const Interval& range) {
    settle(range, x);
    cut(range.low, x, Outside::below);
    cut(range.high, x, Outside::above);
    change(range, x, [&](int list) { return with(list, object); });
  }

  void end(int object, int x, const Interval& range) {
    change(range, x, [&](int list) { return without(list, object); });
  }

  Partition finish(int x) {
    settle({0, end_}, x);
    for (int row = 0; row != end_; row = top(row)) close(row, x);
    return std::move(done_);
  }

  [[nodiscard]] std::size_t size() const {
    return std::max(done_.rectangles.size(), done_.lists.entries());
  }

 private:
  enum class Outside { below, above };

  struct Open {
    int x;
    int list;
  };

  static std::size_t rows_of(const Lines& y) { return static_cast<std::size_t>(y.borders()); }

  Open& open(int row) { return open_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] int top(int row) const { return rows_.next(row + 1); }
  [[nodiscard]] double width_m(int from, int to) const {
    return static_cast<double>(x_.border_m(to)) - static_cast<double>(x_.border_m(from));
  }
  [[nodiscard]] double height_m(int from, int to) const {
    return static_cast<double>(y_.border_m(to)) - static_cast<double>(y_.border_m(from));
  }

  void close(int row, int x) {
    const Open& it = open(row);
    if (it.x < x) done_.rectangles.push_back({{it.x, x}, {row, top(row)}, it.list});
  }

  // Joins what is better joined among the rectangles that an event at x in `range` meets.
  void settle(const Interval& range, int x) {
    int row = rows_.previous(range.low);
    while (row > 0 && join(row, x)) row = rows_.previous(row);
    for (int next = top(row); next != end_; next = top(row)) {
      if (join(next, x)) continue;
      if (next >= range.high) break;
      row = next;
    }
  }

  // Whether the rectangle at `row` and the one below it were better one since the younger began:
  // then the older ends there.
  bool join(int row, int x) {
    const int below = rows_.previous(row - 1);
    Open& upper = open(row);
    Open& lower = open(below);
    if (!same(upper.list, lower.list)) return false;
    const int since = std::max(upper.x, lower.x);
    if (upper.x != lower.x) {
      const int older = upper.x < lower.x ? row : below;
      if (height_m(older, top(older)) >= width_m(since, x)) return false;
      close(older, since);
    }
    rows_.erase(row);
    lower.x = since;
    return true;
  }

  // Makes `row` a border from x on: back to where the rectangle began, or across what is outside.
  void cut(int row, int x, Outside outside) {
    if (rows_.contains(row)) return;
    const int below = rows_.previous(row);
    const double across_m =
        outside == Outside::below ? height_m(below, row) : height_m(row, top(row));
    if (width_m(open(below).x, x) > across_m) {
      close(below, x);
      open(below).x = x;
    }
    rows_.insert(row);
    open(row) = open(below);
  }

  // Ends the rectangles of `range` and begins them anew with other lists.
  template <class NewList>
  void change(const Interval& range, int x, const NewList& new_list) {
    Open last{-1, Rectangle::kEmpty};
    for (int row = range.low; row != range.high;) {
      const int next = top(row);
      close(row, x);
      Open& it = open(row);
      it = {x, new_list(it.list)};
      if (row != range.low && same(it.list, last.list)) {
        rows_.erase(row);
      } else {
        last = it;
      }
      row = next;
    }
  }

  [[nodiscard]] bool same(int a, int b) const {
    if (a == b) return true;
    if (a == Rectangle::kEmpty || b == Rectangle::kEmpty) return false;
    return std::ranges::equal(done_.lists[a], done_.lists[b]);
  }

  int with(int list, int object) {
    take(list);
    scratch_.insert(std::lower_bound(scratch_.begin(), scratch_.end(), object), object);
    return done_.lists.append(scratch_);
  }

  int without(int list, int object) {
    take(list);
    scratch_.erase(std::lower_bound(scratch_.begin(), scratch_.end(), object));
    return scratch_.empty() ? Rectangle::kEmpty : done_.lists.append(scratch_);
  }

  void take(int list) {
    scratch_.clear();
    if (list == Rectangle::kEmpty) return;
    const auto values = done_.lists[list];
    scratch_.assign(values.begin(), values.end());
  }

  const Lines& x_;
  const Lines& y_;
  int end_;  // the last border in y
  RankSet rows_;
  std::vector<Open> open_;
  Partition done_;
  std::vector<int> scratch_;
};

// The objects in the order of their borders in x: the i-th of 2 n is that of object i / 2, which
// begins there if i is even.
std::vector<int> in_order(const RankedAxis& x) {
  std::vector<int> ends(static_cast<std::size_t>(x.lines.borders()) + 1);
  const auto end = [&](int border) -> int& { return ends[static_cast<std::size_t>(border)]; };
  for (const Interval& interval : x.intervals) {
    ++end(interval.low + 1);
    ++end(interval.high + 1);
  }
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  std::vector<int> order(2 * x.intervals.size());
  int id = 0;
  for (const Interval& interval : x.intervals) {
    order[static_cast<std::size_t>(end(interval.low)++)] = id++;
    order[static_cast<std::size_t>(end(interval.high)++)] = id++;
  }
  return order;
}

// Neighbours together: what a ray walks through is then near in memory.
void sort(std::vector<Rectangle>& rectangles, const RankedAxis& x, const RankedAxis& y) {
  const int bits = order_bits(rectangles.size());
  const auto place = [&](int border, const Lines& lines) {
    const std::int64_t share = (std::int64_t{border} << bits) / lines.borders();
    return static_cast<std::uint32_t>(share);
  };
  std::vector<std::uint32_t> keys;
  keys.reserve(rectangles.size());
  for (const Rectangle& it : rectangles)
    keys.push_back(interleaved(place(it.x.low, x.lines), place(it.y.low, y.lines)));
  std::vector<Rectangle> sorted;
  sorted.reserve(rectangles.size());
  for (const int i : order_of(keys)) sorted.push_back(rectangles[static_cast<std::size_t>(i)]);
  rectangles = std::move(sorted);
}

}  // namespace

std::optional<Partition> cut_plane(const RankedAxis& x, const RankedAxis& y, std::size_t most) {
  Sweep sweep(x.lines, y.lines);
  for (const int id : in_order(x)) {
    const int object = id / 2;
    const auto i = static_cast<std::size_t>(object);
    if (id % 2 == 0) {
      sweep.begin(object, x.intervals[i].low, y.intervals[i]);
    } else {
      sweep.end(object, x.intervals[i].high, y.intervals[i]);
    }
    if (sweep.size() > most) return std::nullopt;
  }
  Partition partition = sweep.finish(x.lines.borders() - 1);
  sort(partition.rectangles, x, y);
  return partition;
}

}  // namespace terrview
