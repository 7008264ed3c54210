// A uniform grid over the plane, to compare with.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "render/objects/object_set.h"
#include "render/objects/slab_ray.h"

namespace terrview {

// Square cells, one for each object, each with the list of the objects over it (Amanatides & Woo,
// Eurographics 1987).
class UniformGrid : public ObjectSet {
 public:
  explicit UniformGrid(Objects objects);

  [[nodiscard]] std::optional<ObjectHit> first_hit(const Ray& ray,
                                                   ObjectCounts* counts = nullptr) const override;
  [[nodiscard]] bool stops(const Ray& ray, ObjectCounts* counts = nullptr) const override;
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] int cell(int axis, double at_m) const;
  template <class Visit>
  void walk(const Ray& ray, ObjectCounts* counts, const Visit& visit) const;

  Box bounds_{};
  std::vector<Box> boxes_;
  double cell_m_ = 1;
  glm::ivec2 size_{1, 1};
  std::vector<int> ends_;
  std::vector<int> lists_;
};

}  // namespace terrview
