// Which of many objects a ray meets first.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "render/objects/object.h"

namespace terrview {

using Objects = std::vector<std::shared_ptr<const Object>>;

struct ObjectHit {
  SurfaceHit surface;
  int object;  // its index
};

// Whether a hit comes before the nearest so far: of several at one distance, that of the first
// object does.
[[nodiscard]] inline bool comes_before(const SurfaceHit& hit, int object,
                                       const std::optional<ObjectHit>& nearest) {
  if (!nearest || hit.distance_m < nearest->surface.distance_m) return true;
  return hit.distance_m == nearest->surface.distance_m && object < nearest->object;
}

// The work of a query.
struct ObjectCounts {
  std::int64_t tests = 0;  // objects compared with the ray
  std::int64_t steps = 0;  // moves through whatever structure leads to them

  ObjectCounts& operator+=(const ObjectCounts& other) {
    tests += other.tests;
    steps += other.steps;
    return *this;
  }
};

// Immutable, so threads may share one.
class ObjectSet {
 public:
  virtual ~ObjectSet() = default;
  ObjectSet(const ObjectSet&) = delete;
  ObjectSet& operator=(const ObjectSet&) = delete;

  // The nearest hit; of several at one distance, that of the first object. Adds the work done to
  // `counts`, if given.
  [[nodiscard]] virtual std::optional<ObjectHit> first_hit(
      const Ray& ray, ObjectCounts* counts = nullptr) const = 0;

  // Whether any object stops the ray.
  [[nodiscard]] virtual bool stops(const Ray& ray, ObjectCounts* counts = nullptr) const = 0;

  [[nodiscard]] const Objects& objects() const { return objects_; }

 protected:
  explicit ObjectSet(Objects objects) : objects_(std::move(objects)) {}

 private:
  Objects objects_;
};

// Tests every object: the reference.
class ObjectList : public ObjectSet {
 public:
  explicit ObjectList(Objects objects) : ObjectSet(std::move(objects)) {}

  [[nodiscard]] std::optional<ObjectHit> first_hit(const Ray& ray,
                                                   ObjectCounts* counts = nullptr) const override;
  [[nodiscard]] bool stops(const Ray& ray, ObjectCounts* counts = nullptr) const override;
};

}  // namespace terrview
