#include "bench/front_rays.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <glm/common.hpp>

#include "render/parallel.h"
#include "render/pixel_lattice.h"
#include "terrain/eye_tracer.h"

namespace terrview {

namespace {

// Pixels of a frame side by side.
EyeFacets pixels_from(TracedFrame& frame, std::size_t first, std::size_t count) {
  const auto some = [&](auto& plane) { return std::span(plane).subspan(first, count); };
  return {some(frame.distance_m), some(frame.cell), some(frame.normal_east),
          some(frame.normal_north)};
}

// Part of a picture; one that is level goes upwards, row by row, and rows that follow others are as
// wide as a batch.
class PartTracer {
 public:
  PartTracer(const EyeFront& front, const Camera& camera, TracedFrame& frame)
      : front_(front), camera_(camera), frame_(frame) {}

  void trace_block(glm::ivec2 first_px, glm::ivec2 size_px) {
    for (int row = 0; row < size_px.y; ++row)
      aim({first_px.x, first_px.y + row}, size_px.x, static_cast<std::size_t>(row * size_px.x));
    rays_.count = static_cast<std::size_t>(size_px.x * size_px.y);
    trace(front_, rays_, counts_);
    for (int row = 0; row < size_px.y; ++row)
      facets(front_.terrain(), rays_, static_cast<std::size_t>(row * size_px.x),
             pixels_from(frame_, frame_.index(first_px.x, first_px.y + row),
                         static_cast<std::size_t>(size_px.x)));
  }

  void trace_upwards(glm::ivec2 first_px, glm::ivec2 size_px) {
    rays_.begin_to_follow();
    for (int row = size_px.y; row-- > 0;)
      trace_block({first_px.x, first_px.y + row}, {size_px.x, 1});
  }

  [[nodiscard]] const TraceCounts& counts() const { return counts_; }

 private:
  void aim(glm::ivec2 first_px, int columns, std::size_t i) {
    const auto width = static_cast<std::size_t>(columns);
    camera_.aim_row(glm::dvec2(first_px) + 0.5, {std::span(rays_.direction_x).subspan(i, width),
                                                 std::span(rays_.direction_y).subspan(i, width),
                                                 std::span(rays_.direction_z).subspan(i, width)});
  }

  const EyeFront& front_;
  const Camera& camera_;
  TracedFrame& frame_;
  EyeRays rays_;
  TraceCounts counts_;
};

}  // namespace

FrameWork trace_front(const EyeFront& front, const Camera& camera, int threads,
                      TracedFrame& frame) {
  constexpr int kMost = static_cast<int>(EyeRays::kMost);
  constexpr int kTileWide_px = 64;
  constexpr int kLevelHigh_px = 270;
  const bool is_level = column_view(camera).has_value();
  const glm::ivec2 tile_px = is_level ? glm::ivec2(kMost, kLevelHigh_px)
                                      : glm::ivec2(frame.size_px.x, kMost / kTileWide_px);
  const glm::ivec2 tiles = (frame.size_px + tile_px - 1) / tile_px;
  std::atomic<std::int64_t> tests = 0;
  std::atomic<std::int64_t> nodes = 0;
  parallel_for(tiles.x * tiles.y, threads, [&](int tile) {
    const auto part = std::make_unique<PartTracer>(front, camera, frame);
    const glm::ivec2 first_px = glm::ivec2(tile % tiles.x, tile / tiles.x) * tile_px;
    const glm::ivec2 size_px = glm::min(tile_px, frame.size_px - first_px);
    if (is_level) {
      part->trace_upwards(first_px, size_px);
    } else {
      for (int left = 0; left < size_px.x; left += kTileWide_px)
        part->trace_block({left, first_px.y},
                          {std::min(kTileWide_px, size_px.x - left), size_px.y});
    }
    tests += part->counts().tests;
    nodes += part->counts().nodes;
  });
  return {.tests = tests, .nodes = nodes};
}

}  // namespace terrview
