#include "render/objects/solids/csg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/objects/object_bounds.h"

namespace terrview {
namespace {

Box overlap(const Box& a, const Box& b) {
  const Box both{glm::max(a.lowest_m, b.lowest_m), glm::min(a.highest_m, b.highest_m)};
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  const bool is_empty = glm::any(glm::greaterThan(both.lowest_m, both.highest_m));
  return is_empty ? Box{glm::dvec3(kEndless), glm::dvec3(-kEndless)} : both;
}

bool may_meet(const Line& line, const Box& box) {
  double from = -std::numeric_limits<double>::infinity();
  double to = -from;
  for (int axis = 0; axis < 3; ++axis) {
    const double pace = line.direction[axis];
    const double low_m = box.lowest_m[axis] - line.origin_m[axis];
    const double high_m = box.highest_m[axis] - line.origin_m[axis];
    if (pace == 0) {
      if (low_m > 0 || high_m < 0) return false;
      continue;
    }
    from = std::max(from, (pace > 0 ? low_m : high_m) / pace);
    to = std::min(to, (pace > 0 ? high_m : low_m) / pace);
  }
  return from <= to;
}

// Whether rounding alone may have parted two crossings: of surfaces that coincide, or at an edge
// that they share.
bool coincide(const Crossing& a, const Crossing& b) {
  if (a.t == b.t) return true;
  const double gap = std::abs(a.t - b.t);
  if (gap <= std::min(a.error, b.error)) return true;
  // A line that grazes one surface cannot be sure where it meets it, and may meet others there.
  constexpr double kParallel = 1 - 1e-8;
  return gap <= a.error + b.error && std::abs(glm::dot(a.normal, b.normal)) > kParallel;
}

// The crossings of one side of the tree, one by one.
class Side {
 public:
  Side(std::size_t first, std::size_t last) : next_(first), last_(last) {}

  [[nodiscard]] bool is_over() const { return next_ == last_; }
  [[nodiscard]] std::size_t next() const { return next_; }
  [[nodiscard]] bool is_inside() const { return inside_; }
  // Whether one more crossing is left after the next, before t.
  [[nodiscard]] bool goes_on_before(double t, const Crossings& crossings) const {
    return next_ + 1 < last_ && crossings[next_ + 1].t < t;
  }
  void pass(const Crossings& crossings) { inside_ = crossings[next_++].enters; }

 private:
  std::size_t next_;
  std::size_t last_;
  bool inside_ = false;
};

// Whether the next crossings of both sides are passed at once.
bool meet(const Side& left, const Side& right, const Crossings& crossings) {
  if (left.is_over() || right.is_over()) return false;
  const Crossing& a = crossings[left.next()];
  const Crossing& b = crossings[right.next()];
  return coincide(a, b) && !left.goes_on_before(b.t, crossings) &&
         !right.goes_on_before(a.t, crossings);
}

}  // namespace

CsgSolid::CsgSolid(CsgOperator op, SolidPtr left, SolidPtr right)
    : op_(op),
      left_(std::move(left)),
      right_(std::move(right)),
      left_parts_(left_->parts()),
      parts_(left_parts_ + right_->parts()),
      left_box_(left_->bounds()),
      right_box_(right_->bounds()) {
  if (op == CsgOperator::add) {
    bounds_ = around(std::array{left_box_, right_box_});
    return;
  }
  right_box_ = overlap(left_box_, right_box_);
  if (op == CsgOperator::intersect) left_box_ = right_box_;
  bounds_ = left_box_;
}

void CsgSolid::append_crossings(const Line& line, Crossings& crossings) const {
  // The one list is a stack: the left's, the right's, then the result, which takes their place.
  const std::size_t first = crossings.size();
  if (may_meet(line, left_box_)) left_->append_crossings(line, crossings);
  const std::size_t middle = crossings.size();
  if (middle == first && op_ != CsgOperator::add) return;
  if (may_meet(line, right_box_)) right_->append_crossings(line, crossings);
  const std::size_t last = crossings.size();
  if (middle == last && op_ != CsgOperator::intersect) return;
  for (std::size_t i = middle; i < last; ++i) crossings[i].part += left_parts_;
  append_merged(first, middle, last, crossings);
  const auto begin = crossings.begin();
  crossings.erase(begin + static_cast<std::ptrdiff_t>(first),
                  begin + static_cast<std::ptrdiff_t>(last));
}

void CsgSolid::append_merged(std::size_t first, std::size_t middle, std::size_t last,
                             Crossings& crossings) const {
  Side left(first, middle);
  Side right(middle, last);
  while (!left.is_over() || !right.is_over()) {
    const bool both = meet(left, right, crossings);
    const bool is_left_first =
        right.is_over() ||
        (!left.is_over() && crossings[left.next()].t <= crossings[right.next()].t);
    const bool was_inside = is_inside(op_, left.is_inside(), right.is_inside());
    const std::size_t by_left = left.next();
    const std::size_t by_right = right.next();
    if (both || is_left_first) left.pass(crossings);
    if (both || !is_left_first) right.pass(crossings);
    const bool inside = is_inside(op_, left.is_inside(), right.is_inside());
    if (inside == was_inside) continue;
    const bool is_left = left.next() != by_left && crossings[by_left].enters == inside;
    Crossing crossing = crossings[is_left ? by_left : by_right];
    if (!is_left && op_ == CsgOperator::subtract) crossing.normal = -crossing.normal;
    crossing.enters = inside;
    crossings.push_back(crossing);
  }
}

}  // namespace terrview
