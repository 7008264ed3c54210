// The state of a few columns on their walk outward, lane by lane: what the vector loop of
// column_tracer.cpp carries, and what is done one lane at a time.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "terrain/column_tracer.h"
#include "terrain/grid_walk.h"
#include "terrain/track_piece.h"

namespace terrview {

inline constexpr int kMostLanes = 8;

// One number a lane; unused lanes hold harmless ones.
using Lanes = std::array<double, kMostLanes>;

struct alignas(64) ColumnState {
  // The cell, and the last crossing: distance, place and z of the ground.
  Lanes column, row, g, u, v, z;
  // The piece of the track.
  Lanes begin, end, start_u, start_v, rate_u, rate_v, metres_u, metres_v;
  // The ground line and the slope of the ray being traced.
  Lanes x, y, slope;
};

class ColumnWalk {
 public:
  // Lanes 0 ... count - 1 walk the columns first, first + 1, ... of `view`.
  ColumnWalk(const Terrain& terrain, const ColumnView& view, int first, int count,
             std::span<ColumnHit> hits);

  ColumnState state;

  // Bit i: lane i has rays left.
  [[nodiscard]] std::uint32_t active() const { return active_; }

  // The ray of `lane` meets the ground at `hit`: its next ray, upward, is to be traced.
  void record(int lane, const ColumnHit& hit);

  // The lane's track piece ends before the next crossing.
  void next_piece(int lane);

  // The lane comes over an edge of the ground: its rays below it end there.
  void drop_rays_below(int lane);

  // The lane has walked out of the grid.
  void leave_grid(int lane);

  // No ray of the lane meets anything more.
  void finish(int lane) { active_ &= ~(1U << lane); }

 private:
  void load_piece(int lane, const TrackPiece& piece);
  // Takes the lane to where its line next enters the grid; finishes it if it does not.
  void enter(int lane);
  void next_row(int lane);

  const Terrain& terrain_;
  const ColumnView& view_;
  std::span<ColumnHit> hits_;
  std::array<GroundLine, kMostLanes> lines_;
  std::array<double, kMostLanes> inverse_runs_;
  std::array<int, kMostLanes> rows_;
  std::array<TrackPiece, kMostLanes> pieces_;
  double to_m_;
  std::uint32_t active_ = 0;
};

}  // namespace terrview
