// A building: a polygon with holes, raised to a roof.
//
// It stands upright in the view frame: a plumb line has one ground point, so walls are exact. Base
// and roof are planes of the plumb frame of its middle (level_plane.h says how far a level surface
// is from one: a footprint 300 m across seen from 60 m is off by less than a tenth of a pixel of a
// picture 1920 wide that spans 60 degrees).
//
// Watertight: the line of a ray is inside the prism where it is above the polygon (polygon.h),
// below every plane of the roof and above the base. Each bound is computed once and shared by what
// lies on its two sides, so no ray finds its way between two walls, or between a wall and a roof.
#pragma once

#include <vector>

#include "render/objects/level_plane.h"
#include "render/objects/object.h"
#include "render/objects/polygon.h"
#include "render/objects/ray_range.h"
#include "render/objects/roof.h"

namespace terrview {

// Heights are those over `level`.
struct PrismShape {
  LevelPlane level = {};
  double base_m = 0;
  RoofOptions roof = {};
};

class Prism final : public Object {
 public:
  // SurfaceHit::part.
  enum Part { kWall, kRoof, kBase };

  // `footprint` in the view frame, with an area.
  Prism(Polygon footprint, const PrismShape& shape);

  [[nodiscard]] Box bounds() const override;
  [[nodiscard]] std::optional<SurfaceHit> first_hit(const Ray& ray) const override;
  [[nodiscard]] bool stops(const Ray& ray) const override;

  [[nodiscard]] const Polygon& footprint() const { return footprint_; }

  // Where a wall that stands over a place of the footprint begins and ends, in the view frame.
  [[nodiscard]] double foot_z_m(glm::dvec2 ground_m) const {
    return level_.z_at(ground_m) + base_m_;
  }
  [[nodiscard]] double top_z_m(glm::dvec2 ground_m) const;

 private:
  struct Line;
  struct Meeting;
  struct Heights;

  [[nodiscard]] std::optional<Meeting> meet(const Line& line, double limit_m) const;
  [[nodiscard]] Heights heights(const Line& line) const;
  void cross_sides(const Line& line, Polygon::Crossings& sides) const;
  [[nodiscard]] RayRange below_planes(const Line& line) const;
  [[nodiscard]] RayRange in_dome(const Line& line) const;
  [[nodiscard]] glm::dvec3 normal(const Line& line, const Meeting& meeting) const;

  Polygon footprint_;
  LevelPlane level_;
  double base_m_;
  Roof roof_;
  std::vector<HalfSpace> halves_;  // the roof's planes, then the base
};

}  // namespace terrview
