// Random terrains and rays for property tests: the same on every machine for a seed.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "terrain/terrain.h"

namespace terrview {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  [[nodiscard]] double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  [[nodiscard]] int integer(int low, int high) {  // both included
    return static_cast<int>(std::floor(uniform(low, high + 1.0)));
  }
  [[nodiscard]] bool chance(double share) { return uniform(0, 1) < share; }
  [[nodiscard]] double sign() { return chance(0.5) ? 1 : -1; }

 private:
  std::mt19937_64 engine_;
};

// Whether what is drawn keeps clear of the grid's lines and posts, and of the ground, or seeks them
// out.
enum class Position { general, special };

// A grid of 2 x 2 to 40 x 40 posts: rough, smooth, flat, in steps, with voids, or one spike.
[[nodiscard]] HeightGrid random_grid(Random& random);

// One random grid under a random map on a flat, an Earth-like or a very round Earth. Posts lie a
// metre, 60 x 90 m, a centimetre, a kilometre or arc seconds apart, rotated, mirrored; the eye is
// over the grid or beside it, in special position over a post or a line.
[[nodiscard]] Terrain random_terrain(Random& random, SurfaceModel model, Position position);

// Two to four grids of unlike spacings that overlap about the eye.
[[nodiscard]] Terrain random_layers(Random& random, SurfaceModel model);

// A random grid under a BentGroundMap, whose tracks bend within cells, leave the grid and come
// back.
[[nodiscard]] Terrain random_bent_terrain(Random& random, SurfaceModel model);

// A random grid under a ParabolicGroundMap; the eye is over it, or a little beside.
[[nodiscard]] Terrain random_parabolic_terrain(Random& random, SurfaceModel model);

// From the eye or from anywhere near the ground, in any direction: grazing, level, towards the
// ground, and some of limited length. In special position: vertical, along a line of the grid, or
// through a post, from posts and from the ground itself.
[[nodiscard]] Ray random_ray(Random& random, const Terrain& terrain, Position position);

}  // namespace terrview
