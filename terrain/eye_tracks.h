// The tracks of all ground lines from the eye over a grid whose map bends them, as a table.
//
// Rings of knots around the eye, the same for every direction, cut the lines into linear pieces;
// between two neighbouring directions of the table the knots are interpolated linearly in the
// direction's x and y. So a piece is one product of a 2 x 2 matrix and the direction, wherever it
// lies: vectors of rays take theirs from the table too, and find the same bits.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "terrain/ground_map.h"
#include "terrain/track_piece.h"

namespace terrview {

class EyeTracks {
 public:
  // Knots and directions as close as `map`'s errors ask for: the table adds a tenth to them at
  // most, or its slack where no post is near. Nullopt where it would take too many, or `map` cannot
  // follow lines from the eye.
  [[nodiscard]] static std::optional<EyeTracks> make(const GroundMap& map);

  // The piece of the line from the eye along `direction` (unit length) that `from_m` lies on,
  // where two meet the one beyond, cut off at `to_m`.
  [[nodiscard]] TrackPiece piece(glm::dvec2 direction, double from_m, double to_m) const;

  // Where that line starts piece `piece` of the table, of the sector its direction lies in, and its
  // rate there.
  struct Start {
    glm::dvec2 uv;
    glm::dvec2 rate;
  };
  [[nodiscard]] Start start(int sector, int piece, glm::dvec2 direction) const;

  // Sectors are those of terrain/square_sectors.h.
  [[nodiscard]] int sectors_a_side() const { return sectors_a_side_; }
  [[nodiscard]] int pieces() const { return static_cast<int>(knots_m_.size()) - 1; }
  [[nodiscard]] const std::vector<double>& knots_m() const { return knots_m_; }
  // The piece that a distance lies on.
  [[nodiscard]] int piece_at(double from_m) const;
  [[nodiscard]] glm::dvec2 eye_uv() const { return eye_uv_; }

  // Of each piece, sector by sector: where it starts, from the eye, per unit of the direction's x
  // and y (u by x, u by y, v by x, v by y), and then its rate alike.
  static constexpr int kCoefficients = 8;
  [[nodiscard]] const std::vector<double>& coefficients() const { return coefficients_; }
  // The same as floats, but that pieces start at the eye: carried back to it; and the knots.
  [[nodiscard]] const std::vector<float>& lines() const { return lines_; }
  [[nodiscard]] const std::vector<float>& near_knots_m() const { return near_knots_m_; }
  // No track passes more posts a metre, along u or v.
  [[nodiscard]] double posts_per_m() const { return posts_per_m_; }

 private:
  EyeTracks(const GroundMap& map, int sectors_a_side);

  [[nodiscard]] bool find_knots(const GroundMap& map);
  void fill(const GroundMap& map);
  void carry_back();
  [[nodiscard]] bool is_close_to(const GroundMap& map) const;
  // No post is nearer to the tracks of a sector than this, in posts, along the pieces beside a
  // knot.
  [[nodiscard]] double distance_from_grid(const GroundMap& map, int sector, std::size_t knot) const;
  [[nodiscard]] std::vector<glm::dvec2> knots_along(const GroundMap& map,
                                                    glm::dvec2 direction) const;
  // The direction at a share of a sector.
  [[nodiscard]] glm::dvec2 edge(int sector, double share) const;

  int sectors_a_side_;
  glm::dvec2 eye_uv_;
  std::vector<double> knots_m_;
  std::vector<double> coefficients_;
  std::vector<float> lines_;
  std::vector<float> near_knots_m_;
  double posts_per_m_ = 0;
};

}  // namespace terrview
