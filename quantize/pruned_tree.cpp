#include "quantize/pruned_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>
#include <utility>

namespace terrview {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;

struct Node {
  std::uint32_t prefix;
  std::uint32_t first_child;  // in the level below
  std::uint32_t children;     // 0 in a leaf
  double cost;                // of deleting the children
  ColorSum sum;
};

struct Family {
  double cost;
  int level;  // of the parent
  std::uint32_t parent;
};

using Levels = std::array<std::vector<Node>, kColorBits + 1>;

std::vector<Node> parents_of(const std::vector<Node>& nodes, DeletionOrder order) {
  std::vector<Node> parents;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::uint32_t prefix = nodes[i].prefix / 8;
    if (parents.empty() || parents.back().prefix != prefix)
      parents.push_back({prefix, static_cast<std::uint32_t>(i), 0, 0, {}});
    Node& parent = parents.back();
    ++parent.children;
    parent.sum.add(nodes[i].sum);
    parent.cost = std::max(parent.cost, nodes[i].cost);  // against rounding
  }
  for (Node& parent : parents)
    parent.cost = std::max(parent.cost, order == DeletionOrder::population
                                            ? static_cast<double>(parent.sum.count)
                                            : parent.sum.error());
  return parents;
}

Levels grow(const ColorCells& cells, DeletionOrder order) {
  Levels levels;
  std::vector<Node>& deepest = levels[static_cast<std::size_t>(cells.level)];
  deepest.reserve(cells.cells.size());
  for (const ColorCell& cell : cells.cells) deepest.push_back({cell.prefix, kNone, 0, 0, cell.sum});
  for (auto level = static_cast<std::size_t>(cells.level); level > 0; --level)
    levels[level - 1] = parents_of(levels[level], order);
  return levels;
}

// The cheapest first, children before their parent.
std::vector<Family> families_by_cost(const Levels& levels) {
  std::vector<Family> families;
  for (std::size_t level = 0; level < levels.size(); ++level)
    for (std::size_t i = 0; i < levels[level].size(); ++i)
      if (levels[level][i].children > 0)
        families.push_back(
            {levels[level][i].cost, static_cast<int>(level), static_cast<std::uint32_t>(i)});
  std::sort(families.begin(), families.end(), [](const Family& a, const Family& b) {
    return std::tuple(a.cost, -a.level, a.parent) < std::tuple(b.cost, -b.level, b.parent);
  });
  return families;
}

// What the error grows by if the pixels of `child` get the mean of `parent`.
double merging_cost(const ColorSum& child, const ColorSum& parent, DeletionOrder order) {
  const auto count = static_cast<double>(child.count);
  if (order == DeletionOrder::population) return count;
  const auto square = [&](std::uint64_t of_child, std::uint64_t of_parent) {
    const double step = static_cast<double>(of_child) / count -
                        static_cast<double>(of_parent) / static_cast<double>(parent.count);
    return step * step;
  };
  return count *
         (square(child.r, parent.r) + square(child.g, parent.g) + square(child.b, parent.b));
}

// The children that stay when `kept` may: those that would cost most.
std::vector<bool> choose_kept(const Node& parent, const std::vector<Node>& below, int kept,
                              DeletionOrder order) {
  std::vector<std::pair<double, std::uint32_t>> costs;
  for (std::uint32_t i = 0; i < parent.children; ++i)
    costs.emplace_back(-merging_cost(below[parent.first_child + i].sum, parent.sum, order), i);
  std::sort(costs.begin(), costs.end());
  std::vector<bool> stays(parent.children);
  for (int i = 0; i < kept; ++i) stays[costs[static_cast<std::size_t>(i)].second] = true;
  return stays;
}

// Writes the leaves of the pruned levels in pre-order.
class LeafWriter {
 public:
  LeafWriter(const Levels& levels, const Family& last, std::vector<bool> kept)
      : levels_(levels), last_(last), kept_(std::move(kept)) {}

  void visit(int level, std::uint32_t index) {
    const Node& node = levels_[static_cast<std::size_t>(level)][index];
    if (!kept_.empty() && level == last_.level && index == last_.parent) {
      visit_last_family(node);
    } else if (node.children == 0) {
      add(level, node.prefix, new_address(node.sum));
    } else {
      for (std::uint32_t i = 0; i < node.children; ++i) visit(level + 1, node.first_child + i);
    }
  }

  std::vector<AddressInterval> leaves;
  Palette palette;

 private:
  void visit_last_family(const Node& parent) {
    const std::vector<Node>& below = levels_[static_cast<std::size_t>(last_.level) + 1];
    ColorSum merged;
    for (std::uint32_t i = 0; i < kept_.size(); ++i)
      if (!kept_[i]) merged.add(below[parent.first_child + i].sum);
    const std::uint32_t shared = new_address(merged);
    for (std::uint32_t i = 0; i < kept_.size(); ++i) {
      const Node& child = below[parent.first_child + i];
      add(last_.level + 1, child.prefix, kept_[i] ? new_address(child.sum) : shared);
    }
  }

  std::uint32_t new_address(const ColorSum& sum) {
    palette.push_back(sum.mean());
    return static_cast<std::uint32_t>(palette.size() - 1);
  }

  void add(int level, std::uint32_t prefix, std::uint32_t address) {
    leaves.push_back({prefix << (3 * (kColorBits - level)), address});
  }

  const Levels& levels_;
  Family last_;
  std::vector<bool> kept_;
};

}  // namespace

PrunedTree::PrunedTree(const ColorCells& cells, int max_colors, DeletionOrder order) {
  assert(!cells.cells.empty() && max_colors >= 1 && max_colors <= kMaxPaletteColors);
  Levels levels = grow(cells, order);
  const auto most = static_cast<std::size_t>(max_colors);
  std::size_t leaves = cells.cells.size();
  Family last{};
  std::vector<bool> kept;
  for (const Family& family : families_by_cost(levels)) {
    if (leaves <= most) break;
    Node& parent = levels[static_cast<std::size_t>(family.level)][family.parent];
    leaves -= parent.children - 1;
    last = family;
    if (leaves < most)
      kept = choose_kept(parent, levels[static_cast<std::size_t>(family.level) + 1],
                         static_cast<int>(most - leaves), order);
    else
      parent.children = 0;
  }
  LeafWriter writer(levels, last, std::move(kept));
  writer.visit(0, 0);
  palette_ = std::move(writer.palette);
  leaves_ = std::move(writer.leaves);
}

std::uint32_t PrunedTree::address(Rgb8 color) const {
  const auto after = std::upper_bound(
      leaves_.begin(), leaves_.end(), triplets(color),
      [](std::uint32_t path, const AddressInterval& leaf) { return path < leaf.first; });
  return after == leaves_.begin() ? leaves_.front().address : std::prev(after)->address;
}

}  // namespace terrview
