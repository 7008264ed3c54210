#pragma once

#include <functional>
#include <vector>

#include "terrain/sky_view.h"
#include "terrain/terrain.h"

namespace terrview {

struct SkyLightOptions {
  int azimuths = 32;
  int threads = 0;  // 0 = all; never changes the result
  // Called from any thread with the share done; what it throws ends the work.
  std::function<void(double share)> progress = {};
};

// The sky views of a terrain's layers, each as if it were alone.
[[nodiscard]] std::vector<SkyView> sky_views(const Terrain& terrain,
                                             const SkyLightOptions& options);

}  // namespace terrview
