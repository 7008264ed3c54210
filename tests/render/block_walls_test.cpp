// Walls close a block: docs/overview.md.
#include "render/block_walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include <glm/geometric.hpp>

#include "render/meet.h"
#include "render/objects/scene_objects.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace terrview {
namespace {

constexpr double kEye_m = 20'000;
constexpr double kDeep_m = 50;

double lowest_m(const HeightGrid& grid) { return height_range(grid).lowest_m; }

struct Block {
  Place place;
  Scene scene;
  double plinth_z_m;

  Block(const HeightGrid& grid, SurfaceModel model) {
    place = {.eye_uv = {(grid.columns - 1) / 2.0, (grid.rows - 1) / 2.0},
             .spacing_m = {60, 90},
             .eye_height_m = kEye_m,
             .z_scale = 1.5};
    scene.terrain = std::make_shared<const Terrain>(make_terrain(grid, place, model));
    plinth_z_m = 1.5 * lowest_m(grid) - kDeep_m - kEye_m;
    auto objects = std::make_shared<SceneObjects>();
    objects->set = std::make_shared<const ObjectList>(
        Objects{std::make_shared<const BlockWalls>(scene.terrain, plinth_z_m, 1)});
    objects->looks.emplace_back();
    objects->walls_in_ground = true;
    scene.objects = objects;
  }

  [[nodiscard]] const HeightGrid& grid() const { return *scene.terrain->layers().front().grid; }

