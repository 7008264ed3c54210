// The same posts under the same eye on a flat Earth and on the curved one.
#pragma once

#include <memory>

#include "bench/bench_dem.h"
#include "bench/bench_view.h"
#include "terrain/terrain.h"

namespace terrview {

enum class BenchEarth {
  flat,    // an affine map, and no drop
  curved,  // as if in UTM at 47 N 9 E: drop and refraction, tracks all but straight
  bent,    // as if in latitudes and longitudes at 47 N 9 E: tracks bend
};

// Throws InputError where the grid is too large for its place.
[[nodiscard]] std::shared_ptr<const Terrain> terrain_on(BenchEarth earth, const BenchDem& dem,
                                                        const BenchView& view, SurfaceModel model,
                                                        Search search);

}  // namespace terrview
