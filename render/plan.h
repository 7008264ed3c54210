// A map: the ground and what stands on it, seen straight down on the lattice of a grid.
//
// Plumb lines are those of the view frame: a point of the ground and what is above it share (x, y).
// A pixel's ground is found through its grid coordinates, so that it is the post's where a pixel is
// a post, to the bit.
#pragma once

#include <functional>

#include <glm/vec2.hpp>

#include "render/image.h"
#include "render/render.h"
#include "render/scene.h"

namespace terrview {

// Image point (x, y) is corner_uv + step_uv * (first_px + (x, y)) of the terrain's first layer.
// Where that has a hole other layers show. A part of a lattice, which begins at another of its
// pixels, makes that part of its picture, to the byte.
struct PlanLattice {
  glm::ivec2 size_px{0, 0};
  glm::dvec2 corner_uv{-0.5, -0.5};
  glm::dvec2 step_uv{1, 1};
  glm::ivec2 first_px{0, 0};
};

struct PlanOptions {
  int threads = 0;  // 0 = all the processor has; never changes the picture
  int samples = 1;  // a pixel: its colour is their mean, but for those that meet no ground
  // Called from any thread with the share done, 0 to 1; what it throws ends the work.
  std::function<void(double share)> progress = {};
};

struct PlanFrame {
  Image image;
  Raster<char> covered;  // whether the pixel's middle lies on ground
  RenderCounts counts;
};

[[nodiscard]] PlanFrame render_plan(const Scene& scene, const PlanLattice& lattice,
                                    const PlanOptions& options = {});

}  // namespace terrview
