// DEMs in every kind of coordinate system, and an oracle that knows where their posts are.
#pragma once

#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <proj.h>
#include <GeographicLib/Geodesic.hpp>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "ingest/crs_transform.h"
#include "ingest/dem.h"
#include "ingest/exact_ground_map.h"

namespace terrview::cases {

struct GridCase {
  std::string name;
  std::string crs;
  glm::dvec2 north_west;
  double spacing;  // in the CRS
  glm::ivec2 posts;
  glm::dvec2 eye_share;  // of the grid; outside 0 to 1 = beside it
};

inline std::vector<GridCase> grid_cases() {
  const double arc_seconds_3 = 1.0 / 1200;
  return {
      {"geographic", "EPSG:4326", {6.5, 48.6}, arc_seconds_3, {1201, 1201}, {0.4, 0.6}},
      {"geographic beside", "EPSG:4326", {6.5, 48.6}, arc_seconds_3, {1201, 601}, {-0.3, 0.2}},
      {"geographic from afar", "EPSG:4326", {6.5, 48.6}, arc_seconds_3, {1201, 601}, {2.9, -1.7}},
      {"geographic far north", "EPSG:4326", {15, 79.5}, arc_seconds_3, {1201, 601}, {0.5, 0.5}},
      {"antimeridian", "EPSG:4326", {179.6, -16.3}, arc_seconds_3, {1201, 1201}, {0.8, 0.5}},
      {"antimeridian from the west",
       "EPSG:4326",
       {179.6, -16.3},
       arc_seconds_3,
       {1201, 1201},
       {0.1, 0.5}},
      {"up to the pole", "EPSG:4326", {10, 90}, arc_seconds_3, {1201, 1201}, {0.5, 0.05}},
      {"near the south pole", "EPSG:4326", {-70, -89}, arc_seconds_3, {1201, 1001}, {0.5, 0.5}},
      {"UTM", "EPSG:32632", {300000, 5400000}, 75, {1500, 1500}, {0.5, 0.5}},
      {"UTM from its corner", "EPSG:32632", {300000, 5400000}, 75, {1500, 1500}, {-0.1, 1.1}},
      {"UTM, small", "EPSG:32632", {350000, 5312000}, 75, {200, 300}, {0.3, 0.8}},
      {"UTM, a metre", "EPSG:25832", {356000, 5700000}, 1, {1000, 1000}, {0.5, 0.5}},
      {"web Mercator", "EPSG:3857", {730000, 6180000}, 100, {1000, 1000}, {0.5, 0.5}},
      {"web Mercator, antimeridian",
       "EPSG:3857",
       {19990000, -1800000},
       100,
       {1000, 1000},
       {0.7, 0.5}},
      {"British grid", "EPSG:27700", {160000, 860000}, 50, {2000, 2000}, {0.4, 0.6}},
      {"polar stereographic", "EPSG:3413", {-80000, 70000}, 100, {1500, 1500}, {0.2, 0.3}},
      {"Antarctic", "EPSG:3031", {-400000, -1300000}, 100, {1500, 1500}, {0.5, 0.5}},
      {"European LAEA", "EPSG:3035", {4100000, 2800000}, 100, {1500, 1500}, {0.5, 0.5}},
      {"Swiss", "EPSG:2056", {2600000, 1250000}, 50, {2000, 2000}, {0.5, 0.5}},
      // The shift of its datum comes from a grid where PROJ has that, and the map has creases.
      {"German", "EPSG:31467", {3450000, 5700000}, 50, {2000, 2000}, {0.5, 0.5}},
      {"French conic", "EPSG:2154", {900000, 6800000}, 75, {1500, 1500}, {0.5, 0.5}},
  };
}

inline PostPlacement placement(const GridCase& grid) {
  return {grid.north_west, glm::dmat2(grid.spacing, 0, 0, -grid.spacing)};
}

inline std::shared_ptr<const CrsTransform> transform(const GridCase& grid) {
  std::vector<glm::dvec2> area;
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 4; ++j)
      area.push_back(placement(grid).at(glm::dvec2(grid.posts - 1) * glm::dvec2(i, j) / 4.0));
  return std::make_shared<CrsTransform>(grid.name, grid.crs, area);
}

