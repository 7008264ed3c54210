#include "ingest/water_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ingest/crs_transform.h"
#include "ingest/feature_attributes.h"
#include "ingest/feature_places.h"
#include "ingest/feature_polygons.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// Of one body in the grid of one DEM.
using Outlines = std::vector<Polygon>;

std::optional<double> level_in(const VectorFeature& feature) {
  constexpr std::array<std::string_view, 5> kFields{"level_m", "level", "water_level", "elevation",
                                                    "ele"};
  const auto text = feature.text(kFields);
  if (!text) return std::nullopt;
  const auto level_m = length_of(*text);
  if (!level_m || std::abs(*level_m) >= kHighest_m)
    feature.refuse("a level of '" + *text + "': give metres");
  return level_m;
}

// From the coordinates of a file to a DEM's grid, in place; NaN for what is nowhere on the Earth.
void to_posts(const VectorFile& file, const Dem& dem, std::span<glm::dvec2> points) {
  const glm::dvec2 last(dem.grid->columns - 1, dem.grid->rows - 1);
  const glm::dvec2 middle = dem.placement.at(0.5 * last);
  if (!file.crs_wkt.empty() && !dem.crs_wkt.empty() && !points.empty()) {
    const std::array area{dem.placement.at({0, 0}), dem.placement.at({last.x, 0}),
                          dem.placement.at({0, last.y}), dem.placement.at(last), middle};
    const CrsTransform crs(dem.name, dem.crs_wkt, area);
    to_geographic(file, points);
    crs.from_geographic(points);
    if (const auto turn = crs.turn())
      for (glm::dvec2& point : points) point.x += *turn * std::round((middle.x - point.x) / *turn);
  }
  for (glm::dvec2& point : points) point = dem.placement.posts(point);
}

std::vector<glm::dvec2> corners_of(const WaterBodies& water) {
  std::vector<glm::dvec2> corners;
  for (const WaterBody& body : water.bodies)
    for (const auto& rings : body.polygons)
      for (const Polygon::Ring& ring : rings)
        corners.insert(corners.end(), ring.begin(), ring.end());
  return corners;
}

// Of each body, in the grid of `dem`.
std::vector<Outlines> outlines_in(const Dem& dem, const WaterBodies& water) {
  std::vector<glm::dvec2> corners = corners_of(water);
  to_posts(water.file, dem, corners);
  std::vector<Outlines> all;
  auto next = corners.begin();
  for (const WaterBody& body : water.bodies) {
    all.emplace_back();
    for (std::vector<Polygon::Ring> rings : body.polygons) {
      for (Polygon::Ring& ring : rings)
        for (glm::dvec2& corner : ring) {
          corner = *next++;
          if (!std::isfinite(corner.x + corner.y))
            throw InputError("'" + water.file.name + "', feature " + std::to_string(body.number) +
                             ": a corner is nowhere on the Earth: mend its coordinates or the "
                             "file's coordinate system");
        }
      all.back().emplace_back(rings);
    }
  }
  return all;
}

// The heights along an outline, at most half a post apart.
void add_shore(const HeightGrid& grid, const Polygon& outline, std::vector<double>& heights_m) {
  constexpr double kStep_posts = 0.5;
  constexpr double kMostSteps = 1e4;
  const auto corners = outline.vertices();
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    if (!outline.is_edge(i)) continue;
    const double length = glm::distance(corners[i], corners[i + 1]);
    const double steps = std::clamp(std::ceil(length / kStep_posts), 1.0, kMostSteps);
    for (double step = 0; step < steps; ++step) {
      const glm::dvec2 uv = glm::mix(corners[i], corners[i + 1], step / steps);
      if (!grid.covers(uv)) continue;
      const glm::ivec2 cell = glm::min(glm::ivec2(uv), glm::ivec2(grid.columns, grid.rows) - 2);
      const glm::dvec2 f = uv - glm::dvec2(cell);
      const auto height = [&](int u, int v) {
        return static_cast<double>(grid.at(cell.x + u, cell.y + v));
      };
      const double height_m = glm::mix(glm::mix(height(0, 0), height(1, 0), f.x),
                                       glm::mix(height(0, 1), height(1, 1), f.x), f.y);
      if (!std::isnan(height_m)) heights_m.push_back(height_m);
    }
  }
}

