#include "tests/support/random_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/support/bent_map.h"
#include "tests/support/parabolic_map.h"

namespace terrview {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kEarthRadius_m = 6371e3;

double smooth_height(double c, double r) { return std::sin(0.7 * c) + std::cos(0.4 * r + 0.3 * c); }

HeightGrid sized_grid(int columns, int rows) {
  return {columns, rows,
          std::vector<float>(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))};
}

void dig_voids(Random& random, HeightGrid& grid) {
  const double share = random.chance(0.5) ? 0.02 : 0.2;
  for (std::size_t i = 1; i < grid.heights_m.size(); ++i)
    if (random.chance(share)) grid.heights_m[i] = std::numeric_limits<float>::quiet_NaN();
}

// A call's arguments are drawn in an order of the compiler's, so whatever is drawn has a name.
glm::dvec2 uniform_place(Random& random, double most_u, double most_v) {
  const double v = random.uniform(0, most_v);
  const double u = random.uniform(0, most_u);
  return {u, v};
}

// Grid posts per metre, u and v.
glm::dvec2 random_density(Random& random) {
  constexpr std::array<std::array<double, 2>, 6> spacings_m{
      {{1, 1}, {60, 90}, {0.01, 0.01}, {1000, 1000}, {20.6, 30.9}, {5, 50}}};
  const auto& spacing_m = spacings_m[static_cast<std::size_t>(random.integer(0, 5))];
  return {1 / spacing_m[0], 1 / spacing_m[1]};
}

// d(u, v) / d(x, y) for posts so dense along u and v.
glm::dmat2 random_jacobian(Random& random, glm::dvec2 density) {
  const double angle = random.chance(0.5) ? 0 : random.uniform(0, 2 * kPi);
  const double mirror = random.chance(0.8) ? -1 : 1;  // rows run south in most files
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {density.x * c, mirror * density.y * s, -density.x * s, mirror * density.y * c};
}

glm::dvec2 random_eye_uv(Random& random, const HeightGrid& grid, Position position) {
  const glm::dvec2 last(grid.columns - 1, grid.rows - 1);
  if (random.chance(0.2)) return {random.uniform(-1, 2) * last.x, random.uniform(-1, 2) * last.y};
  glm::dvec2 uv = uniform_place(random, last.x, last.y);
  if (position == Position::special && random.chance(0.5)) uv.x = std::round(uv.x);
  if (position == Position::special && random.chance(0.5)) uv.y = std::round(uv.y);
  return uv;
}

double random_height_m(Random& random, const HeightGrid& grid) {
  return grid.heights_m[static_cast<std::size_t>(
      random.integer(0, static_cast<int>(grid.heights_m.size()) - 1))];
}

VerticalFrame random_frame(Random& random, const HeightGrid& grid, double reach_m,
                           Position position) {
  VerticalFrame frame;
  constexpr std::array<double, 4> scales{1, 1, 2, 0.1};
  frame.z_scale = scales[static_cast<std::size_t>(random.integer(0, 3))];
  const HeightRange range = height_range(grid);
  if (random.chance(0.5)) {
    const double least_m =
        10 * (reach_m + 10 * std::fabs(range.lowest_m) + 10 * std::fabs(range.highest_m));
    const double radius_m = random.chance(0.5) ? std::max(kEarthRadius_m, least_m) : least_m;
    frame.north_curvature_per_m = 1 / radius_m;
    // z jumps where the azimuth does, at the eye: a ray in special position may pass just there.
    const double flattening = position == Position::general ? random.uniform(0.99, 1) : 1;
    frame.east_curvature_per_m = flattening / radius_m;
    frame.refraction = random.chance(0.5) ? 0.13 : 0;
  }
  const double spread_m = std::max(1.0F, range.highest_m - range.lowest_m);
  const double ground_m = random_height_m(random, grid);
  const double eye_m =
      random.chance(0.2) && !std::isnan(ground_m)
          ? ground_m + random.log_uniform(1e-3, 2)
          : random.uniform(range.lowest_m - 0.1 * spread_m, range.highest_m + 0.6 * spread_m);
  frame.eye_height_m = frame.z_scale * eye_m;
  return frame;
}

