// More rays for the pixels that need them.
#pragma once

#include <functional>

#include "render/image.h"
#include "render/sampling.h"

namespace terrview {

// The colour that a ray through a pixel adds to it.
using Resolve = std::function<glm::vec3(glm::ivec2 pixel, const Sample& sample)>;

// No pixel's need depends on one that is further off, along rows or columns.
inline constexpr int kAntialiasReach_px = 1;

// Replaces the pixels of `image` that need more rays than that of `base` by the mean of four or
// sixteen, by the rule of RenderOptions::samples.
void antialias(Sampler& sampler, float contrast, const Raster<Sample>& base, const Resolve& resolve,
               Image& image);

// Replaces every traced pixel of `image`, the rays through the centres, by the mean of `samples`
// rays.
void supersample(Sampler& sampler, int samples, const Raster<Sample>& base, const Resolve& resolve,
                 Image& image);

}  // namespace terrview
