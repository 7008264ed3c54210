// Objects and rays for the tests of sets of objects. Those on a lattice make nearly every ray a
// special one: through corners, along edges and faces, with flat, nested and identical boxes.
#pragma once

#include <random>

#include "render/objects/object_set.h"
#include "terrain/ray.h"

namespace terrview {

class RandomObjects {
 public:
  explicit RandomObjects(std::uint64_t seed) : engine_(seed) {}

  // Boxes and spheres with whole coordinates in [0, size].
  Objects on_lattice(int count, int size);

  // Boxes and spheres up to `widest` wide in a square of 100.
  Objects scattered(int count, double widest);

  // From and through points of the lattice's quarters in and around [0, size].
  Ray lattice_ray(int size);

  // From in or around the square, of any direction, some flat, some upright, some short.
  Ray ray();

 private:
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

  std::mt19937_64 engine_;
};

}  // namespace terrview
