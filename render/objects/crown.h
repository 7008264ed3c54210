// A tree: a crown, which is an upright ellipsoid, on a trunk, which is an upright cylinder.
#pragma once

#include "render/objects/level_plane.h"
#include "render/objects/object.h"
#include "render/objects/ray_range.h"

namespace terrview {

// Heights are those over `level`, whose middle the tree stands at.
struct CrownShape {
  LevelPlane level = {};
  double foot_m = 0;    // of the trunk
  double bottom_m = 0;  // of the crown
  double top_m = 10;
  double radius_m = 3;
  double trunk_radius_m = 0.2;  // 0 = no trunk
};

class Crown final : public Object {
 public:
  // SurfaceHit::part.
  enum Part { kLeaves, kTrunk };

  explicit Crown(const CrownShape& shape) : shape_(shape) {}

  [[nodiscard]] Box bounds() const override;
  [[nodiscard]] std::optional<SurfaceHit> first_hit(const Ray& ray) const override;

 private:
  struct Line;

  [[nodiscard]] RayRange in_leaves(const Line& line) const;
  [[nodiscard]] RayRange in_trunk(const Line& line) const;
  // Outward, in the plumb frame.
  [[nodiscard]] glm::dvec3 normal(const glm::dvec3& plumb_m, int surface) const;

  CrownShape shape_;
};

}  // namespace terrview
