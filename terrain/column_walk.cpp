#include "terrain/column_walk.h"

#include <cmath>
#include <cstddef>

#include "terrain/tracer.h"

namespace terrview {
namespace {

double z_of(const Terrain& terrain, const GroundLine& line, const GridCrossing& crossing) {
  const VerticalFrame& frame = terrain.frame();
  return frame.at(line.at(crossing.g_m)).z_m(frame.z_scale * crossing.height_m);
}

Ray ray_of(const ColumnView& view, int column, int row) {
  const glm::dvec2& across = view.across[static_cast<std::size_t>(column)];
  return {{0, 0, 0}, {across, view.rise[static_cast<std::size_t>(row)]}};
}

}  // namespace

ColumnWalk::ColumnWalk(const Terrain& terrain, const ColumnView& view, int first, int count,
                       std::span<ColumnHit> hits)
    : state{}, terrain_(terrain), view_(view), hits_(hits), to_m_(terrain.reach_m()) {
  const int last_row = static_cast<int>(view.rise.size()) - 1;
  for (int lane = 0; lane < count; ++lane) {
    const auto i = static_cast<std::size_t>(lane);
    active_ |= 1U << lane;
    const Ray ray = ray_of(view, first + lane, last_row);
    lines_[i] = ground_line(ray);
    inverse_runs_[i] = 1 / glm::length(glm::dvec2(ray.direction));
    state.x[i] = lines_[i].direction.x;
    state.y[i] = lines_[i].direction.y;
    rows_[i] = last_row + 1;
    next_row(lane);
    pieces_[i].end_m = 0;
    enter(lane);
  }
}

void ColumnWalk::next_row(int lane) {
  const auto i = static_cast<std::size_t>(lane);
  if (--rows_[i] < 0) {
    finish(lane);
    return;
  }
  state.slope[i] = view_.rise[static_cast<std::size_t>(rows_[i])] * inverse_runs_[i];
}

void ColumnWalk::record(int lane, const ColumnHit& hit) {
  const auto i = static_cast<std::size_t>(lane);
  hits_[i * view_.rise.size() + static_cast<std::size_t>(rows_[i])] = hit;
  next_row(lane);
}

void ColumnWalk::load_piece(int lane, const TrackPiece& piece) {
  const auto i = static_cast<std::size_t>(lane);
  pieces_[i] = piece;
  put_piece(state, i, piece);
}

void ColumnWalk::next_piece(int lane) {
  const auto i = static_cast<std::size_t>(lane);
  const TrackPiece& piece = pieces_[i];
  if (piece.end_m >= to_m_) {
    // The line ends inside a cell only where the grid does not.
    finish(lane);
    return;
  }
  load_piece(lane,
             track_piece(*terrain_.layers()[0].map, lines_[i], piece.end_m, piece.end, to_m_));
}

void ColumnWalk::leave_grid(int lane) {
  if (pieces_[static_cast<std::size_t>(lane)].end_m >= to_m_)
    finish(lane);
  else
    enter(lane);
}

void ColumnWalk::enter(int lane) {
  const auto i = static_cast<std::size_t>(lane);
  const TerrainLayer& layer = terrain_.layers()[0];
  GridWalk walk(*layer.grid, *layer.map, terrain_.model(), lines_[i], pieces_[i].end_m, to_m_);
  if (!walk.over_grid()) {
    finish(lane);
    return;
  }
  load_piece(lane, walk.piece());
  state.column[i] = walk.cell().x;
  state.row[i] = walk.cell().y;
  state.g[i] = walk.position().g_m;
  state.u[i] = walk.position().uv.x;
  state.v[i] = walk.position().uv.y;
  state.z[i] = z_of(terrain_, lines_[i], walk.position());
  drop_rays_below(lane);
}

void ColumnWalk::drop_rays_below(int lane) {
  const auto i = static_cast<std::size_t>(lane);
  while ((active_ >> lane & 1U) != 0 && state.slope[i] * state.g[i] - state.z[i] < 0)
    next_row(lane);
}

}  // namespace terrview
