// What tests of rays from the eye, many at a time, expect of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <glm/matrix.hpp>

#include "terrain/eye_tracer.h"
#include "tests/support/expectations.h"

namespace terrview {

// The ground point of a place of the grid, by Newton's method.
inline glm::dvec2 ground_at(const GroundMap& map, glm::dvec2 uv) {
  glm::dvec2 ground_m(0);
  for (int i = 0; i < 8; ++i)
    ground_m += glm::inverse(map.jacobian(ground_m)) * (uv - map.to_grid(ground_m));
  return ground_m;
}

struct Facets {
  explicit Facets(std::size_t count)
      : distance_m(count), cell(count), normal_x(count), normal_y(count) {}

  [[nodiscard]] EyeFacets part(std::size_t first, std::size_t count) {
    const auto some = [&](auto& values) { return std::span(values).subspan(first, count); };
    return {some(distance_m), some(cell), some(normal_x), some(normal_y)};
  }

  std::vector<double> distance_m;
  std::vector<std::int32_t> cell;
  std::vector<float> normal_x, normal_y;
};

// Hits and facets, all equal to those of single rays. Returns how many there are.
inline int expect_hits_of_single_rays(const EyeFront& front,
                                      const std::vector<glm::dvec3>& directions) {
  const auto rays = std::make_unique<EyeRays>();
  const Terrain& terrain = front.terrain();
  const int cells_in_row = terrain.layers()[0].grid->columns - 1;
  int met = 0;
  for (std::size_t first = 0; first < directions.size(); first += EyeRays::kMost) {
    rays->count = std::min(EyeRays::kMost, directions.size() - first);
    for (std::size_t i = 0; i < rays->count; ++i) rays->aim(i, directions[first + i]);
    TraceCounts counts;
    trace(front, *rays, counts);
    Facets seen(rays->count);
    const std::size_t half = rays->count / 2;
    facets(terrain, *rays, 0, seen.part(0, half));
    facets(terrain, *rays, half, seen.part(half, rays->count - half));
    for (std::size_t i = 0; i < rays->count; ++i) {
      const Ray ray{.direction = directions[first + i]};
      const auto expected = terrain.first_hit(ray);
      EXPECT_EQ(rays->is_hit(i), expected.has_value()) << oracle::to_string(ray);
      EXPECT_EQ(seen.distance_m[i],
                expected ? expected->distance_m : std::numeric_limits<double>::infinity());
      EXPECT_EQ(seen.cell[i], expected ? expected->cell.y * cells_in_row + expected->cell.x : -1);
      if (!expected || !rays->is_hit(i)) continue;
      const Hit hit = rays->hit(i);
      expect_same_hit(hit, *expected, ray);
      const glm::vec2 normal(seen.normal_x[i], seen.normal_y[i]);
      EXPECT_EQ(normal, glm::vec2(terrain.facet_normal(hit)));
      ++met;
    }
  }
  return met;
}

}  // namespace terrview
