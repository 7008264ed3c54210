// The walk of a ray's ground line over one grid, crossing by crossing.
//
// Method: Coquillart 1984, chapter 2, 3.2: keep the next crossing with a column line and with a row
// line, take the nearer, step one cell. Crossings are computed in closed form from the start of the
// track's piece, never accumulated, and the cell is carried as integers: a crossing is shared by
// the two cells it parts, so no ray slips between them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "terrain/ground_map.h"
#include "terrain/height_grid.h"
#include "terrain/surface_model.h"
#include "terrain/track_piece.h"

namespace terrview {

// A point of the walk, on an edge of a cell or where the line begins or ends.
struct GridCrossing {
  double g_m;  // along the ground line
  glm::dvec2 uv;
  double height_m;  // of the grid's surface there; NaN beside a hole
};

// The part of a ground line between two consecutive crossings.
struct Span {
  GridCrossing in;
  GridCrossing out;
  glm::ivec2 cell;       // where it begins
  glm::ivec2 last_cell;  // where it ends: another in a band alone
  bool has_ground;       // false: a hole; the heights mean nothing
  double sag_m;  // the surface lies sag * t * (1 - t) below the chord at the share t of the span
};

// The height of the surface inside a cell that has ground, where no ray's plane is given:
// bilinear, or the triangle's plane.
[[nodiscard]] double height_at(const HeightGrid& grid, SurfaceModel model, glm::ivec2 cell,
                               glm::dvec2 uv);

// The cell of a point of the grid; points on the last lines belong to the last cells.
[[nodiscard]] glm::ivec2 cell_of(const HeightGrid& grid, glm::dvec2 uv);

class GridWalk {
 public:
  // Walks from `from_m` to `to_m` along `line`. All references must outlive the walk.
  GridWalk(const HeightGrid& grid, const GroundMap& map, SurfaceModel model, const GroundLine& line,
           double from_m, double to_m);

  // The next span over the grid; false when the line has left it for good. Spans follow each other
  // without a gap while the line is over the grid; a bent line may leave and come back.
  [[nodiscard]] bool next(Span& span);

  // Skipping. Where the walk stands, once it is over the grid (enters it if need be); false when
  // the line has left the grid for good.
  [[nodiscard]] bool over_grid() { return inside_ || enter(); }
  [[nodiscard]] glm::ivec2 cell() const { return cell_; }
  [[nodiscard]] double position_m() const { return last_.g_m; }
  [[nodiscard]] const GridCrossing& position() const { return last_; }
  [[nodiscard]] const TrackPiece& piece() const { return piece_; }

  // Where the line leaves the block of 2^level x 2^level cells around cell().
  struct BlockExit {
    double g_m;
    bool over_column;          // through a column line; else through a row line
    std::size_t pieces_ahead;  // on which piece of the track, counted from piece()
    glm::ivec2 cell;           // where that piece begins
  };
  // nullopt if the line ends before, or where rounding at a knot leaves the exit in doubt.
  [[nodiscard]] std::optional<BlockExit> block_exit(int level);

  // Goes on at the exit of the block, as if every cell of it had been walked.
  void skip(int level, const BlockExit& exit);

 private:
  enum class Line { none, column, row, diagonal };
  struct Event {
    double g_m;
    Line line;
  };

  struct Block {
    glm::ivec2 first;  // cells
    glm::ivec2 last;
  };
  [[nodiscard]] Block block_around(int level) const;

  [[nodiscard]] bool next_piece();
  // nullptr: the line ends before.
  [[nodiscard]] const TrackPiece* piece_ahead(std::size_t count);
  [[nodiscard]] bool enter();
  void stand_at(double g_m, glm::dvec2 uv);
  // Where a piece crosses a line of columns (axis 0) or rows, not before the walk's position.
  [[nodiscard]] double line_m(const TrackPiece& piece, int axis, double line) const;
  [[nodiscard]] Event nearest_line() const;
  // As block_exit(), on one piece.
  [[nodiscard]] std::optional<BlockExit> exit_on(const TrackPiece& piece, const Block& block) const;
  [[nodiscard]] std::optional<BlockExit> exit_ahead(const Block& block);
  // The cell along `axis`, in the block, to which the lines crossed before `g_m` (or at it, if
  // `inclusive`) take the walk from the cell `here`.
  struct Limit {
    double g_m;
    bool inclusive;
  };
  [[nodiscard]] int cell_reached(const TrackPiece& piece, int axis, int here, const Block& block,
                                 const Limit& limit) const;
  // The cell on the other side of a line.
  [[nodiscard]] glm::ivec2 cell_beyond(Line line) const;
  [[nodiscard]] bool is_inside(glm::ivec2 cell) const;
  // Whether the span that lies behind ends at a line of the current cell: not where it goes on
  // along its band.
  [[nodiscard]] bool stops_at(Line line) const;
  // Begins the span that goes over the end of a block at the last line before `last_cell` of it.
  void begin_band(const Block& block, glm::ivec2 last_cell);
  void cross(Line line);
  void stop_outside();
  [[nodiscard]] GridCrossing crossing(const Event& event) const;
  [[nodiscard]] GridCrossing inside_point(double g_m, glm::dvec2 uv) const;
  void fill(Span& span, const GridCrossing& out) const;

  const HeightGrid& grid_;
  const GroundMap& map_;
  SurfaceModel model_;
  GroundLine ground_line_;
  double to_m_;
  TrackPiece piece_;
  std::vector<TrackPiece> ahead_;  // pieces already cut; those before next_ahead_ are done with
  std::size_t next_ahead_ = 0;
  glm::ivec2 cell_{};
  glm::ivec2 first_cell_{};  // in which the next span begins
  bool inside_ = false;
  bool has_ground_ = false;
  bool north_east_ = false;  // which triangle of the cell
  GridCrossing last_{};
};

}  // namespace terrview
