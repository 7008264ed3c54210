// Where the sky ends.
#pragma once

#include <vector>

#include "render/camera.h"
#include "render/scene.h"

namespace terrview {

// By column of the picture, the first row (or its height) where something is hit within a few rows;
// columns between those traced take the higher of their neighbours. A guide, not an outline: peaks
// thinner than a few pixels may stand above it.
[[nodiscard]] std::vector<int> skyline_rows(const Scene& scene, const Camera& camera, int threads);

}  // namespace terrview
