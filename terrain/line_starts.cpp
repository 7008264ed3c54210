#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/line_starts.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "terrain/line_starts.h"
#include "terrain/sector_slopes-inl.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// The lines of one kind: those at whole numbers of one coordinate ("across"); along them the other
// one counts.
struct LineKind {
  using Values = WedgeEdges::Values WedgeEdges::Piece::*;
  Values start_across, rate_across, start_along, rate_along;
  double last_across, last_along;  // posts
  double step_across, step_along;  // from one post to the next
};

// One edge of each of several wedges: a piece of its track.
class EdgeTracks {
 public:
  EdgeTracks(const std::vector<double>& begins_m, const std::vector<WedgeEdges::Piece>& pieces,
             const LineKind& kind, const std::vector<double>& margins, std::size_t first)
      : begins_m_(begins_m), pieces_(pieces), kind_(kind), margins_(margins), first_(first) {
    for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane) set(lane, 0);
  }

  // How far off it may be: in metres, and in posts along the line.
  struct Crossing {
    V at_m, along;
    V off_m, off_posts;
    V rate_across;
    V begin_m;  // of the piece
    V margin;
  };

  // Where the tracks cross the lines at `line`, each further than those before.
  VEC_INLINE Crossing cross(V line) {
    V at_m = meet(line);
    for (std::uint32_t late = bits_of(at_m > values(end_m_)); late != 0;
         late = bits_of(at_m > values(end_m_))) {
      for (; late != 0; late &= late - 1) {
        const auto lane = static_cast<std::size_t>(__builtin_ctz(late));
        set(lane, piece_[lane] + 1);
      }
      at_m = meet(line);
    }
    const V along = values(start_along_) + values(rate_along_) * (at_m - values(begin_m_));
    return {
        at_m,           along, values(off_m_), values(off_posts_), rate_across(), values(begin_m_),
        values(margin_)};
  }

  VEC_INLINE V rate_across() const { return values(rate_across_); }
  VEC_INLINE V start_across() const { return values(start_across_); }

 private:
  using Lanes = std::array<double, kVectorLanes>;

  static VEC_INLINE V values(const Lanes& lanes) { return hn::Load(D(), lanes.data()); }

  VEC_INLINE V meet(V line) const {
    return values(begin_m_) + (line - values(start_across_)) * values(metres_across_);
  }

  void set(std::size_t lane, std::size_t piece) {
    piece_[lane] = piece;
    const auto value = [&](LineKind::Values which) {
      return (pieces_[piece].*which)[first_ + lane];
    };
    begin_m_[lane] = begins_m_[piece];
    end_m_[lane] = piece + 1 < begins_m_.size() ? begins_m_[piece + 1]
                                                : std::numeric_limits<double>::infinity();
    start_across_[lane] = value(kind_.start_across);
    rate_across_[lane] = value(kind_.rate_across);
    start_along_[lane] = value(kind_.start_along);
    rate_along_[lane] = value(kind_.rate_along);
    metres_across_[lane] = 1 / rate_across_[lane];
    margin_[lane] = margins_[piece];
    off_m_[lane] = margin_[lane] * std::abs(metres_across_[lane]);
    off_posts_[lane] = margin_[lane] + off_m_[lane] * std::abs(rate_along_[lane]);
  }

  const std::vector<double>& begins_m_;
  const std::vector<WedgeEdges::Piece>& pieces_;
  const LineKind& kind_;
  const std::vector<double>& margins_;
  std::size_t first_;
  std::array<std::size_t, kVectorLanes> piece_{};
  alignas(64) Lanes begin_m_{}, end_m_{}, start_across_{}, rate_across_{}, start_along_{},
      rate_along_{}, metres_across_{}, margin_{}, off_m_{}, off_posts_{};
};

// A table of starts, by wedges from the first lane's on.
class StartTable {
 public:
  StartTable(float* starts_m, int first_bin, int last_bin)
      : starts_m_(starts_m), first_bin_(first_bin), last_bin_(last_bin) {}

