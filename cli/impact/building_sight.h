// What an eye sees of each building of a project, whatever picture is made of it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/view_setup.h"
#include "render/facade.h"

namespace terrview {

// A point of a building that is seen.
struct SeenPoint {
  glm::dvec3 view_m{0, 0, 0};  // view frame
  double distance_m = 0;       // straight from the eye
};

struct BuildingSight {
  std::int32_t id = 0;
  double solid_angle_sr = 0;  // of what is seen
  FacadeSight facade = {};
  std::optional<SeenPoint> nearest = {};  // of what is seen; none: nothing
  std::optional<SeenPoint> farthest = {};
};

struct SightOptions {
  int rays_across = 512;  // a building's largest side
  int threads = 0;        // 0 = all the processor has; never changes the result
};

// Of the buildings whose ids are above `before`, in their order. Each is sampled by a square of
// rays of its own around it, askew, so that its edges do not run along rows of rays: a solid angle
// is off by less than a hundredth of the building's own for 512 rays across
// (tests/cli/impact/building_sight_test.cpp). The nearest and farthest points are those of these
// rays and of the facade's rectangles. The camera must have an eye: no parallel rays.
[[nodiscard]] std::vector<BuildingSight> sights_of(const View& view, std::int32_t before,
                                                   const SightOptions& options = {});

}  // namespace terrview
