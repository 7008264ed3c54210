#include "render/objects/level_plane.h"

namespace terrview {

LevelPlane level_plane(const VerticalFrame& frame, glm::dvec2 ground_m, double scene_height_m) {
  LevelPlane plane{ground_m, frame.at(ground_m).z_m(scene_height_m), {0, 0}};
  if (frame.is_flat()) return plane;
  // The surface is so nearly a paraboloid that differences are as good as derivatives.
  constexpr double kStep_m = 50;
  for (int axis = 0; axis < 2; ++axis) {
    glm::dvec2 step(0);
    step[axis] = kStep_m;
    plane.slope[axis] = (frame.at(ground_m + step).z_m(scene_height_m) -
                         frame.at(ground_m - step).z_m(scene_height_m)) /
                        (2 * kStep_m);
  }
  return plane;
}

LevelPlane level_plane_at(const VerticalFrame& frame, const glm::dvec3& point_m) {
  const glm::dvec2 ground_m(point_m);
  return level_plane(frame, ground_m, frame.at(ground_m).scene_height_m(point_m.z));
}

}  // namespace terrview
