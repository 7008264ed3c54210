// What light and air cost, and what their short cuts lose.
#pragma once

#include <functional>
#include <iosfwd>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "bench/bench_dem.h"

namespace terrview {

// Seconds of processor time of one picture, on one thread, with each effect alone beside a picture
// with none; the rays that haze spares and the picture it loses; the sparkle of far ground.
void print_effect_costs(std::ostream& out, const BenchDem& dem, glm::ivec2 size_px,
                        int repetitions);

// The sky views of some posts, each by so many rays.
using SkyTracer = std::function<std::vector<double>(std::span<const glm::ivec2> posts, int rays)>;

// By cosine-weighted rays through Embree, evenly spread, sixteen a packet; empty where the build
// found no Embree.
[[nodiscard]] SkyTracer embree_sky_tracer(const BenchDem& dem);

// Processor time and error of the sweep in several numbers of azimuths, of rays through Embree, and
// their ratio at equal error.
void print_sky_view_study(std::ostream& out, const BenchDem& dem);

}  // namespace terrview
