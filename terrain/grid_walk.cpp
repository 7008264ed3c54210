#include "terrain/grid_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace terrview {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double lerp_heights(float from_m, float to_m, double share) {
  const double from = from_m;
  return from + share * (to_m - from);
}

// Narrows [low, high] to where the piece's coordinate along `axis` lies within [0, last].
void clip(const TrackPiece& piece, int axis, double last, double& low, double& high) {
  const double start = piece.start[axis];
  if (piece.rate[axis] == 0) {
    if (start < 0 || start > last) high = -kNever;
    return;
  }
  const double at_first = piece.begin_m + (0 - start) * piece.metres[axis];
  const double at_last = piece.begin_m + (last - start) * piece.metres[axis];
  low = std::max(low, std::min(at_first, at_last));
  high = std::min(high, std::max(at_first, at_last));
}

double next_line(int cell, double rate) { return rate > 0 ? cell + 1.0 : cell; }

// Whether bands lie between columns; on the diagonals, within rounding, between rows.
bool goes_by_columns(const TrackPiece& piece) {
  constexpr double kDiagonal = 1 + 1e-9;
  return std::abs(piece.rate.x) > kDiagonal * std::abs(piece.rate.y);
}

}  // namespace

glm::ivec2 cell_of(const HeightGrid& grid, glm::dvec2 uv) {
  return {std::clamp(static_cast<int>(uv.x), 0, grid.columns - 2),
          std::clamp(static_cast<int>(uv.y), 0, grid.rows - 2)};
}

double height_at(const HeightGrid& grid, SurfaceModel model, glm::ivec2 cell, glm::dvec2 uv) {
  const glm::dvec2 f = glm::clamp(uv - glm::dvec2(cell), 0.0, 1.0);
  const double nw = grid.at(cell.x, cell.y);
  const double ne = grid.at(cell.x + 1, cell.y);
  const double sw = grid.at(cell.x, cell.y + 1);
  const double se = grid.at(cell.x + 1, cell.y + 1);
  if (model == SurfaceModel::triangles) {
    return f.x >= f.y ? nw + f.x * (ne - nw) + f.y * (se - ne)
                      : nw + f.y * (sw - nw) + f.x * (se - sw);
  }
  const double north = nw + f.x * (ne - nw);
  const double south = sw + f.x * (se - sw);
  return north + f.y * (south - north);
}

GridWalk::GridWalk(const HeightGrid& grid, const GroundMap& map, SurfaceModel model,
                   const GroundLine& line, double from_m, double to_m)
    : grid_(grid),
      map_(map),
      model_(model),
      ground_line_(line),
      to_m_(to_m),
      piece_(track_piece(map, line, from_m, map.to_grid(line.at(from_m)), to_m)) {
  last_.g_m = from_m;
}

bool GridWalk::next_piece() {
  const TrackPiece* next = piece_ahead(1);
  if (!next) return false;
  piece_ = *next;
  ++next_ahead_;
  return true;
}

const TrackPiece* GridWalk::piece_ahead(std::size_t count) {
  while (ahead_.size() - next_ahead_ < count) {
    const TrackPiece& last = ahead_.size() == next_ahead_ ? piece_ : ahead_.back();
    if (last.end_m >= to_m_) return nullptr;
    const TrackPiece next = track_piece(map_, ground_line_, last.end_m, last.end, to_m_);
    if (ahead_.size() == next_ahead_) {
      ahead_.clear();
      next_ahead_ = 0;
    }
    ahead_.push_back(next);
  }
  return count == 0 ? &piece_ : &ahead_[next_ahead_ + count - 1];
}

bool GridWalk::enter() {
  do {
    double low = std::max(piece_.begin_m, last_.g_m);
    double high = piece_.end_m;
    clip(piece_, 0, grid_.columns - 1, low, high);
    clip(piece_, 1, grid_.rows - 1, low, high);
    if (low <= high) {
      stand_at(low, piece_.at(low));
      return true;
    }
  } while (next_piece());
  return false;
}

