// From the ground of the view frame to a grid.
//
// A GroundMap is the smooth map from view-frame (x, y), metres east and north of the eye, to grid
// (u, v), posts. The image of a straight ground line is a curve in the grid; piece_end_m() cuts it
// into linear pieces that stay within kTrackError_cells of the curve, and, on lines from the eye,
// within kTrackError_rad of it as the eye sees them. The terrain never moves: rays bend.
#pragma once

#include <span>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace terrview {

class EyeTracks;

// A straight line on the ground of the view frame: origin + direction * g, g in metres >= 0.
struct GroundLine {
  glm::dvec2 origin_m{0, 0};
  glm::dvec2 direction{0, 1};  // unit length

  [[nodiscard]] glm::dvec2 at(double g_m) const { return origin_m + direction * g_m; }
};

class GroundMap {
 public:
  static constexpr double kTrackError_cells = 0.02;
  // 0.08 pixel of a picture 1920 wide that spans 60 degrees. Nearer than a cell, a cell counts.
  static constexpr double kTrackError_rad = 5e-5;
  // Where no post is near, tracks may stray by this share of the way to the nearest instead.
  static constexpr double kDistantTrackError = 0.05;

  virtual ~GroundMap() = default;

  // The grid coordinates of a ground point. Defined everywhere within reach_m() of the eye.
  [[nodiscard]] virtual glm::dvec2 to_grid(glm::dvec2 ground_m) const = 0;

  // d(u, v) / d(x, y): column 0 is the derivative by x, column 1 by y.
  [[nodiscard]] virtual glm::dmat2 jacobian(glm::dvec2 ground_m) const = 0;

  // Those of many points, bit for bit, into arrays as long as theirs.
  struct GroundPoints {
    std::span<const double> x_m, y_m;
  };
  struct Places {
    std::span<double> u, v;
  };
  struct Jacobians {
    std::span<double> u_by_x, v_by_x, u_by_y, v_by_y;
  };
  virtual void places(const GroundPoints& points, const Places& found) const;
  virtual void jacobians(const GroundPoints& points, const Jacobians& found) const;

  // How far along `line` the linear piece that starts at `from_m` may reach, in (from_m, limit_m].
  // Deterministic: it depends on its arguments alone.
  [[nodiscard]] virtual double piece_end_m(const GroundLine& line, double from_m,
                                           double limit_m) const = 0;

  // Those of many lines, bit for bit.
  struct GroundLines {
    std::span<const double> x0_m, y0_m;  // where they begin
    std::span<const double> x, y;        // of unit length
  };
  struct Stretches {
    std::span<const double> from_m, limit_m;
  };
  virtual void piece_ends_m(const GroundLines& lines, const Stretches& stretches,
                            std::span<double> ends_m) const;

  // No post is nearer to the track of a part of a line than this, in posts, if the track is no more
  // than a tenth longer than its chord.
  [[nodiscard]] virtual double distance_from_grid(const GroundLine& /*line*/, double /*from_m*/,
                                                  double /*to_m*/) const {
    return 0;
  }

  // The jacobian, where it is the same everywhere and every line is one piece; else null.
  [[nodiscard]] virtual const glm::dmat2* linear() const { return nullptr; }

  // The tracks of lines from the eye, where a table of them was made; else null. Then these, and
  // not piece_end_m(), make the pieces of such lines.
  [[nodiscard]] virtual const EyeTracks* eye_tracks() const { return nullptr; }

  // A distance from the eye beyond which no post lies (or can be seen), and one for a direction.
  [[nodiscard]] virtual double reach_m() const = 0;
  [[nodiscard]] virtual double reach_m(glm::dvec2 /*direction*/) const { return reach_m(); }
};

// (u, v) = origin + jacobian * (x, y): every line is one piece.
class AffineGroundMap final : public GroundMap {
 public:
  // `grid_size` in posts bounds the reach. Throws InputError if `jacobian` is singular.
  AffineGroundMap(glm::dvec2 eye_uv, const glm::dmat2& jacobian, glm::ivec2 grid_size);

  [[nodiscard]] glm::dvec2 to_grid(glm::dvec2 ground_m) const override;
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 ground_m) const override;
  [[nodiscard]] double piece_end_m(const GroundLine& line, double from_m,
                                   double limit_m) const override;
  [[nodiscard]] const glm::dmat2* linear() const override { return &jacobian_; }
  [[nodiscard]] double reach_m() const override { return reach_m_; }

 private:
  glm::dvec2 eye_uv_;
  glm::dmat2 jacobian_;
  double reach_m_;
};

}  // namespace terrview
