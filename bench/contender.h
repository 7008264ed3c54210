// A way of tracing a view, as the benchmark sees it.
//
// To add one: make a Contender whose tracer takes the rays of the view's camera, or the shadow rays
// given, to a frame, and append it in terrview_contenders().
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_dem.h"
#include "bench/bench_earth.h"
#include "bench/bench_view.h"
#include "bench/traced_frame.h"
#include "terrain/terrain.h"

namespace terrview {

// The work of a frame, summed over its rays; what a contender does not count stays empty.
struct FrameWork {
  std::optional<std::int64_t> tests;
  std::optional<std::int64_t> nodes;
};

// A contender with the eye of one view: what is timed. It makes the rays, traces them and writes
// the frame. Either is empty where the contender traces none.
struct ViewTracer {
  std::function<FrameWork(int threads, TracedFrame&)> primary;
  std::function<FrameWork(const ShadowRays&, int threads, ShadowFrame&)> shadow;
};

struct Contender {
  std::string name;
  std::optional<SurfaceModel> surface;  // none: it traces nothing
  BenchEarth earth = BenchEarth::flat;
  std::optional<double> build_s;     // once per DEM, with all threads
  std::optional<double> ready_s;     // the same with buffers: from heights to the first ray
  std::optional<double> memory_mib;  // beyond the heights
  std::function<ViewTracer(const BenchView&)> place;
};

using IsWanted = std::function<bool(const std::string& contender)>;

// Those of terrview that are wanted, ready to trace `dem`, which must outlive them; and one that
// only writes the frame, which none can beat.
[[nodiscard]] std::vector<Contender> terrview_contenders(const BenchDem& dem,
                                                         const IsWanted& is_wanted);

// Those of Embree; none where the build found no Embree. Only the geometries wanted are built.
[[nodiscard]] std::vector<Contender> embree_contenders(const BenchDem& dem,
                                                       const IsWanted& is_wanted);

// The default way of terrview over curved and bent ground.
inline constexpr const char* kDefaultWay = "terrview";
inline constexpr const char* kCurvedWay = "terrview-curved";
inline constexpr const char* kBentWay = "terrview-bent";

// Shadow rays of the default way take a map of the sun as given; these make it for the frame, or do
// without.
inline constexpr const char* kMapMadeWay = "terrview-sun-map-made";
inline constexpr const char* kNoMapWay = "terrview-no-sun-map";

// The thesis's rule, which may miss: render/neighbour_tracer.h.
inline constexpr const char* kNeighbourWay = "terrview-neighbours";

// "3.13.5", or empty.
[[nodiscard]] std::string embree_version();

}  // namespace terrview