double z_of_ground_m(const Terrain& terrain, const HeightGrid& grid, int column, int row,
                     glm::dvec2 ground_m) {
  const float height_m = grid.at(column, row);
  return terrain.frame().at(ground_m).z_m(
      std::isnan(height_m) ? 0 : height_m * terrain.frame().z_scale);
}

glm::dvec2 ground_of(const GroundMap& map, glm::dvec2 uv) {
  return glm::inverse(map.jacobian({0, 0})) * (uv - map.to_grid({0, 0}));
}

glm::dvec3 random_post(Random& random, const Terrain& terrain) {
  const TerrainLayer& layer = terrain.layers().front();
  const int column = random.integer(0, layer.grid->columns - 1);
  const int row = random.integer(0, layer.grid->rows - 1);
  const glm::dvec2 ground_m = ground_of(*layer.map, {column, row});
  return {ground_m, z_of_ground_m(terrain, *layer.grid, column, row, ground_m)};
}

// The eye, or a point over the grid or a little beside it, mostly above the ground.
glm::dvec3 random_origin(Random& random, const Terrain& terrain, Position position) {
  if (random.chance(0.6)) return {0, 0, 0};
  const glm::dvec3 post = random_post(random, terrain);
  if (position == Position::special && random.chance(0.5)) return post;
  const TerrainLayer& layer = terrain.layers().front();
  const double v = random.uniform(-0.1, 1.1) * (layer.grid->rows - 1);
  const double u = random.uniform(-0.1, 1.1) * (layer.grid->columns - 1);
  const double rise_m = std::fabs(random_post(random, terrain).z - post.z) + 1;
  return {ground_of(*layer.map, {u, v}), post.z + random.uniform(-0.1, 1) * rise_m};
}

glm::dvec2 random_azimuth(Random& random) {
  const double azimuth = random.uniform(0, 2 * kPi);
  return {std::sin(azimuth), std::cos(azimuth)};
}

// Towards a post, or a little beside it.
glm::dvec3 random_aim(Random& random, const Terrain& terrain, glm::dvec3 origin_m, double spread) {
  const glm::dvec3 aim = random_post(random, terrain) - origin_m;
  const double z = random.uniform(-1, 1);
  const double y = random.uniform(-1, 1);
  const double x = random.uniform(-1, 1);
  const glm::dvec3 direction = aim + glm::dvec3(x, y, z) * spread * glm::length(aim);
  return glm::length(direction) > 0 ? glm::normalize(direction) : glm::dvec3(0, 0, -1);
}

glm::dvec3 random_direction(Random& random, const Terrain& terrain, glm::dvec3 origin_m) {
  const glm::dvec2 azimuth = random_azimuth(random);
  switch (random.integer(0, 6)) {
    case 0:
      return {azimuth, 0};
    case 1:
      return glm::normalize(glm::dvec3(azimuth, random.sign() * random.log_uniform(1e-7, 1)));
    case 2:
      return glm::normalize(glm::dvec3(azimuth, random.uniform(-2, 0.3)));
    default:
      return random_aim(random, terrain, origin_m, random.log_uniform(1e-3, 0.3));
  }
}

glm::dvec3 random_special_direction(Random& random, const Terrain& terrain, glm::dvec3 origin_m) {
  const GroundMap& map = *terrain.layers().front().map;
  switch (random.integer(0, 3)) {
    case 0:
      return {0, 0, random.sign()};
    case 1:
      return {random_azimuth(random), 0};
    case 2: {  // along a line of the grid
      const glm::dvec2 along =
          random.chance(0.5) ? glm::dvec2(random.sign(), 0) : glm::dvec2(0, random.sign());
      return glm::normalize(glm::dvec3(glm::normalize(glm::inverse(map.jacobian({0, 0})) * along),
                                       random.uniform(-0.3, 0.1)));
    }
    default:
      return random_aim(random, terrain, origin_m, 0);
  }
}

}  // namespace

HeightGrid random_grid(Random& random) {
  const bool least = random.chance(0.1);
  const int rows = least ? 2 : random.integer(2, 40);
  const int columns = least ? 2 : random.integer(2, 40);
  HeightGrid grid = sized_grid(columns, rows);
  const int kind = random.integer(0, 5);
  const double relief_m = random.log_uniform(1, 2000);
  const double base_m = random.uniform(-100, 3000);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      double height = 0;
      if (kind <= 2) height = random.uniform(0, 1) + 2 * smooth_height(column, row);
      if (kind == 3) height = smooth_height(0.3 * column, 0.3 * row);
      if (kind == 4) height = std::floor(2 * smooth_height(0.5 * column, row));
      grid.heights_m[static_cast<std::size_t>(row * grid.columns + column)] =
          static_cast<float>(base_m + relief_m * height);
    }
  }
  if (kind == 5 && random.chance(0.5)) grid.heights_m[grid.heights_m.size() / 2] += 500;
  if (random.chance(0.3)) dig_voids(random, grid);
  return grid;
}