void GridWalk::stand_at(double g_m, glm::dvec2 uv) {
  const glm::dvec2 last_post(grid_.columns - 1, grid_.rows - 1);
  uv = glm::clamp(uv, glm::dvec2(0), last_post);
  first_cell_ = cell_ = cell_of(grid_, uv);
  const glm::dvec2 f = uv - glm::dvec2(cell_);
  north_east_ = f.x >= f.y;
  has_ground_ = grid_.has_ground(cell_.x, cell_.y);
  inside_ = true;
  last_ = inside_point(g_m, uv);
}

double GridWalk::line_m(const TrackPiece& piece, int axis, double line) const {
  return std::max(last_.g_m, piece.begin_m + (line - piece.start[axis]) * piece.metres[axis]);
}

GridWalk::Event GridWalk::nearest_line() const {
  const glm::dvec2& rate = piece_.rate;
  Event event{kNever, Line::none};
  const auto consider = [&](double g_m, Line line) {
    if (g_m < event.g_m) event = {g_m, line};
  };
  if (rate.x != 0) consider(line_m(piece_, 0, next_line(cell_.x, rate.x)), Line::column);
  if (rate.y != 0) consider(line_m(piece_, 1, next_line(cell_.y, rate.y)), Line::row);
  if (model_ == SurfaceModel::triangles) {
    const double turn = rate.x - rate.y;
    if (north_east_ ? turn < 0 : turn > 0) {
      const double offset = (piece_.start.x - cell_.x) - (piece_.start.y - cell_.y);
      consider(std::max(last_.g_m, piece_.begin_m - offset * (1 / turn)), Line::diagonal);
    }
  }
  return event;
}

GridCrossing GridWalk::inside_point(double g_m, glm::dvec2 uv) const {
  const double height_m =
      has_ground_ ? height_at(grid_, model_, cell_, uv) : std::numeric_limits<double>::quiet_NaN();
  return {g_m, uv, height_m};
}

GridCrossing GridWalk::crossing(const Event& event) const {
  const glm::dvec2 uv = glm::clamp(piece_.at(event.g_m), glm::dvec2(cell_), glm::dvec2(cell_ + 1));
  if (event.line == Line::column) {
    const int column = piece_.rate.x > 0 ? cell_.x + 1 : cell_.x;
    return {event.g_m,
            {column, uv.y},
            lerp_heights(grid_.at(column, cell_.y), grid_.at(column, cell_.y + 1), uv.y - cell_.y)};
  }
  if (event.line == Line::row) {
    const int row = piece_.rate.y > 0 ? cell_.y + 1 : cell_.y;
    return {event.g_m,
            {uv.x, row},
            lerp_heights(grid_.at(cell_.x, row), grid_.at(cell_.x + 1, row), uv.x - cell_.x)};
  }
  const double f = uv.x - cell_.x;
  return {event.g_m,
          {uv.x, cell_.y + f},
          lerp_heights(grid_.at(cell_.x, cell_.y), grid_.at(cell_.x + 1, cell_.y + 1), f)};
}

glm::ivec2 GridWalk::cell_beyond(Line line) const {
  if (line == Line::column) return {cell_.x + (piece_.rate.x > 0 ? 1 : -1), cell_.y};
  return {cell_.x, cell_.y + (piece_.rate.y > 0 ? 1 : -1)};
}

bool GridWalk::is_inside(glm::ivec2 cell) const {
  return cell.x >= 0 && cell.y >= 0 && cell.x < grid_.columns - 1 && cell.y < grid_.rows - 1;
}

bool GridWalk::stops_at(Line line) const {
  if (model_ != SurfaceModel::band || goes_by_columns(piece_) == (line == Line::column))
    return true;
  const glm::ivec2 next = cell_beyond(line);
  return !is_inside(next) || grid_.has_ground(next.x, next.y) != has_ground_;
}

