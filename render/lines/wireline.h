// A view as lines: the ground's grid and the outlines of ground and objects, without what is
// hidden.
//
// Lines are found on the picture: where what the rays through the centres of two pixels meet lies
// on two sides of a line of the grid, or where one thing ends before another, which more rays
// between the two place to 1e-4 of a pixel. So nothing hidden is drawn, but for less than a pixel
// at outlines; outlines are those of the rendered picture, and the work is that of a picture,
// whatever the size of the ground. What is thinner than a pixel may be missed.
#pragma once

#include <functional>
#include <vector>

#include "render/camera.h"
#include "render/lines/polyline.h"
#include "render/scene.h"

namespace terrview {

struct WirelineTracing {
  int step_posts = 0;  // as GridLineOptions
  int threads = 0;     // 0 = all the processor has; never changes the lines
  // Called from any thread with the share done, 0 to 1; what it throws ends the work.
  std::function<void(double share)> progress = {};
};

struct ViewLine {
  LineKind kind;
  int depth = 0;  // 0 nearest, to kDepths - 1
  std::vector<glm::dvec2> points_px;
};

struct Wireline {
  static constexpr int kDepths = 6;

  // Depth d reaches from limits_m[d] to limits_m[d + 1], along the rays; equal ratios. Empty
  // without lines.
  std::vector<double> limits_m;
  std::vector<ViewLine> lines;
};

// Polylines within 0.15 pixel of the lines found, half a pixel over the picture's borders.
[[nodiscard]] Wireline trace_wireline(const Scene& scene, const Camera& camera,
                                      const WirelineTracing& options = {});

}  // namespace terrview
