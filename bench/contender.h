// A way of tracing a view, as the benchmark sees it.
//
// To add one: make a Contender whose functions trace the rays of a BenchView (a TracedFrame row by
// row, with the camera's rays) and append it in terrview_contenders().
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_dem.h"
#include "bench/bench_view.h"
#include "bench/traced_frame.h"
#include "terrain/terrain.h"

namespace terrview {

// The work of a frame, summed over its rays; what a contender does not count stays empty.
struct FrameWork {
  std::optional<std::int64_t> tests;
  std::optional<std::int64_t> nodes;
};

// A view, and its ground under every surface model that is asked for.
struct BenchScene {
  const BenchDem& dem;
  const BenchView& view;
  std::map<SurfaceModel, Terrain> terrains;
};

struct Contender {
  std::string name;
  std::optional<SurfaceModel> surface;  // none: it traces nothing
  std::optional<double> build_s;        // once per DEM, with all threads
  std::optional<double> memory_mib;     // beyond the heights
  std::function<FrameWork(const BenchScene&, int threads, TracedFrame&)> primary;
  std::function<FrameWork(const BenchScene&, const ShadowRays&, int threads, ShadowFrame&)> shadow;
};

// Those of terrview, ready to trace `dem`, which must outlive them; and the time to write a frame.
[[nodiscard]] std::vector<Contender> terrview_contenders(const BenchDem& dem);

// Those of Embree; none where the build found no Embree.
[[nodiscard]] std::vector<Contender> embree_contenders(const BenchDem& dem);

// "3.13.5", or empty.
[[nodiscard]] std::string embree_version();

}  // namespace terrview
