// What tests of rays from the eye, many at a time, expect of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
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

// Hits and facets, all equal to those of single rays. Returns how many there are.
inline int expect_hits_of_single_rays(const EyeFront& front,
                                      const std::vector<glm::dvec3>& directions) {
  const auto rays = std::make_unique<EyeRays>();
  const auto seen = std::make_unique<EyeFacets>();
  const Terrain& terrain = front.terrain();
  const int cells_in_row = terrain.layers()[0].grid->columns - 1;
  int met = 0;
  for (std::size_t first = 0; first < directions.size(); first += EyeRays::kMost) {
    rays->count = std::min(EyeRays::kMost, directions.size() - first);
    for (std::size_t i = 0; i < rays->count; ++i) rays->aim(i, directions[first + i]);
    TraceCounts counts;
    trace(front, *rays, counts);
    facets(terrain, *rays, *seen);
    for (std::size_t i = 0; i < rays->count; ++i) {
      const Ray ray{.direction = directions[first + i]};
      const auto expected = terrain.first_hit(ray);
      EXPECT_EQ(rays->is_hit(i), expected.has_value()) << oracle::to_string(ray);
      EXPECT_EQ(seen->distance_m[i],
                expected ? expected->distance_m : std::numeric_limits<double>::infinity());
      EXPECT_EQ(seen->cell[i], expected ? expected->cell.y * cells_in_row + expected->cell.x : -1);
      if (!expected || !rays->is_hit(i)) continue;
      const Hit hit = rays->hit(i);
      expect_same_hit(hit, *expected, ray);
      const glm::vec3 normal(seen->x[i], seen->y[i], seen->z[i]);
      EXPECT_EQ(normal, glm::vec3(terrain.facet_normal(hit)));
      ++met;
    }
  }
  return met;
}

}  // namespace terrview
