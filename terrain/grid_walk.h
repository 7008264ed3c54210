// The walk of a ray's ground line over one grid, crossing by crossing.
//
// Method: Coquillart 1984, chapter 2, 3.2: keep the next crossing with a column line and with a row
// line, take the nearer, step one cell. Crossings are computed in closed form from the start of the
// track's piece, never accumulated, and the cell is carried as integers: a crossing is shared by
// the two cells it parts, so no ray slips between them.
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "terrain/ground_map.h"
#include "terrain/height_grid.h"
#include "terrain/surface_model.h"
#include "terrain/track_piece.h"

namespace terrview {

// A point of the walk, on an edge of a cell or where the line begins or ends.
struct Crossing {
  double g_m;  // along the ground line
  glm::dvec2 uv;
  double height_m;  // of the grid's surface there; NaN beside a hole
};

// The part of a ground line between two consecutive crossings.
struct Span {
  Crossing in;
  Crossing out;
  glm::ivec2 cell;
  bool has_ground;  // false: a hole; the heights mean nothing
  double sag_m;     // the surface lies sag * t * (1 - t) below the chord at the share t of the span
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
  [[nodiscard]] const Crossing& position() const { return last_; }
  [[nodiscard]] const TrackPiece& piece() const { return piece_; }

  // Where the line leaves the block of 2^level x 2^level cells around cell().
  struct BlockExit {
    double g_m;
    bool over_column;  // through a column line; else through a row line
  };
  // nullopt if the track's piece ends before.
  [[nodiscard]] std::optional<BlockExit> block_exit(int level) const;

  // Goes on at the exit of the block, as if every cell of it had been walked.
  void skip(int level, const BlockExit& exit);

 private:
  enum class Line { none, column, row, diagonal };
  struct Event {
    double g_m;
    Line line;
  };

  [[nodiscard]] bool next_piece();
  [[nodiscard]] bool enter();
  void stand_at(double g_m, glm::dvec2 uv);
  // Where the piece crosses a line of columns (axis 0) or rows, not before the walk's position.
  [[nodiscard]] double line_m(int axis, double line) const;
  [[nodiscard]] Event nearest_line() const;
  // The cell along `axis`, in [low, high], that the walk has reached where it leaves a block.
  [[nodiscard]] int cell_at_exit(int axis, int low, int high, const BlockExit& exit) const;
  void cross(Line line);
  void stop_outside();
  [[nodiscard]] Crossing crossing(const Event& event) const;
  [[nodiscard]] Crossing inside_point(double g_m, glm::dvec2 uv) const;
  void fill(Span& span, const Crossing& out) const;

  const HeightGrid& grid_;
  const GroundMap& map_;
  SurfaceModel model_;
  GroundLine ground_line_;
  double to_m_;
  TrackPiece piece_;
  glm::ivec2 cell_{};
  bool inside_ = false;
  bool has_ground_ = false;
  bool north_east_ = false;  // which triangle of the cell
  Crossing last_{};
};

}  // namespace terrview
