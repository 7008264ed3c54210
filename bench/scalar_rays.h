// Every ray on its own, by the scalar walk in double precision: with Search::plain, the reference;
// and shadow rays, the default way.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "bench/bench_view.h"
#include "bench/contender.h"
#include "bench/traced_frame.h"
#include "terrain/sun_map.h"
#include "terrain/terrain.h"

namespace terrview {

// Writes pixel `pixel` of `frame`.
void store(const std::optional<Hit>& hit, const Terrain& terrain, TracedFrame& frame,
           std::size_t pixel);

FrameWork trace_rays(const Terrain& terrain, const Camera& camera, int threads, TracedFrame& frame);
// `map`: sun_map_of() them, or null.
FrameWork shade_rays(const Terrain& terrain, const BenchView& view, const SunMap* map,
                     const ShadowRays& rays, int threads, ShadowFrame& frame);
// Of the part of the ground where `rays` begin.
[[nodiscard]] std::shared_ptr<const SunMap> sun_map_of(const Terrain& terrain,
                                                       const BenchView& view,
                                                       const ShadowRays& rays, int threads);

// Rays towards the sun from the ground that `frame` shows. They start where a float can say so, a
// millimetre above the ground there, so that no contender meets the ground it leaves.
[[nodiscard]] ShadowRays shadow_rays(const Terrain& terrain, const BenchView& view,
                                     const TracedFrame& frame);

}  // namespace terrview