  // Some lanes meet ground that is seen no more steeply than `bound`.
  VEC_INLINE void meet(V near_m, V bound, std::uint32_t lanes) const {
    if (lanes == 0) return;
    const hn::Rebind<float, D> floats;
    const hn::Rebind<std::int32_t, D> ints;
    const V q = bound / (of(EyeFront::kHalfwaySlope) + hn::Abs(bound)) + of(1);
    const V last = of(last_bin_);
    const V bin = hn::IfThenElse(bound < hn::Inf(D()),
                                 q * of(EyeFront::kStartBins / 2) + of(EyeFront::kBinMargin), last);
    alignas(64) std::array<float, kVectorLanes> starts_m;
    alignas(64) std::array<std::int32_t, kVectorLanes> bins;
    hn::Store(hn::DemoteTo(floats, near_m), floats, starts_m.data());
    hn::Store(hn::DemoteTo(ints, hn::Max(hn::Min(bin, last), of(first_bin_))), ints, bins.data());
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(lanes));
      float& start_m =
          starts_m_[lane * EyeFront::kStartBins + static_cast<std::size_t>(bins[lane])];
      start_m = std::min(start_m, starts_m[lane]);
    }
  }

 private:
  float* starts_m_;
  int first_bin_;
  int last_bin_;
};

class LineMeeter {
 public:
  LineMeeter(const Terrain& terrain, const WedgeEdges& edges, const LineStartsOptions& options)
      : slopes_(terrain.frame(), edges),
        posts_(*terrain.layers()[0].grid),
        edges_(edges),
        is_straight_(terrain.layers()[0].map->linear() != nullptr),
        margins_(options.margins_cells),
        knot_margin_(options.knot_margin_cells),
        furthest_m_(options.furthest_m),
        highest_slope_(options.highest_slope) {}