void add_inside(const HeightGrid& grid, const Polygon& outline, std::vector<double>& heights_m) {
  for_each_cell_of(outline, {grid.columns, grid.rows}, [&](glm::ivec2 cell) {
    if (grid.has_ground(cell.x, cell.y) && outline.contains(cell))
      heights_m.push_back(grid.at(cell.x, cell.y));
  });
}

std::optional<double> lower_quartile(std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 4);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::optional<double> level_by_ground(const HeightGrid& grid, const Outlines& outlines) {
  std::vector<double> heights_m;
  for (const Polygon& outline : outlines) add_shore(grid, outline, heights_m);
  if (heights_m.empty())
    for (const Polygon& outline : outlines) add_inside(grid, outline, heights_m);
  return lower_quartile(heights_m);
}

// Sets the posts about the cells that the outline touches; whether there are any.
bool flatten(HeightGrid& grid, const Polygon& outline, double level_m) {
  bool touched = false;
  for_each_cell_of(outline, {grid.columns, grid.rows}, [&](glm::ivec2 cell) {
    touched = true;
    for (const glm::ivec2 post : {cell, cell + glm::ivec2(1, 0), cell + glm::ivec2(0, 1), cell + 1})
      grid.heights_m[static_cast<std::size_t>(post.y) * static_cast<std::size_t>(grid.columns) +
                     static_cast<std::size_t>(post.x)] = static_cast<float>(level_m);
  });
  return touched;
}

// The levels of bodies: their own, or the ground's.
std::vector<std::optional<double>> levels_of(const std::vector<Dem>& dems, const WaterBodies& water,
                                             const std::vector<std::vector<Outlines>>& outlines) {
  std::vector<std::optional<double>> levels_m;
  for (std::size_t body = 0; body < water.bodies.size(); ++body) {
    std::optional<double> level_m = water.bodies[body].level_m;
    for (std::size_t i = 0; i < dems.size() && !level_m; ++i)
      level_m = level_by_ground(*dems[i].grid, outlines[i][body]);
    levels_m.push_back(level_m);
  }
  return levels_m;
}

}  // namespace

WaterBodies read_water(const std::string& path) {
  WaterBodies water;
  water.file = read_vector_file(path, [&](const VectorFeature& feature) {
    WaterBody body{feature.number(), polygons_of(feature), level_in(feature)};
    if (body.polygons.empty())
      ++water.without_area;
    else
      water.bodies.push_back(std::move(body));
  });
  return water;
}

FloodedDems flood(const std::vector<Dem>& dems, const WaterBodies& water) {
  FloodedDems flooded{dems, {}};
  std::vector<std::vector<Outlines>> outlines;
  for (const Dem& dem : dems) outlines.push_back(outlines_in(dem, water));
  const std::vector<std::optional<double>> levels_m = levels_of(dems, water, outlines);
  std::vector<bool> placed(water.bodies.size(), false);
  for (std::size_t i = 0; i < dems.size(); ++i) {
    auto grid = std::make_shared<HeightGrid>(*dems[i].grid);
    Outlines wet;
    for (std::size_t body = 0; body < levels_m.size(); ++body) {
      if (!levels_m[body]) continue;
      for (const Polygon& outline : outlines[i][body]) {
        if (!flatten(*grid, outline, *levels_m[body])) continue;
        placed[body] = true;
        wet.push_back(outline);
      }
    }
    const glm::ivec2 size(grid->columns, grid->rows);
    flooded.lakes.push_back(wet.empty() ? nullptr : std::make_shared<Lakes>(std::move(wet), size));
    if (!flooded.lakes.back()) continue;
    flooded.dems[i].grid = std::move(grid);
    flooded.dems[i].ceilings = nullptr;  // of the dry grid
    flooded.dems[i].means = nullptr;
  }
  for (std::size_t body = 0; body < placed.size(); ++body) {
    if (!placed[body]) continue;
    ++flooded.placed;
    if (!water.bodies[body].level_m) ++flooded.from_shore;
  }
  if (flooded.placed == 0)
    throw InputError("'" + water.file.name +
                     "': none of its features is an area on the ground of the DEM: give polygons, "
                     "check their coordinate system, or leave it out");
  return flooded;
}

}  // namespace terrview
