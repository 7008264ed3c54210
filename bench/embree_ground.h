// A BenchDem as a scene of Embree 3.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include <embree3/rtcore.h>

#include "bench/bench_dem.h"

namespace terrview {

enum class EmbreeGeometry {
  triangles,          // two per cell, split from the north-west to the south-east post
  compact_triangles,  // the same, RTC_SCENE_FLAG_COMPACT
  grid,               // RTC_GEOMETRY_TYPE_GRID, with the same split
};

// Vertices lie in the scene frame. Immutable once made, so threads may share one.
class EmbreeGround {
 public:
  // Builds with `threads` threads. Throws std::runtime_error where Embree fails.
  EmbreeGround(const BenchDem& dem, EmbreeGeometry geometry, int threads);

  [[nodiscard]] RTCScene scene() const { return scene_.get(); }

  // rtcCommitScene alone: filling the buffers is not counted.
  [[nodiscard]] double build_s() const { return build_s_; }

  // Filling the buffers and rtcCommitScene.
  [[nodiscard]] double ready_s() const { return ready_s_; }

  // What Embree's memory monitor holds after the build: vertices, indices and the hierarchy.
  [[nodiscard]] double memory_mib() const;

  // Where a primitive of the grid geometry lies. Hits have u to the east and v to the north over a
  // whole primitive, so small primitives keep the cell exact.
  struct Tile {
    std::int32_t first_cell;  // the south-west one
    float cells_wide;
    float cells_high;
  };
  [[nodiscard]] const std::vector<Tile>& tiles() const { return tiles_; }  // empty: triangles
  [[nodiscard]] std::int32_t cells_in_row() const { return cells_in_row_; }

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };

  static bool count_bytes(void* ground, ssize_t bytes, bool after);
  void attach(const BenchDem& dem, EmbreeGeometry geometry);
  void check() const;

  std::atomic<std::int64_t> bytes_ = 0;  // before the device, which counts until it is released
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene_;
  std::vector<Tile> tiles_;
  std::int32_t cells_in_row_;
  double build_s_ = 0;
  double ready_s_ = 0;
};

}  // namespace terrview
