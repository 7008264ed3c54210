// The conservative front of a view: how far from the eye each ray is certainly above the ground.
//
// The ground around the eye is cut into wedges of azimuth and into rings of distance. The sector
// where a wedge meets a ring has a bound: the slope z / s, seen from the eye, that no ground in it
// exceeds. A ray steeper than the bound is above the ground all through the sector; it need only be
// compared with the cells of sectors whose bound reaches it. Neighbouring pixels share wedges, so
// what is found once serves them all: vertical coherence (Coquillart 1984, chapter 2, 4) for any
// camera, and for any set of rays from the eye.
//
// Where cells are wider than wedges, rays begin later than sectors tell: at the first line of the
// grid that they may be below (terrain/line_starts.h).
//
// Rings are a few cells wide and wedges about a pixel or a few, so that 2 x 2 blocks of one level
// of HeightCeilings cover a sector. Bounds are floats, rounded up; sectors are widened by more than
// the rounding of a ray's track.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "terrain/height_ceilings.h"
#include "terrain/terrain.h"

namespace terrview {

struct EyeFrontOptions {
  double wedge_rad = 0.002;  // wedges are this wide at most
  // What the slopes of most rays lie between, the lowest no higher than the highest. Others are
  // traced as exactly, but not as fast.
  double lowest_slope = -std::numeric_limits<double>::infinity();
  double highest_slope = std::numeric_limits<double>::infinity();
  // Whether starts are made of lines, too: of use where rays neither follow others nor look so
  // steeply down that they meet the ground in their first cell.
  bool looks_at_lines = true;
};

struct WedgeEdges;

class EyeFront {
 public:
  static constexpr int kGroupBits = 4;
  static constexpr int kGroup = 1 << kGroupBits;  // wedges made at a time
  static constexpr int kStrideBits = 3;
  static constexpr int kStride = 1 << kStrideBits;  // rings a step of the coarse search
  // Of slopes, by slope / (kHalfwaySlope + |slope|) from -1 to 1.
  static constexpr int kStartBinBits = 11;
  static constexpr int kStartBins = 1 << kStartBinBits;
  static constexpr double kHalfwaySlope = 0.25;
  // Above the rounding with which a ray finds its bin in floats, in bins.
  static constexpr double kBinMargin = 1e-3;

  // Whether a front can be made: within_vector_limits(), heights upwards, with ceilings, under an
  // affine map or one with EyeTracks.
  [[nodiscard]] static bool serves(const Terrain& terrain);

  // `terrain` must outlive it.
  EyeFront(const Terrain& terrain, const EyeFrontOptions& options);

  // Makes the bounds of the wedges of `group`, if nobody has. Any thread may call.
  void make(int group) const;

  [[nodiscard]] const Terrain& terrain() const { return terrain_; }

  // Wedges are the sectors of terrain/square_sectors.h.
  [[nodiscard]] int wedges_a_side() const { return wedges_a_side_; }

  // Ring i lies between ring_m()[i] and ring_m()[i + 1]; the first begins at the eye.
  [[nodiscard]] std::span<const double> ring_m() const { return ring_m_; }
  // The same as floats.
  [[nodiscard]] std::span<const float> near_m() const { return near_m_; }
  [[nodiscard]] int rings() const { return static_cast<int>(levels_.size()); }
  // A few cells.
  [[nodiscard]] double step_back_m() const { return 4 * step_m_; }
  // How much nearer a sector begins than its ring.
  [[nodiscard]] double margin_m() const { return margin_m_; }

  // The bound of a ring in a wedge is at (group * (rings + 1) + ring) * kGroup + wedge % kGroup.
  // That of the ring past the last is infinite.
  [[nodiscard]] const float* bounds() const { return bounds_.get(); }
  // The highest bound of the kStride rings from kStride i on, laid out alike by i.
  [[nodiscard]] const float* coarse_bounds() const { return coarse_bounds_.get(); }
  // The highest bound of all rings from kStride i on, laid out alike; the ring past the last not
  // counted.
  [[nodiscard]] const float* bounds_beyond() const { return bounds_beyond_.get(); }
  [[nodiscard]] int coarse_rings() const { return rings() / kStride + 1; }
  // Where rays of a bin of slopes may begin: above the ground wherever they cross a line of the
  // grid nearer than that, so that they meet it in the cell they are in there or beyond. At wedge *
  // kStartBins + bin, for bins from first_bin() to last_bin(), which stand for all below and above
  // them. Infinity where they meet none.
  [[nodiscard]] const float* starts_m() const { return starts_m_.get(); }
  [[nodiscard]] int first_bin() const { return first_bin_; }
  [[nodiscard]] int last_bin() const { return last_bin_; }

  // The ring in which step_m() * i lies, by i. No ring is narrower than a step.
  [[nodiscard]] std::span<const std::int32_t> ring_at_step() const { return ring_at_step_; }
  [[nodiscard]] double step_m() const { return step_m_; }

 private:
  void lay_rings(double wedge_rad);
  void index_rings();
  void make_coarse_bounds(int group) const;
  void make_starts(int group, const WedgeEdges& edges) const;
  // That in which a distance lies, or the one before; beyond the last, rings().
  [[nodiscard]] std::size_t ring_before(float distance_m) const;

  const Terrain& terrain_;
  const HeightCeilings& ceilings_;
  int wedges_a_side_;
  double margin_cells_;
  double margin_m_ = 0;
  std::vector<double> ring_m_;
  std::vector<float> near_m_;
  std::vector<int> levels_;  // by ring: of the blocks that cover its sectors
  std::vector<std::int32_t> ring_at_step_;
  double step_m_ = 0;  // the narrowest ring
  double furthest_line_m_ = 0;
  bool looks_at_lines_;
  float highest_slope_;
  int first_bin_;
  int last_bin_;
  // Of every wedge around the eye, but only pages of those that are made are ever touched.
  std::unique_ptr<float[]> bounds_;
  std::unique_ptr<float[]> coarse_bounds_;
  std::unique_ptr<float[]> bounds_beyond_;
  std::unique_ptr<float[]> starts_m_;
  std::unique_ptr<std::once_flag[]> made_;
};

}  // namespace terrview
