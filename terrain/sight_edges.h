// The lines from the eye that part the wedges of a SightSweep, as they cross a grid.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "terrain/terrain.h"

namespace terrview {

// One of the four sides of the eye: its wedges run forward along u or v, and lie beside each other
// along the other axis. Posts ahead count from the eye, posts across from `base`.
struct SightSide {
  SightSide(const Terrain& terrain, int side);

  int axis;        // along which lines of the grid are crossed: 0 = u, 1 = v
  int forward;     // 1 or -1
  glm::dvec2 eye;  // grid coordinates
  int base;        // the row (column) at or before the eye's
  int lines;       // of the grid, along `axis`
  int rows;        // across

  [[nodiscard]] double ahead(int line) const { return forward * (line - eye[axis]); }
  // The first line ahead of the eye.
  [[nodiscard]] int first_line() const;
};

// A number of neighbouring edges. While a piece of an edge's track lasts, at `a` posts ahead it
// lies across + slope * a across, and metres + metres_per_post * a from the eye.
class SightEdges {
 public:
  // Edges `first` to `first` + `count` - 1 of those that part `wedges` wedges of a side, in the
  // order of rows; where they are `from_ahead` posts ahead of the eye.
  SightEdges(const Terrain& terrain, const SightSide& side, int wedges, int first, int count,
             double from_ahead);

  // Makes the numbers those of `to_ahead` posts, not before the last. False where an edge turns
  // away from the side: it can be followed no further.
  [[nodiscard]] bool advance(double to_ahead);

  [[nodiscard]] std::size_t count() const { return directions_.size(); }
  // With more elements, alike the last: vectors may begin at any edge and the one after.
  [[nodiscard]] std::size_t padded() const { return across.size(); }
  // Whether lines may cross more rows than lines of the side.
  [[nodiscard]] bool is_steep() const { return is_steep_; }

  // An edge strays no more posts than this from the straight line between a line of the grid and
  // the next, where a knot of its track lies between.
  static constexpr double kTurn = 0.004;

  static constexpr std::size_t kVector = 16;  // elements of the longest vector
  std::vector<float> across, slope, inverse_slope, metres, metres_per_post;
  std::vector<float> curvature;  // per metre, of the Earth towards the edge

 private:
  [[nodiscard]] bool load(std::size_t edge, double to_ahead);

  const GroundMap* map_;
  SightSide side_;
  std::vector<glm::dvec2> directions_;
  std::vector<double> piece_end_;  // posts ahead
  std::vector<double> piece_end_m_;
  double next_end_ = -1;  // the least piece end
  bool is_steep_ = false;
};

}  // namespace terrview
