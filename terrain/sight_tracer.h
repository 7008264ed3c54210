// Whether the ground stops lines of sight from the eye, many at a time.
//
// The rays are followed beyond their ends by the vectors of terrain/eye_tracer.h, where these serve
// the terrain: those that meet the ground before are stopped. One that meets the ground near its
// end, or may come below it over an edge, is left to the single ray's tracer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "terrain/eye_front.h"
#include "terrain/ray.h"
#include "terrain/terrain.h"

namespace terrview {

class SightTracer {
 public:
  // `terrain` must outlive it.
  explicit SightTracer(const Terrain& terrain);

  // stopped[i] = Terrain::occluded(rays[i]). All begin at the eye. Any thread may call.
  void trace(std::span<const Ray> rays, std::span<std::uint8_t> stopped) const;

 private:
  void trace_few(std::span<const Ray> rays, std::span<std::uint8_t> stopped) const;

  const Terrain& terrain_;
  bool may_come_below_;  // the ground, over an edge of it
  std::optional<EyeFront> front_;
  double doubt_m_ = 0;  // beside an end
};

}  // namespace terrview