void GridWalk::cross(Line line) {
  if (line == Line::diagonal) {
    north_east_ = !north_east_;
    return;
  }
  const bool along_columns = line == Line::column;
  const bool forward = (along_columns ? piece_.rate.x : piece_.rate.y) > 0;
  first_cell_ = cell_ = cell_beyond(line);
  // A cell is entered through one of its edges, and each edge belongs to one triangle.
  north_east_ = along_columns ? !forward : forward;
  inside_ = is_inside(cell_);
  if (inside_) has_ground_ = grid_.has_ground(cell_.x, cell_.y);
}

void GridWalk::fill(Span& span, const GridCrossing& out) const {
  span.in = last_;
  span.out = out;
  span.cell = first_cell_;
  span.last_cell = cell_;
  span.has_ground = has_ground_;
  span.sag_m = 0;
  if (model_ == SurfaceModel::bilinear && has_ground_) {
    const double twist = static_cast<double>(grid_.at(cell_.x, cell_.y)) -
                         grid_.at(cell_.x + 1, cell_.y) - grid_.at(cell_.x, cell_.y + 1) +
                         grid_.at(cell_.x + 1, cell_.y + 1);
    span.sag_m = twist * (out.uv.x - last_.uv.x) * (out.uv.y - last_.uv.y);
  }
}

void GridWalk::stop_outside() {
  // A straight piece leaves a rectangle once: the next entry is on a later piece.
  if (!next_piece()) last_.g_m = kNever;
}

GridWalk::Block GridWalk::block_around(int level) const {
  const glm::ivec2 first((cell_.x >> level) << level, (cell_.y >> level) << level);
  const int side = 1 << level;
  return {first,
          {std::min(first.x + side, grid_.columns - 1) - 1,
           std::min(first.y + side, grid_.rows - 1) - 1}};
}

std::optional<GridWalk::BlockExit> GridWalk::exit_on(const TrackPiece& piece,
                                                     const Block& block) const {
  const auto leaves = [&](int axis) {
    const double rate = piece.rate[axis];
    return rate == 0 ? kNever
                     : line_m(piece, axis, rate > 0 ? block.last[axis] + 1 : block.first[axis]);
  };
  const double column_m = leaves(0);
  const double row_m = leaves(1);
  const double g_m = std::min(column_m, row_m);
  if (!(g_m <= piece.end_m)) return std::nullopt;
  return BlockExit{g_m, column_m <= row_m, 0, cell_};
}

std::optional<GridWalk::BlockExit> GridWalk::block_exit(int level) {
  const Block block = block_around(level);
  if (const auto exit = exit_on(piece_, block)) return exit;
  return exit_ahead(block);
}

std::optional<GridWalk::BlockExit> GridWalk::exit_ahead(const Block& block) {
  glm::ivec2 cell = cell_;
  for (std::size_t count = 1; const TrackPiece* next = piece_ahead(count); ++count) {
    const TrackPiece& done = *piece_ahead(count - 1);
    for (int axis = 0; axis < 2; ++axis) {
      cell[axis] = cell_reached(done, axis, cell[axis], block, {done.end_m, true});
      // A line that lies behind the knot by rounding would be crossed where the walk then stands,
      // which only the walk itself knows.
      const double rate = next->rate[axis];
      if (rate != 0 && line_m(*next, axis, next_line(cell[axis], rate)) < next->begin_m)
        return std::nullopt;
    }
    if (auto exit = exit_on(*next, block)) {
      // Where the span over the exit begins is not known.
      if (model_ == SurfaceModel::band && exit->over_column != goes_by_columns(*next))
        return std::nullopt;
      exit->pieces_ahead = count;
      exit->cell = cell;
      return exit;
    }
  }
  return std::nullopt;
}

