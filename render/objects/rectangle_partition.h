// The plane cut into rectangles.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/objects/rectangle_ranks.h"

namespace terrview {

// Lists of integers, end to end.
class IntLists {
 public:
  [[nodiscard]] std::span<const int> operator[](int list) const {
    const auto i = static_cast<std::size_t>(list);
    return {values_.data() + ends_[i], values_.data() + ends_[i + 1]};
  }
  [[nodiscard]] std::size_t entries() const { return values_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(int) * (values_.capacity() + ends_.capacity());
  }

  int append(std::span<const int> list);

 private:
  std::vector<int> values_;
  std::vector<int> ends_{0};
};

struct Rectangle {
  Interval x;
  Interval y;
  int list;  // of the objects over it, or kEmpty

  static constexpr int kEmpty = -1;
};

struct Partition {
  std::vector<Rectangle> rectangles;  // disjoint; together, everything
  IntLists lists;
};

// Cuts everything from the first to the last line of both axes so that each rectangle lies wholly
// within or without each object's. A sweep along x keeps the rectangles open at its line by y. An
// edge that a corner needs grows by the shorter of the two ways: for a corner that faces back both
// are known; for one that faces on, the edge goes on until it has become longer than the other way,
// which is then taken instead. O(log n) for each rectangle.
//
// Nothing, if that takes more than `most` rectangles or entries in lists.
[[nodiscard]] std::optional<Partition> cut_plane(const RankedAxis& x, const RankedAxis& y,
                                                 std::size_t most);

}  // namespace terrview