  // Of wedges `first`, ...; returns up to where the lines are known.
  VEC_INLINE V run(const LineKind& kind, std::size_t first, const StartTable& table) const {
    EdgeTracks a(edges_.begins_m, edges_.pieces_a, kind, margins_, first);
    EdgeTracks b(edges_.begins_m, edges_.pieces_b, kind, margins_, first);
    const M forward = a.rate_across() > of(0);
    const V step = hn::IfThenElse(forward, of(1), of(-1));
    V line = first_line(a, kind, forward);
    V highest = of(-kInfinity);  // of parts than which none that follows is nearer
    V end_m = of(0);
    Parts before{of(0), of(0), of(-kInfinity)};
    M going = a.rate_across() * b.rate_across() > of(0);
    while (true) {
      const M inside = hn::And(line >= of(0), line <= of(kind.last_across));
      // Bent tracks may come back.
      const V left_m = is_straight_ ? of(kInfinity) : before.near_m;
      end_m = hn::IfThenElse(hn::AndNot(inside, going), left_m, end_m);
      going = hn::And(going, inside);
      if (hn::AllFalse(D(), going)) return end_m;
      const Stretch stretch = stretch_of(kind, a.cross(line), b.cross(line));
      const M onward =
          hn::And(hn::And(a.rate_across() * step > of(0), b.rate_across() * step > of(0)),
                  stretch.near_m >= before.near_m);
      // Places in floats are known well enough there.
      const M is_near =
          hn::And(stretch.near_m < of(furthest_m_), stretch.far_m < of(4 * furthest_m_));
      const M known = hn::And(hn::And(onward, stretch.is_short), is_near);
      const M lost = hn::AndNot(known, going);
      end_m = hn::IfThenElse(lost, hn::IfThenElse(onward, stretch.near_m, before.near_m), end_m);
      going = hn::AndNot(lost, going);
      highest = hn::IfThenElse(stretch.near_m >= before.last_near_m, hn::Max(highest, before.bound),
                               highest);
      before = meet_parts(kind, first, {line, going, highest}, stretch, table);
      const M closed = hn::And(going, highest > of(highest_slope_));
      end_m = hn::IfThenElse(closed, of(kInfinity), end_m);
      going = hn::AndNot(closed, going);
      line = line + step;
    }
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kMostParts = 8;
  // Further than this, ground below the eye has a slope.
  static constexpr double kLeast_m = 1e-9;
  using Crossing = EdgeTracks::Crossing;

  // Where they stand, or where they come to the grid.
  VEC_INLINE V first_line(const EdgeTracks& a, const LineKind& kind, M forward) const {
    const V at = a.start_across();
    const V up = hn::Max(hn::Ceil(at - of(margins_.front())), of(0));
    const V down = hn::Min(hn::Floor(at + of(margins_.front())), of(kind.last_across));
    return hn::IfThenElse(forward, up, down);
  }

  // What wedges have of a line: from post `from` to post `to`, counted along it, and that over the
  // grid.
  struct Stretch {
    V near_m, far_m;
    V from, to;
    V first_cell, last_cell;
    // At the place `along` it is `at_m` away, and so many metres more a post, where that tells.
    V along, at_m, metres;
    V off_m, off_posts;
    M is_over, is_short, tells;
  };

  VEC_INLINE Stretch stretch_of(const LineKind& kind, const Crossing& a, const Crossing& b) const {
    Stretch s;
    // With a knot between them what lies between the edges bends there.
    const M on_one_piece = a.begin_m == b.begin_m;
    const V widened = hn::Max(of(knot_margin_) / hn::Min(a.margin, b.margin), of(1));
    const V times = hn::IfThenElse(on_one_piece, of(1), widened);
    s.off_m = times * hn::Max(a.off_m, b.off_m);
    s.off_posts = times * hn::Max(a.off_posts, b.off_posts);
    s.near_m = nearest(hn::Min(a.at_m, b.at_m) - s.off_m);
    s.far_m = hn::Max(hn::Max(a.at_m, b.at_m) + s.off_m, of(kLeast_m));
    const V low = hn::Min(a.along, b.along) - s.off_posts;
    const V high = hn::Max(a.along, b.along) + s.off_posts;
    s.is_over = hn::And(high >= of(0), low <= of(kind.last_along));
    s.from = hn::Min(hn::Max(low, of(0)), of(kind.last_along));
    s.to = hn::Min(hn::Max(high, of(0)), of(kind.last_along));
    s.first_cell = hn::Min(hn::Floor(s.from), of(kind.last_along - 1));
    s.last_cell = hn::Min(hn::Floor(s.to), of(kind.last_along - 1));
    s.is_short = s.last_cell - s.first_cell < of(kMostParts);
    const V width = b.along - a.along;
    s.tells = hn::And(hn::Abs(width) > of(4) * s.off_posts, on_one_piece);
    s.metres = (b.at_m - a.at_m) / width;
    s.along = a.along;
    s.at_m = a.at_m;
    return s;
  }

  // The nearest and the furthest that wedges have a line between two places.
  struct Distances {
    V near_m, far_m;
  };
  VEC_INLINE Distances between(const Stretch& s, V from, V to) const {
    const V a_m = s.at_m + (from - s.off_posts - s.along) * s.metres;
    const V b_m = s.at_m + (to + s.off_posts - s.along) * s.metres;
    const V near_m = hn::Max(nearest(hn::Min(a_m, b_m) - s.off_m), s.near_m);
    const V far_m = hn::Min(hn::Max(a_m, b_m) + s.off_m, s.far_m);
    return {hn::IfThenElse(s.tells, near_m, s.near_m), hn::IfThenElse(s.tells, far_m, s.far_m)};
  }

  // A line that some lanes want, and what they need not be told of: parts seen less steeply.
  struct Line {
    V at;
    M wanted;
    V highest;
  };
  // Of the parts of a line: the nearest, the one that begins furthest away, and how steeply they
  // are seen.
  struct Parts {
    V near_m, last_near_m, bound;
  };

  VEC_INLINE Parts meet_parts(const LineKind& kind, std::size_t first, const Line& line,
                              const Stretch& s, const StartTable& table) const {
    const V none = of(-kInfinity);
    const auto post = [&](V along) HWY_ATTR {
      const V index = line.at * of(kind.step_across) +
                      hn::Min(along, of(kind.last_along)) * of(kind.step_along);
      return posts_.at(hn::IfThenElseZero(line.wanted, index));
    };
    Parts parts{s.near_m, s.near_m, none};
    V cell = s.first_cell;
    V height = post(cell);
    M left = hn::And(line.wanted, s.is_over);
    while (!hn::AllFalse(D(), left)) {
      const V next = post(cell + of(1));
      const V from = hn::Max(s.from, cell);
      const V to = hn::Min(s.to, cell + of(1));
      const V climb = next - height;
      const V top = hn::Max(height + (from - cell) * climb, height + (to - cell) * climb);
      const auto [near_m, far_m] = between(s, from, to);
      // Edges that end in a hole are no ground.
      const V bound =
          slopes_.highest(first, near_m, far_m, hn::IfThenElse(climb == climb, top, none));
      table.meet(near_m, bound, bits_of(hn::And(left, bound > line.highest)));
      parts.bound = hn::IfThenElse(left, hn::Max(parts.bound, bound), parts.bound);
      parts.last_near_m =
          hn::IfThenElse(left, hn::Max(parts.last_near_m, near_m), parts.last_near_m);
      cell = cell + of(1);
      height = next;
      left = hn::And(left, cell <= s.last_cell);
    }
    return parts;
  }

  // What is no nearer on a chord is no nearer than this on the arc.
  VEC_INLINE V nearest(V at_m) const { return hn::Max(at_m * of(1 / edges_.bulge), of(0)); }

  SectorSlopes slopes_;
  VectorPosts posts_;
  const WedgeEdges& edges_;
  bool is_straight_;
  const std::vector<double>& margins_;
  double knot_margin_;
  double furthest_m_;
  double highest_slope_;
};

WedgeDistances meet_all_lines(const Terrain& terrain, const WedgeEdges& edges,
                              const LineStartsOptions& options, float* starts_m) {
  using Piece = WedgeEdges::Piece;
  const HeightGrid& grid = *terrain.layers()[0].grid;
  const double columns = grid.columns;
  const double rows = grid.rows;
  const LineKind across_u{
      &Piece::start_u, &Piece::rate_u, &Piece::start_v, &Piece::rate_v, columns - 1, rows - 1, 1,
      columns};
  const LineKind across_v{&Piece::start_v, &Piece::rate_v, &Piece::start_u, &Piece::rate_u,
                          rows - 1,        columns - 1,    columns,         1};
  const LineMeeter meeter(terrain, edges, options);
  WedgeDistances known_m;
  for (std::size_t first = 0; first < EyeFront::kGroup; first += hn::Lanes(D())) {
    const StartTable table(starts_m + first * EyeFront::kStartBins, options.first_bin,
                           options.last_bin);
    const V u_m = meeter.run(across_u, first, table);
    const V v_m = meeter.run(across_v, first, table);
    const hn::Rebind<float, D> floats;
    hn::StoreU(hn::DemoteTo(floats, hn::Min(u_m, v_m)), floats, known_m.data() + first);
  }
  return known_m;
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(meet_all_lines);

WedgeDistances meet_lines(const Terrain& terrain, const WedgeEdges& edges,
                          const LineStartsOptions& options, float* starts_m) {
  return HWY_DYNAMIC_DISPATCH(meet_all_lines)(terrain, edges, options, starts_m);
}

}  // namespace terrview
#endif