  [[nodiscard]] RayHits meet(const Ray& ray) const {
    RayHits hits{{scene.terrain->first_hit(ray)}};
    ObjectCounts counts;
    meet_objects(scene, {&ray, 1}, hits, counts);
    return hits;
  }
};

std::vector<glm::ivec2> cells_with_ground(const HeightGrid& grid) {
  std::vector<glm::ivec2> cells;
  for (int row = 0; row + 1 < grid.rows; ++row)
    for (int column = 0; column + 1 < grid.columns; ++column)
      if (grid.has_ground(column, row)) cells.emplace_back(column, row);
  return cells;
}

// A place in a cell; now and then as good as on its border, or a post.
glm::dvec2 place_in(glm::ivec2 cell, Random& random) {
  const auto share = [&] {
    return random.chance(0.3) ? 1e-6 + (1 - 2e-6) * random.integer(0, 1) : random.uniform(0, 1);
  };
  return glm::dvec2(cell) + glm::dvec2(share(), share());
}

// Down to `target_m` from beyond the block.
Ray ray_to(const glm::dvec3& target_m, Random& random) {
  const double azimuth = random.chance(0.3) ? random.integer(0, 7) * std::atan(1.0)
                                            : random.uniform(0, 8 * std::atan(1.0));
  const glm::dvec3 down(std::sin(azimuth), std::cos(azimuth), -random.log_uniform(0.05, 20));
  const double far_m = 30'000;
  return {target_m - far_m * glm::normalize(down), glm::normalize(down)};
}

class Walls : public testing::TestWithParam<SurfaceModel> {};

// However a ray comes to a place within the block, it has met the ground or a wall before.
TEST_P(Walls, CloseTheBlock) {
  Random random(11);
  for (int scene = 0; scene < 60; ++scene) {
    const HeightGrid grid = random_grid(random);
    const auto cells = cells_with_ground(grid);
    if (cells.empty()) continue;
    const Block block(grid, GetParam());
    for (int i = 0; i < 200; ++i) {
      const glm::ivec2 cell =
          cells[static_cast<std::size_t>(random.integer(0, static_cast<int>(cells.size()) - 1))];
      double low_m = std::numeric_limits<double>::infinity();
      for (const glm::ivec2 post :
           {cell, cell + glm::ivec2(1, 0), cell + glm::ivec2(0, 1), cell + glm::ivec2(1, 1)})
        low_m = std::min(low_m, 1.5 * block.grid().at(post.x, post.y) - kEye_m);
      // A chord may span two cells.
      if (GetParam() == SurfaceModel::band) low_m = 1.5 * lowest_m(grid) - kEye_m;
      // Below every corner, and so within the block under every surface model.
      const double z_m =
          random.chance(0.5) ? low_m - 1e-3 : random.uniform(block.plinth_z_m + 1e-3, low_m - 1e-3);
      const glm::dvec3 target_m(ground_of(block.place, place_in(cell, random)), z_m);
      const Ray ray = ray_to(target_m, random);
      const RayHits hits = block.meet(ray);
      const double distance_m = hits.ground[0]         ? hits.ground[0]->distance_m
                                : hits.meets_object(0) ? hits.objects[0]->surface.distance_m
                                                       : 1e9;
      ASSERT_LE(distance_m, glm::distance(ray.origin_m, target_m) + 1e-5)
          << "scene " << scene << ", cell " << cell.x << " " << cell.y;
    }
  }
}

// Rounding decides whether a ray to the very edge of the ground meets that or the wall: one of them
// it meets, there and then.
TEST_P(Walls, LeaveNoCrackUnderTheGround) {
  Random random(13);
  const HeightGrid grid = make_grid(37, 23, [](int column, int row) {
    return 300 + 9 * std::sin(column * 0.7) * std::cos(row * 0.9) + column / 3.0;
  });
  const Block block(grid, GetParam());
  for (int i = 0; i < 20'000; ++i) {
    const double along = random.chance(0.2) ? random.integer(1, 21) : random.uniform(0.01, 21.99);
    const int row = static_cast<int>(along);
    const double share = along - row;
    const double height_m = grid.at(0, row) * (1 - share) + grid.at(0, row + 1) * share;
    const glm::dvec3 edge_m(ground_of(block.place, {0, along}), 1.5 * height_m - kEye_m);
    const double azimuth = random.uniform(0.6, 2.5);
    const glm::dvec3 down =
        glm::normalize(glm::dvec3(std::sin(azimuth), std::cos(azimuth), -random.uniform(2, 6)));
    const Ray ray{edge_m - random.uniform(1000, 90'000) * down, down};
    const RayHits hits = block.meet(ray);
    ASSERT_TRUE(hits.ground[0] || hits.meets_object(0)) << "at " << along;
    const glm::dvec3 met_m =
        hits.ground[0] ? hits.ground[0]->position_m : hits.objects[0]->surface.position_m;
    ASSERT_LT(glm::distance(met_m, edge_m), 1e-3);
  }
}

// A wall is met on an edge that has ground on its far side alone, from its upper edge downwards.
TEST_P(Walls, StandOnEdgesOfGround) {
  Random random(12);
  int met = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const HeightGrid grid = random_grid(random);
    if (cells_with_ground(grid).empty()) continue;
    const Block block(grid, GetParam());
    const TerrainLayer& layer = block.scene.terrain->layers().front();
    for (int i = 0; i < 100; ++i) {
      const glm::dvec2 uv(random.uniform(-1, grid.columns), random.uniform(-1, grid.rows));
      const glm::dvec3 target_m(ground_of(block.place, uv), block.plinth_z_m + 1);
      const Ray ray = ray_to(target_m, random);
      const RayHits hits = block.meet(ray);
      if (!hits.meets_object(0)) continue;
      ++met;
      const SurfaceHit& wall = hits.objects[0]->surface;
      EXPECT_LT(glm::dot(wall.normal, ray.direction), 0);
      const auto has_ground = [&](double aside_m) {
        const glm::dvec2 at =
            layer.map->to_grid(glm::dvec2(wall.position_m + aside_m * wall.normal));
        const glm::ivec2 cell(glm::floor(at));
        return cell.x >= 0 && cell.y >= 0 && cell.x + 1 < grid.columns && cell.y + 1 < grid.rows &&
               grid.has_ground(cell.x, cell.y);
      };
      const glm::dvec2 at = layer.map->to_grid(glm::dvec2(wall.position_m));
      const glm::dvec2 off = glm::abs(at - glm::round(at));
      if (std::max(off.x, off.y) < 1e-3) continue;  // at a post, where walls meet
      EXPECT_TRUE(has_ground(-1e-3));
      EXPECT_FALSE(has_ground(1e-3));
      EXPECT_GE(wall.position_m.z, block.plinth_z_m - 1e-5);
      const bool along_v = off.x < off.y;
      const glm::dvec2 first = along_v ? glm::dvec2(std::round(at.x), std::floor(at.y))
                                       : glm::dvec2(std::floor(at.x), std::round(at.y));
      const glm::dvec2 second = first + (along_v ? glm::dvec2(0, 1) : glm::dvec2(1, 0));
      const auto height_m = [&](glm::dvec2 post) {
        return 1.5 * double{grid.at(static_cast<int>(post.x), static_cast<int>(post.y))};
      };
      const double share = along_v ? at.y - first.y : at.x - first.x;
      const double top_z_m = height_m(first) * (1 - share) + height_m(second) * share - kEye_m;
      EXPECT_LE(wall.position_m.z, top_z_m + 1e-4);
    }
  }
  EXPECT_GT(met, 300);
}

TEST_P(Walls, AreMetInMetresWhateverTheLengthOfADirection) {
  const Block block(make_grid(9, 7, [](int column, int row) { return 5.0 * column - 3 * row; }),
                    GetParam());
  const BlockWalls walls(block.scene.terrain, block.plinth_z_m, 1);
  Random random(14);
  int met = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec2 uv(random.uniform(-1, 9), random.uniform(-1, 7));
    const Ray ray = ray_to({ground_of(block.place, uv), block.plinth_z_m + 1}, random);
    const double length = random.log_uniform(1e-4, 1e4);
    const Ray longer{ray.origin_m, length * ray.direction};
    const auto hit = walls.first_hit(ray);
    const auto found = walls.first_hit(longer);
    ASSERT_EQ(found.has_value(), hit.has_value());
    if (!hit) continue;
    ++met;
    EXPECT_NEAR(found->distance_m, hit->distance_m, 1e-6);
    EXPECT_LT(glm::distance(found->position_m, hit->position_m), 1e-6);
    const double to_wall_m = hit->distance_m;
    EXPECT_TRUE(walls.first_hit({ray.origin_m, longer.direction, to_wall_m + 1e-3}));
    EXPECT_FALSE(walls.first_hit({ray.origin_m, longer.direction, to_wall_m - 1e-3}));
  }
  EXPECT_GT(met, 100);
}

INSTANTIATE_TEST_SUITE_P(Models, Walls, testing::ValuesIn(kSurfaceModels),
                         [](const auto& tested) { return std::string(name_of(tested.param)); });

TEST(WallsOfLayers, LeaveOutWhereAnotherLayerGoesOn) {
  const auto flat = [](int, int) { return 100.0; };
  const Place west{.eye_uv = {10, 5}, .spacing_m = {100, 100}, .eye_height_m = 1000};
  const Place east{.eye_uv = {1, 10}, .spacing_m = {50, 50}, .eye_height_m = 1000};
  std::vector<TerrainLayer> layers{make_layer(make_grid(11, 11, flat), west),
                                   make_layer(make_grid(21, 21, flat), east)};
  const auto terrain = std::make_shared<const Terrain>(
      std::move(layers), VerticalFrame{.eye_height_m = 1000}, SurfaceModel::hyperboloid);
  const BlockWalls walls(terrain, -2000, 1);
  const Ray level{{-5000, 0, -850}, {1, 0, 0}};
  EXPECT_FALSE(walls.first_hit(level)) << "over the ground";
  const Ray into_west{{-5000, 0, -1000}, {1, 0, 0}};
  EXPECT_NEAR(walls.first_hit(into_west)->position_m.x, -1000, 1e-6);
  const Ray from_within{{-500, 0, -1000}, {1, 0, 0}};
  EXPECT_FALSE(walls.first_hit(from_within)) << "a wall between the layers, or from inside";
  const Ray into_east{{5000, 0, -1000}, {-1, 0, 0}};
  EXPECT_NEAR(walls.first_hit(into_east)->position_m.x, 950, 1e-6);
}

TEST(WallsOfLayers, StandWhereTwoEndOnOneLineAsHighAsThePreferredGround) {
  constexpr double kSide_m = 2000;
  const glm::dvec2 west_north_m(-740, 1220);  // of the eye
  const auto layer = [&](int cells, double height_m) {
    const double spacing_m = kSide_m / cells;
    return make_layer(
        make_grid(cells + 1, cells + 1, [=](int, int) { return height_m; }),
        {.eye_uv = {740 / spacing_m, 1220 / spacing_m}, .spacing_m = {spacing_m, spacing_m}});
  };
  const TerrainLayer fine = layer(43, 100);
  const TerrainLayer coarse = layer(20, 80);
  Random random(15);
  for (const bool fine_first : {true, false}) {
    const std::vector<TerrainLayer> layers =
        fine_first ? std::vector{fine, coarse} : std::vector{coarse, fine};
    const BlockWalls walls(
        std::make_shared<const Terrain>(layers, VerticalFrame{.eye_height_m = 1000},
                                        SurfaceModel::hyperboloid),
        -2000, 1);
    for (int i = 0; i < 4000; ++i) {
      const double along_m = random.uniform(1, kSide_m - 1);
      const double across_m = random.integer(0, 1) * kSide_m;
      const glm::dvec2 place_m =
          random.chance(0.5) ? glm::dvec2(along_m, across_m) : glm::dvec2(across_m, along_m);
      const glm::dvec2 inward =
          glm::normalize(kSide_m / 2 - place_m + glm::dvec2(random.uniform(-400, 400)));
      const double height_m = random.uniform(-900, 120);
      const glm::dvec3 edge_m(west_north_m + place_m * glm::dvec2(1, -1), height_m - 1000);
      const glm::dvec3 level(inward * glm::dvec2(1, -1), 0);
      const auto wall = walls.first_hit({edge_m - 3000.0 * level, level});
      ASSERT_EQ(wall.has_value(), height_m < (fine_first ? 100 : 80)) << height_m;
      if (wall) {
        ASSERT_LT(glm::distance(wall->position_m, edge_m), 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace terrview