Terrain random_terrain(Random& random, SurfaceModel model, Position position) {
  const auto grid = std::make_shared<const HeightGrid>(random_grid(random));
  const glm::dmat2 jacobian = random_jacobian(random, random_density(random));
  const glm::dvec2 eye_uv = random_eye_uv(random, *grid, position);
  const auto map = std::make_shared<const AffineGroundMap>(eye_uv, jacobian,
                                                           glm::ivec2(grid->columns, grid->rows));
  return {{{grid, map}}, random_frame(random, *grid, map->reach_m(), position), model};
}

Terrain random_layers(Random& random, SurfaceModel model) {
  const glm::dvec2 density = random_density(random);
  std::vector<TerrainLayer> layers;
  double reach_m = 0;
  const int count = random.integer(2, 4);
  for (int i = 0; i < count; ++i) {
    const auto grid = std::make_shared<const HeightGrid>(random_grid(random));
    const glm::dmat2 jacobian = random_jacobian(random, density * random.log_uniform(0.2, 5));
    const glm::dvec2 eye_uv = random_eye_uv(random, *grid, Position::general);
    const auto map = std::make_shared<const AffineGroundMap>(eye_uv, jacobian,
                                                             glm::ivec2(grid->columns, grid->rows));
    layers.push_back({grid, map});
    reach_m = std::max(reach_m, map->reach_m());
  }
  return {layers, random_frame(random, *layers.front().grid, reach_m, Position::general), model};
}

Terrain random_bent_terrain(Random& random, SurfaceModel model) {
  const auto grid = std::make_shared<const HeightGrid>(random_grid(random));
  const glm::dvec2 eye_uv = uniform_place(random, grid->columns - 1, grid->rows - 1);
  const double spacing_m = random.log_uniform(1, 100);
  const double reach_m = spacing_m * (grid->columns + grid->rows);
  // Never more than a few tenths of a radian within a cell.
  const double turn = random.sign() * random.uniform(0.01, 0.1) * (grid->columns + grid->rows);
  const double twist_per_m2 = turn / (reach_m * reach_m);
  const auto map = std::make_shared<const BentGroundMap>(eye_uv, spacing_m, twist_per_m2, reach_m);
  return {{{grid, map}}, random_frame(random, *grid, reach_m, Position::general), model};
}

Terrain random_parabolic_terrain(Random& random, SurfaceModel model) {
  const auto grid = std::make_shared<const HeightGrid>(random_grid(random));
  const glm::dvec2 size(grid->columns - 1, grid->rows - 1);
  const bool beside = random.chance(0.2);
  const glm::dvec2 eye_uv =
      uniform_place(random, size.x, size.y) + glm::dvec2(beside ? 1.2 * size.x : 0, 0);
  const double spacing_m = random.log_uniform(1, 100);
  const double reach_m = 2.5 * spacing_m * (size.x + size.y);
  // Some lines leave the grid and come back.
  const double bend_per_m = random.sign() * random.uniform(0.01, 0.15) / reach_m;
  const auto map =
      std::make_shared<const ParabolicGroundMap>(eye_uv, spacing_m, bend_per_m, reach_m);
  return {{{grid, map}}, random_frame(random, *grid, reach_m, Position::general), model};
}

Ray random_ray(Random& random, const Terrain& terrain, Position position) {
  Ray ray;
  ray.origin_m = random_origin(random, terrain, position);
  ray.direction = position == Position::special
                      ? random_special_direction(random, terrain, ray.origin_m)
                      : random_direction(random, terrain, ray.origin_m);
  if (random.chance(0.3)) ray.direction *= random.log_uniform(1e-3, 1e3);
  if (random.chance(0.2)) ray.length_m = random.uniform(0, 1) * terrain.reach_m();
  return ray;
}

}  // namespace terrview