inline glm::dvec2 eye_uv(const GridCase& grid) {
  return grid.eye_share * glm::dvec2(grid.posts - 1);
}

inline GeoPoint eye_point(const GridCase& grid, const CrsTransform& crs) {
  glm::dvec2 eye = placement(grid).at(eye_uv(grid));
  crs.to_geographic({&eye, 1});
  return {eye.y, eye.x};
}

// Hills and noise, in metres.
inline std::shared_ptr<const HeightGrid> hills(glm::ivec2 posts, double highest_m) {
  auto grid = std::make_shared<HeightGrid>();
  grid->columns = posts.x;
  grid->rows = posts.y;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(0, static_cast<float>(highest_m));
  for (int i = 0; i < posts.x * posts.y; ++i) grid->heights_m.push_back(noise(random));
  return grid;
}

inline Dem dem(const GridCase& grid, double highest_m = 3000) {
  Dem made;
  made.name = grid.name;
  made.grid = hills(grid.posts, highest_m);
  made.placement = placement(grid);
  made.crs_wkt = grid.crs;
  return made;
}

// Where ground points are in a grid, by GeographicLib and PROJ and nothing of the project's.
class Oracle {
 public:
  Oracle(const GridCase& grid, GeoPoint eye)
      : grid_(grid), eye_(eye), context_(proj_context_create()), crs_(nullptr) {
    proj_context_set_enable_network(context_, 0);
    PJ* const chosen = proj_create_crs_to_crs(context_, "EPSG:4326", grid.crs.c_str(), nullptr);
    crs_ = proj_normalize_for_visualization(context_, chosen);
    proj_destroy(chosen);
  }
  ~Oracle() {
    proj_destroy(crs_);
    proj_context_destroy(context_);
  }
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;

  [[nodiscard]] glm::dvec2 to_grid(glm::dvec2 ground_m) const {
    const double azimuth_deg = std::atan2(ground_m.x, ground_m.y) * 57.29577951308232;
    double latitude = 0;
    double longitude = 0;
    GeographicLib::Geodesic::WGS84().Direct(eye_.latitude_deg, eye_.longitude_deg, azimuth_deg,
                                            std::hypot(ground_m.x, ground_m.y), latitude,
                                            longitude);
    const PJ_COORD xy = proj_trans(crs_, PJ_FWD, proj_coord(longitude, latitude, 0, 0));
    return posts(nearest_turn(xy.xy.x), xy.xy.y);
  }

  [[nodiscard]] GeoPoint geographic(glm::dvec2 uv) const {
    const PJ_COORD place = proj_trans(crs_, PJ_INV,
                                      proj_coord(grid_.north_west.x + uv.x * grid_.spacing,
                                                 grid_.north_west.y - uv.y * grid_.spacing, 0, 0));
    return {place.xy.y, place.xy.x};
  }

 private:
  [[nodiscard]] glm::dvec2 posts(double x, double y) const {
    return {(x - grid_.north_west.x) / grid_.spacing, (grid_.north_west.y - y) / grid_.spacing};
  }

  // x as near to the grid's middle as whole turns of longitude allow.
  [[nodiscard]] double nearest_turn(double x) const {
    const double turn = grid_.crs == "EPSG:4326"   ? 360
                        : grid_.crs == "EPSG:3857" ? 2 * 3.14159265358979323846 * 6378137
                                                   : 0;
    if (turn == 0) return x;
    const double middle = grid_.north_west.x + grid_.spacing * (grid_.posts.x - 1) / 2;
    return x + turn * std::round((middle - x) / turn);
  }

  GridCase grid_;
  GeoPoint eye_;
  PJ_CONTEXT* context_;
  PJ* crs_;
};

}  // namespace terrview::cases
