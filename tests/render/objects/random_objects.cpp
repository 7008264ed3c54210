#include "tests/render/objects/random_objects.h"

#include <algorithm>
#include <memory>

#include <glm/common.hpp>

#include "render/objects/box.h"
#include "render/objects/sphere.h"

namespace terrview {

Objects RandomObjects::on_lattice(int count, int size) {
  Objects objects;
  for (int i = 0; i < count; ++i) {
    const auto corner = [&] { return glm::dvec3(whole(0, size), whole(0, size), whole(0, size)); };
    const glm::dvec3 a = corner();
    const glm::dvec3 b = corner();
    if (whole(0, 3) == 0) {
      objects.push_back(std::make_shared<Sphere>(a, whole(0, 2)));
    } else {
      objects.push_back(std::make_shared<BoxObject>(Box{glm::min(a, b), glm::max(a, b)}));
    }
  }
  return objects;
}

Objects RandomObjects::scattered(int count, double widest) {
  Objects objects;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 at(real(0, 100), real(0, 100), real(0, 10));
    if (whole(0, 3) == 0) {
      objects.push_back(std::make_shared<Sphere>(at, real(0, widest / 2)));
    } else {
      const glm::dvec3 extent(real(0, widest), real(0, widest), real(0, 10));
      objects.push_back(std::make_shared<BoxObject>(Box{at, at + extent}));
    }
  }
  return objects;
}

Ray RandomObjects::lattice_ray(int size) {
  const auto quarter = [&] { return whole(-4, 4 * size + 4) / 4.0; };
  const glm::dvec3 from(quarter(), quarter(), quarter());
  glm::dvec3 to = from;
  while (to == from) {
    // Often along an axis or a plane of two.
    for (int axis = 0; axis < 3; ++axis)
      if (whole(0, 2) > 0) to[axis] = quarter();
  }
  Ray ray{from, to - from};
  if (whole(0, 3) == 0) ray.length_m = whole(0, 4 * size) / 2.0;
  return ray;
}

Ray RandomObjects::ray() {
  const glm::dvec3 from(real(-50, 150), real(-50, 150), real(-5, 30));
  const glm::dvec3 to(real(-10, 110), real(-10, 110), real(0, 12));
  Ray ray{from, to - from};
  const int kind = whole(0, 9);
  if (kind == 0) ray.direction.z = 0;
  if (kind == 1) ray.direction = {0, 0, from.z > 5 ? -1 : 1};
  if (kind == 2) ray.direction.x = 0;
  if (kind == 3) ray.length_m = real(0, 100);
  if (kind == 4) ray.origin_m -= 1e6 * ray.direction;
  return ray;
}

}  // namespace terrview
