#include "ingest/summits.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>

namespace terrview {
namespace {

// Posts `first` to `last`, both included.
struct Box {
  glm::ivec2 first;
  glm::ivec2 last;
};

Box around(const HeightGrid& grid, glm::ivec2 post, int reach) {
  return {glm::max(post - reach, glm::ivec2(0)),
          glm::min(post + reach, glm::ivec2(grid.columns - 1, grid.rows - 1))};
}

// The first of the highest posts of a box.
std::optional<Summit> highest(const HeightGrid& grid, const Box& box) {
  std::optional<Summit> top;
  for (int row = box.first.y; row <= box.last.y; ++row) {
    for (int column = box.first.x; column <= box.last.x; ++column) {
      const float height = grid.at(column, row);
      if (height > (top ? top->height_m : -INFINITY)) top = Summit{{column, row}, height};
    }
  }
  return top;
}

bool at_an_edge(const HeightGrid& grid, glm::ivec2 post) {
  if (post.x == 0 || post.y == 0 || post.x == grid.columns - 1 || post.y == grid.rows - 1) {
    return true;
  }
  for (int row = post.y - 1; row <= post.y + 1; ++row) {
    for (int column = post.x - 1; column <= post.x + 1; ++column) {
      if (std::isnan(grid.at(column, row))) return true;
    }
  }
  return false;
}

bool is_summit(const HeightGrid& grid, const Summit& top, int reach) {
  if (at_an_edge(grid, top.post)) return false;
  const Box box = around(grid, top.post, reach);
  for (int row = box.first.y; row <= box.last.y; ++row) {
    for (int column = box.first.x; column <= box.last.x; ++column) {
      const float height = grid.at(column, row);
      const bool before = row < top.post.y || (row == top.post.y && column < top.post.x);
      if (height > top.height_m || (before && height == top.height_m)) return false;
    }
  }
  return true;
}

}  // namespace

int summit_reach(const HeightGrid& grid) {
  return std::max(3, std::min(grid.columns, grid.rows) / 40);
}

std::vector<Summit> find_summits(const HeightGrid& grid, std::size_t count) {
  const int reach = summit_reach(grid);
  std::vector<Summit> summits;
  // A summit is the highest post of its block: a block reaches no further than a summit does.
  for (int row = 0; row < grid.rows; row += reach) {
    for (int column = 0; column < grid.columns; column += reach) {
      const glm::ivec2 last(std::min(column + reach, grid.columns) - 1,
                            std::min(row + reach, grid.rows) - 1);
      const auto top = highest(grid, {{column, row}, last});
      if (top && is_summit(grid, *top, reach)) summits.push_back(*top);
    }
  }
  std::stable_sort(summits.begin(), summits.end(),
                   [](const Summit& a, const Summit& b) { return a.height_m > b.height_m; });
  summits.resize(std::min(count, summits.size()));
  return summits;
}

}  // namespace terrview
