// Successive refinement: a picture from blocks of pixels that shrink where it has detail.
#pragma once

#include "render/image.h"
#include "render/sampling.h"

namespace terrview {

// Pixels of a block's side at first: 1 / 64 of the rays.
inline constexpr int kFirstBlock_px = 8;

// Traces the corners of blocks of `block_px` that are wanted and not yet traced: all of them for
// the first blocks; else those between corners of blocks twice as large that differ by more than
// `contrast`, or where an outline lies between them. `take` sees every ray.
void refine(Sampler& sampler, int block_px, float contrast, Raster<Sample>& base,
            const Sampler::Take& take);

// The picture of what has been traced so far: between corners, their colours mixed.
[[nodiscard]] Image mixed_blocks(const Raster<Sample>& base, int threads);

}  // namespace terrview
