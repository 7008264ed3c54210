#include "quantize/color_tree.h"

#include <cassert>

namespace terrview {
namespace {

constexpr std::uint32_t kAbsent = 0xFFFFFFFF;
constexpr std::uint32_t kPresent = 0;
constexpr int kMaxTableLevels = 4;

// The most levels whose nodes are no more than `colors`: those can all stay.
int table_levels(int colors) {
  int levels = 0;
  while (levels < kMaxTableLevels && (8 << (3 * levels)) <= colors) ++levels;
  return levels;
}

std::size_t index(std::int32_t record) { return static_cast<std::size_t>(record); }

}  // namespace

ColorTree::ColorTree(int max_colors)
    : max_colors_(max_colors),
      table_levels_(table_levels(max_colors)),
      records_(std::size_t{1} << (3 * table_levels_), {kAbsent, kNil, kNil}) {
  assert(max_colors >= 1 && max_colors <= kMaxPaletteColors);
}

std::uint32_t ColorTree::prefix(std::uint32_t triplets, int level) const {
  return triplets >> (3 * (kColorBits - level));
}

std::int32_t ColorTree::new_record(std::uint32_t value, std::int32_t next) {
  ++list_records_;
  if (free_ == kNil) {
    records_.push_back({value, kNil, next});
    return static_cast<std::int32_t>(records_.size() - 1);
  }
  const std::int32_t record = free_;
  free_ = records_[index(record)].next;
  records_[index(record)] = {value, kNil, next};
  return record;
}

// The child of `parent` with this triplet, put into its place among its siblings if it is new.
std::int32_t ColorTree::child_of(std::int32_t parent, std::uint32_t triplet) {
  std::int32_t before = kNil;
  std::int32_t child = records_[index(parent)].child;
  while (child != kNil && records_[index(child)].value < triplet) {
    before = child;
    child = records_[index(child)].next;
  }
  if (child != kNil && records_[index(child)].value == triplet) return child;
  const std::int32_t made = new_record(triplet, child);
  (before == kNil ? records_[index(parent)].child : records_[index(before)].next) = made;
  return made;
}

void ColorTree::insert(Rgb8 color) {
  const std::uint32_t path = triplets(color);
  const int depth = prefix(path, level_ - 1) < position_ ? level_ - 1 : level_;
  auto node = static_cast<std::int32_t>(prefix(path, table_levels_));
  const std::size_t records_before = list_records_;
  bool leaf_is_new = false;
  if (records_[index(node)].value == kAbsent) {
    records_[index(node)].value = kPresent;
    leaf_is_new = true;
  }
  for (int level = table_levels_ + 1; level <= depth; ++level)
    node = child_of(node, prefix(path, level) & 7U);
  if (!leaf_is_new && list_records_ == records_before) return;
  ++leaf_count_;
  while (leaf_count_ > max_colors_) delete_next_leaves();
}

// Moves path_ to the first parent of leaves of level_ that follows it. False if there is none.
bool ColorTree::step_to_next_parent() {
  const int parents = level_ - 1;
  int level = parents;
  if (sweeping_) {
    while (level > table_levels_ && records_[index(path_[index(level)])].next == kNil) --level;
  } else {
    level = table_levels_;
  }
  if (level > table_levels_) {
    path_[index(level)] = records_[index(path_[index(level)])].next;
  } else {
    std::int32_t& entry = path_[index(level)];
    entry = sweeping_ ? entry + 1 : 0;
    const std::int32_t entries = 1 << (3 * table_levels_);
    while (entry < entries && records_[index(entry)].child == kNil) ++entry;
    if (entry == entries) return false;
  }
  for (; level < parents; ++level)
    path_[index(level + 1)] = records_[index(path_[index(level)])].child;
  sweeping_ = true;
  return true;
}

void ColorTree::delete_next_leaves() {
  while (!step_to_next_parent()) {
    --level_;
    position_ = 0;
    sweeping_ = false;
    assert(level_ > table_levels_);
  }
  auto place = static_cast<std::uint32_t>(path_[index(table_levels_)]);
  for (int level = table_levels_ + 1; level < level_; ++level)
    place = 8 * place + records_[index(path_[index(level)])].value;
  position_ = place + 1;

  Record& parent = records_[index(path_[index(level_ - 1)])];
  while (parent.child != kNil) {
    const std::int32_t leaf = parent.child;
    parent.child = records_[index(leaf)].next;
    records_[index(leaf)].next = free_;
    free_ = leaf;
    --list_records_;
    --leaf_count_;
  }
  ++leaf_count_;
}

void ColorTree::number(std::int32_t node, std::uint32_t path, int level, Palette& palette) {
  if (records_[index(node)].child == kNil) {
    records_[index(node)].value += 8 * static_cast<std::uint32_t>(palette.size());
    palette.push_back(color_of_triplets(path << (3 * (kColorBits - level))));
    return;
  }
  for (std::int32_t child = records_[index(node)].child; child != kNil;
       child = records_[index(child)].next)
    number(child, 8 * path + records_[index(child)].value, level + 1, palette);
}

Palette ColorTree::number_leaves() {
  Palette palette;
  palette.reserve(static_cast<std::size_t>(leaf_count_));
  const std::int32_t entries = 1 << (3 * table_levels_);
  for (std::int32_t entry = 0; entry < entries; ++entry)
    if (records_[index(entry)].value != kAbsent)
      number(entry, static_cast<std::uint32_t>(entry), table_levels_, palette);
  return palette;
}

std::uint32_t ColorTree::address(Rgb8 color) const {
  const std::uint32_t path = triplets(color);
  auto node = static_cast<std::int32_t>(prefix(path, table_levels_));
  assert(records_[index(node)].value != kAbsent);
  for (int level = table_levels_ + 1; records_[index(node)].child != kNil; ++level) {
    const std::uint32_t triplet = prefix(path, level) & 7U;
    node = records_[index(node)].child;
    while ((records_[index(node)].value & 7U) != triplet) {
      node = records_[index(node)].next;
      assert(node != kNil);
    }
  }
  return records_[index(node)].value / 8;
}

std::size_t ColorTree::record_count() const {
  std::size_t count = list_records_;
  std::vector<bool> present(std::size_t{1} << (3 * table_levels_));
  for (std::size_t entry = 0; entry < present.size(); ++entry)
    present[entry] = records_[entry].value != kAbsent;
  for (int level = table_levels_; level > 0; --level) {
    std::vector<bool> parents(present.size() / 8);
    for (std::size_t entry = 0; entry < present.size(); ++entry) {
      if (!present[entry]) continue;
      ++count;
      parents[entry / 8] = true;
    }
    present = parents;
  }
  return count;
}

}  // namespace terrview
