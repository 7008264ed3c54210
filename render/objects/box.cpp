#include "render/objects/box.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/objects/slab_ray.h"

namespace terrview {
namespace {

struct FaceHit {
  double distance_m;
  int axis;
  bool high;  // the face of the box's higher coordinate
};

// Where a ray from within the box meets its surface: at once where it lies in a face.
FaceHit leaving(const SlabRay& slabs, const Box& box) {
  FaceHit hit{SlabRay::kFarthest_m, 0, false};
  for (int axis = 0; axis < 3; ++axis) {
    const double near_m = slabs.near_m(axis, box);
    const double far_m = slabs.far_m(axis, box);
    if (std::isnan(near_m) || std::isnan(far_m)) return {0, axis, !std::isnan(near_m)};
    if (far_m < hit.distance_m) hit = {far_m, axis, !slabs.backward(axis)};
  }
  return hit;
}

std::optional<FaceHit> first_face(const SlabRay& slabs, const Box& box) {
  if (!slabs.within(box)) return std::nullopt;
  FaceHit hit{-1, 0, false};
  for (int axis = 0; axis < 3; ++axis) {
    const double near_m = slabs.near_m(axis, box);
    if (near_m > hit.distance_m) hit = {near_m, axis, slabs.backward(axis)};
  }
  if (hit.distance_m >= 0) return hit;
  hit = leaving(slabs, box);
  if (hit.distance_m > slabs.length_m()) return std::nullopt;
  return hit;
}

}  // namespace

std::optional<SurfaceHit> BoxObject::first_hit(const Ray& ray) const {
  const auto face = first_face(SlabRay(ray), box_);
  if (!face) return std::nullopt;
  SurfaceHit hit{face->distance_m, {}, {0, 0, 0}, 2 * face->axis + (face->high ? 1 : 0)};
  const glm::dvec3 along = glm::normalize(ray.direction) * face->distance_m;
  hit.position_m = glm::clamp(ray.origin_m + along, box_.lowest_m, box_.highest_m);
  hit.position_m[face->axis] = (face->high ? box_.highest_m : box_.lowest_m)[face->axis];
  hit.normal[face->axis] = face->high ? 1 : -1;
  return hit;
}

bool BoxObject::stops(const Ray& ray) const { return first_face(SlabRay(ray), box_).has_value(); }

}  // namespace terrview