int GridWalk::cell_reached(const TrackPiece& piece, int axis, int here, const Block& block,
                           const Limit& limit) const {
  const double rate = piece.rate[axis];
  if (rate == 0) return here;
  const int low = block.first[axis];
  const int high = block.last[axis];
  const auto is_crossed = [&](int line) {
    const double g_m = line_m(piece, axis, line);
    return limit.inclusive ? g_m <= limit.g_m : g_m < limit.g_m;
  };
  // Rounding may have put the point on the wrong side of a line.
  int cell = std::clamp(static_cast<int>(std::floor(piece.at(limit.g_m)[axis])), low, high);
  if (rate > 0) {
    cell = std::max(cell, here);
    while (cell < high && is_crossed(cell + 1)) ++cell;
    while (cell > here && !is_crossed(cell)) --cell;
  } else {
    cell = std::min(cell, here);
    while (cell > low && is_crossed(cell)) --cell;
    while (cell < here && !is_crossed(cell + 1)) ++cell;
  }
  return cell;
}

void GridWalk::skip(int level, const BlockExit& exit) {
  const Block block = block_around(level);
  if (exit.pieces_ahead > 0) {
    piece_ = *piece_ahead(exit.pieces_ahead);
    next_ahead_ += exit.pieces_ahead;
    cell_ = exit.cell;
  }
  // The block's last cell on the way, through whose edge the line leaves it. At a corner the walk
  // crosses columns first.
  const int along = exit.over_column ? 0 : 1;
  const int across = 1 - along;
  glm::ivec2 last;
  last[along] = piece_.rate[along] > 0 ? block.last[along] : block.first[along];
  last[across] = cell_reached(piece_, across, cell_[across], block, {exit.g_m, !exit.over_column});
  const Event event{exit.g_m, exit.over_column ? Line::column : Line::row};
  if (model_ == SurfaceModel::band && exit.over_column != goes_by_columns(piece_))
    begin_band(block, last);
  cell_ = last;
  if (!stops_at(event.line)) {
    cell_ = cell_beyond(event.line);
    return;
  }
  last_ = crossing(event);
  cross(event.line);
  if (!inside_) stop_outside();
}

void GridWalk::begin_band(const Block& block, glm::ivec2 last_cell) {
  const int axis = goes_by_columns(piece_) ? 0 : 1;
  if (last_cell[axis] == cell_[axis]) return;  // no line since the span began
  const int across = 1 - axis;
  const double rate = piece_.rate[axis];
  const int before = last_cell[axis] - (rate > 0 ? 1 : -1);
  const Event event{line_m(piece_, axis, next_line(before, rate)),
                    axis == 0 ? Line::column : Line::row};
  cell_[across] = cell_reached(piece_, across, cell_[across], block, {event.g_m, axis == 1});
  cell_[axis] = before;
  last_ = crossing(event);
  cross(event.line);
}

bool GridWalk::next(Span& span) {
  if (!inside_ && !enter()) return false;
  while (true) {
    const Event event = nearest_line();
    if (event.g_m <= piece_.end_m) {
      if (!stops_at(event.line)) {
        cell_ = cell_beyond(event.line);
        continue;
      }
      const GridCrossing out = crossing(event);
      fill(span, out);
      cross(event.line);
      last_ = out;
      if (!inside_) stop_outside();
      return true;
    }
    const bool finished = piece_.end_m >= to_m_;
    const bool breaks_here = finished || model_ == SurfaceModel::bilinear;
    if (breaks_here) {
      const GridCrossing knot = inside_point(
          piece_.end_m, glm::clamp(piece_.end, glm::dvec2(cell_), glm::dvec2(cell_ + 1)));
      fill(span, knot);
      last_ = knot;
    }
    if (finished) {
      inside_ = false;
      last_.g_m = kNever;
      return true;
    }
    if (!next_piece()) return false;
    if (breaks_here) return true;
  }
}

}  // namespace terrview
