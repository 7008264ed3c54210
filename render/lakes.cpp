#include "render/lakes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace terrview {
namespace {

// Points so near to a grid line touch both cells.
constexpr double kOnLine = 1e-9;

using Visit = std::function<void(glm::ivec2 cell)>;

// The cells of a row between two u, both sides of a line included.
void visit_span(int row, double from, double to, int columns, const Visit& visit) {
  const double last = columns - 1;
  if (to < -kOnLine || from > columns + kOnLine) return;
  const int begin = static_cast<int>(std::clamp(std::floor(from - kOnLine), 0.0, last));
  const int end = static_cast<int>(std::clamp(std::floor(to + kOnLine), 0.0, last));
  for (int column = begin; column <= end; ++column) visit({column, row});
}

void visit_edge(glm::dvec2 a, glm::dvec2 b, glm::ivec2 cells, const Visit& visit) {
  if (a.y > b.y) std::swap(a, b);
  if (b.y < -kOnLine || a.y > cells.y + kOnLine) return;
  const double last = cells.y - 1;
  const int begin = static_cast<int>(std::clamp(std::floor(a.y - kOnLine), 0.0, last));
  const int end = static_cast<int>(std::clamp(std::floor(b.y + kOnLine), 0.0, last));
  for (int row = begin; row <= end; ++row) {
    const auto u_at = [&](double v) {
      if (b.y <= a.y) return a.x;
      return glm::mix(a.x, b.x, std::clamp((v - a.y) / (b.y - a.y), 0.0, 1.0));
    };
    const double from = b.y > a.y ? u_at(row) : a.x;
    const double to = b.y > a.y ? u_at(row + 1) : b.x;
    visit_span(row, std::min(from, to), std::max(from, to), cells.x, visit);
  }
}

}  // namespace

void for_each_cell_of(const Polygon& polygon, glm::ivec2 grid_size, const Visit& visit) {
  const glm::ivec2 cells = grid_size - 1;
  const glm::dvec2 low = polygon.lowest();
  const glm::dvec2 high = polygon.highest();
  if (!(low.x <= cells.x && low.y <= cells.y && high.x >= 0 && high.y >= 0)) return;
  const auto vertices = polygon.vertices();
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
    if (polygon.is_edge(i)) visit_edge(vertices[i], vertices[i + 1], cells, visit);
  Polygon::Crossings crossings;
  const int first = static_cast<int>(std::clamp(std::floor(low.y), 0.0, cells.y - 1.0));
  const int last = static_cast<int>(std::clamp(std::floor(high.y), 0.0, cells.y - 1.0));
  for (int row = first; row <= last; ++row) {
    polygon.cross({0, row + 0.5}, {1, 0}, crossings);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      visit_span(row, crossings[i].t, crossings[i + 1].t, cells.x, visit);
  }
}

Lakes::Lakes(std::vector<Polygon> outlines, glm::ivec2 grid_size)
    : outlines_(std::move(outlines)),
      columns_(grid_size.x - 1),
      owner_(static_cast<std::size_t>(grid_size.x - 1) * static_cast<std::size_t>(grid_size.y - 1),
             kNone) {
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    const auto lake = static_cast<std::int32_t>(i);
    for_each_cell_of(outlines_[i], grid_size, [&](glm::ivec2 cell) {
      std::int32_t& owner =
          owner_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(cell.x)];
      owner = owner == kNone || owner == lake ? lake : kSeveral;
    });
  }
}

bool Lakes::contain(glm::ivec2 cell, glm::dvec2 uv) const {
  const std::int32_t owner =
      owner_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
             static_cast<std::size_t>(cell.x)];
  if (owner == kNone) return false;
  if (owner != kSeveral) return outlines_[static_cast<std::size_t>(owner)].contains(uv);
  return std::any_of(outlines_.begin(), outlines_.end(), [&](const Polygon& outline) {
    return uv.x >= outline.lowest().x && uv.y >= outline.lowest().y &&
           uv.x <= outline.highest().x && uv.y <= outline.highest().y && outline.contains(uv);
  });
}

}  // namespace terrview
