#include "terrain/mean_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace terrview {
namespace {

// The mean of those of the four posts from (column, row) on that have a height; NaN if none has.
float mean_of_four(const HeightGrid& grid, int column, int row) {
  float sum = 0;
  int count = 0;
  for (int r = row; r < std::min(row + 2, grid.rows); ++r) {
    for (int c = column; c < std::min(column + 2, grid.columns); ++c) {
      const float height_m = grid.at(c, r);
      if (std::isnan(height_m)) continue;
      sum += height_m;
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<float>(count) : std::numeric_limits<float>::quiet_NaN();
}

HeightGrid coarser(const HeightGrid& grid, const ForEach& for_each) {
  HeightGrid coarse{(grid.columns + 1) / 2, (grid.rows + 1) / 2, {}};
  const auto width = static_cast<std::size_t>(grid.columns);
  const auto coarse_width = static_cast<std::size_t>(coarse.columns);
  coarse.heights_m.resize(coarse_width * static_cast<std::size_t>(coarse.rows));
  for_each(coarse.rows, [&](int row) {
    float* means = coarse.heights_m.data() + static_cast<std::size_t>(row) * coarse_width;
    const bool has_four = 2 * row + 1 < grid.rows;
    const float* north = grid.heights_m.data() + static_cast<std::size_t>(2 * row) * width;
    const float* south = has_four ? north + width : north;
    const std::size_t pairs = has_four ? width / 2 : 0;
    for (std::size_t i = 0; i < pairs; ++i)
      means[i] = (north[2 * i] + north[2 * i + 1] + south[2 * i] + south[2 * i + 1]) / 4;
    for (std::size_t i = 0; i < coarse_width; ++i)
      if (i >= pairs || std::isnan(means[i]))
        means[i] = mean_of_four(grid, 2 * static_cast<int>(i), 2 * row);
  });
  return coarse;
}

struct Square {
  double nw, ne, sw, se;

  [[nodiscard]] double at(glm::dvec2 f) const {
    return glm::mix(glm::mix(nw, ne, f.x), glm::mix(sw, se, f.x), f.y);
  }
};

// What `value` is at the corners of a cell.
template <class Value>
Square corners(glm::ivec2 cell, const Value& value) {
  return {value(cell.x, cell.y), value(cell.x + 1, cell.y), value(cell.x, cell.y + 1),
          value(cell.x + 1, cell.y + 1)};
}

}  // namespace

MeanHeights::MeanHeights(const HeightGrid& grid, const ForEach& for_each) {
  const HeightGrid* finest = &grid;
  while (std::min(finest->columns, finest->rows) >= 4) {
    levels_.push_back(coarser(*finest, for_each));
    finest = &levels_.back();
  }
}

std::optional<MeanHeights::Ground> MeanHeights::at(double level, glm::dvec2 uv) const {
  if (levels_.empty()) return std::nullopt;
  const double limited = std::clamp(level, 1.0, static_cast<double>(last_level()));
  const int fine = static_cast<int>(limited);
  const auto near = at_level(fine, uv);
  if (!near || limited == fine) return near;
  const auto far = at_level(fine + 1, uv);
  if (!far) return std::nullopt;
  const double share = limited - fine;
  return Ground{glm::mix(near->height_m, far->height_m, share),
                glm::mix(near->slope_m, far->slope_m, share)};
}

std::optional<MeanHeights::Ground> MeanHeights::at_level(int level, glm::dvec2 uv) const {
  const HeightGrid& grid = levels_[static_cast<std::size_t>(level - 1)];
  const double block = std::exp2(level);
  const glm::ivec2 last(grid.columns - 1, grid.rows - 1);
  const glm::dvec2 place = glm::clamp((uv + 0.5) / block - 0.5, glm::dvec2(0), glm::dvec2(last));
  const glm::ivec2 cell = glm::min(glm::ivec2(place), last - 1);
  const glm::dvec2 f = place - glm::dvec2(cell);
  const auto height = [&](int column, int row) {
    return static_cast<double>(grid.at(std::clamp(column, 0, last.x), std::clamp(row, 0, last.y)));
  };
  // Central differences; one-sided ones at the border, where half as many blocks lie between.
  const auto slope_u = [&](int column, int row) {
    const double blocks = column == 0 || column == last.x ? 1 : 2;
    return (height(column + 1, row) - height(column - 1, row)) / (blocks * block);
  };
  const auto slope_v = [&](int column, int row) {
    const double blocks = row == 0 || row == last.y ? 1 : 2;
    return (height(column, row + 1) - height(column, row - 1)) / (blocks * block);
  };
  const Ground ground{corners(cell, height).at(f),
                      {corners(cell, slope_u).at(f), corners(cell, slope_v).at(f)}};
  if (std::isnan(ground.height_m) || std::isnan(ground.slope_m.x) || std::isnan(ground.slope_m.y))
    return std::nullopt;
  return ground;
}

glm::dvec3 normal_of_slope(const Terrain& terrain, const Hit& hit, glm::dvec2 slope_m) {
  const TerrainLayer& layer = terrain.layers()[static_cast<std::size_t>(hit.grid)];
  const glm::dmat2 jacobian = layer.map->jacobian(glm::dvec2(hit.position_m));
  const glm::dvec2 gradient = terrain.frame().z_scale * (glm::transpose(jacobian) * slope_m);
  return glm::normalize(glm::dvec3(-gradient.x, -gradient.y, 1));
}

double post_distance_m(const TerrainLayer& layer) {
  return 1 / std::sqrt(std::abs(glm::determinant(layer.map->jacobian({0, 0}))));
}

}  // namespace terrview
