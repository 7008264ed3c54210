// The colour tree of S. Coquillart's thesis (Representation de paysages et trace de rayon,
// Saint-Etienne 1984, chapter 5): at most N colours for a picture, without statistics.
//
// The colours met are kept as paths of triplets of bits (quantize/color.h) in a tree whose nodes
// are records {value, first child, next sibling}. Where an insertion makes more than N coloured
// leaves, leaves are deleted: their parent takes their place, with one bit less in every component.
// Deletions follow a fixed order, the deepest level first and each level in pre-order, and a colour
// inserted later is truncated to what the deletions have left of its branch.
//
// Two points that the thesis leaves open: siblings are deleted together, so that a look-up always
// ends at a leaf; and siblings are in the order of their values, so that the palette depends on the
// set of colours alone and not on the order of the pixels.
//
// Promises, each a test in tests/quantize/color_tree_test.cpp:
//   1. There are never more than N leaves after an insertion, nor for N = 2^p more records than
//      2^p (3 * 8 - p + 4) / 3.
//   2. The leaves are those of the brute-force sweep over the set of all colours.
//   3. Every inserted colour has an address, and it differs from its palette colour by its missing
//      bits alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quantize/color.h"

namespace terrview {

class ColorTree {
 public:
  // For at most `max_colors` colours, 1 to 65536.
  explicit ColorTree(int max_colors);

  void insert(Rgb8 color);

  // Numbers the leaves in pre-order. Returns their colours, the missing bits zero.
  Palette number_leaves();

  // The number of the leaf of a colour that was inserted, after number_leaves().
  [[nodiscard]] std::uint32_t address(Rgb8 color) const;

  [[nodiscard]] int leaf_count() const { return leaf_count_; }

  // Nodes of all levels but the root, those above and in the table of first levels included.
  [[nodiscard]] std::size_t record_count() const;

 private:
  static constexpr std::int32_t kNil = -1;

  // `child` is kNil in a coloured leaf.
  struct Record {
    std::uint32_t value;  // the triplet; in numbered leaves, 8 times the address is added
    std::int32_t child;
    std::int32_t next;
  };

  [[nodiscard]] std::uint32_t prefix(std::uint32_t triplets, int level) const;
  [[nodiscard]] std::int32_t child_of(std::int32_t parent, std::uint32_t triplet);
  std::int32_t new_record(std::uint32_t value, std::int32_t next);
  bool step_to_next_parent();
  void delete_next_leaves();
  void number(std::int32_t node, std::uint32_t path, int level, Palette& palette);

  int max_colors_;
  int leaf_count_ = 0;
  std::size_t list_records_ = 0;  // in use, beyond the table

  // The first levels, as many of four as can never lose a leaf, are a table: the first 8^n records,
  // found by their triplets. An entry whose value is kAbsent is not there.
  int table_levels_;
  std::vector<Record> records_;
  std::int32_t free_ = kNil;

  // Deletions: leaves of level_ whose parent comes before position_ are gone. path_ holds the
  // last such parent, below its ancestors, one for each level from the table's down.
  int level_ = kColorBits;
  std::uint32_t position_ = 0;
  bool sweeping_ = false;
  std::array<std::int32_t, kColorBits> path_{};
};

}  // namespace terrview
