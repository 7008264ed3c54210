#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/eye_front.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

#include "terrain/eye_front.h"
#include "terrain/eye_tracks.h"
#include "terrain/square_sectors.h"
#include "terrain/track_piece.h"
#include "terrain/vector_ground-inl.h"

#ifndef TERRVIEW_TERRAIN_EYE_FRONT_ONCE
#define TERRVIEW_TERRAIN_EYE_FRONT_ONCE
namespace terrview {

// Larger than the rounding of a clearance, as a share of the numbers it comes from.
constexpr double kBoundRounding = 1e-11;

// The edges of a group of wedges: lines from the eye, two to each.
struct WedgeEdges {
  using Values = std::array<double, EyeFront::kGroup>;
  // One piece of the tracks of the first edges, or of the second.
  struct alignas(64) Piece {
    alignas(64) Values start_u, start_v, rate_u, rate_v;
  };
  // Unit directions, view frame.
  alignas(64) Values x_a, y_a, x_b, y_b;
  std::vector<double> begins_m;
  std::vector<Piece> pieces_a;
  std::vector<Piece> pieces_b;
};

// One ring of sectors, and the blocks that cover them.
struct SectorRing {
  double near_m;
  double far_m;
  // The pieces of the tracks that these lie on.
  std::size_t near_piece;
  std::size_t far_piece;
  int level;
  const HeightCeilings::Level* blocks;  // null at level 0: cells are looked up themselves
};

}  // namespace terrview
#endif

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

class SectorBounds {
 public:
  SectorBounds(const Terrain& terrain, const WedgeEdges& edges, double margin_cells)
      : frame_(terrain.frame()),
        posts_(*terrain.layers()[0].grid),
        flat_(terrain.frame().north_curvature_per_m == 0 &&
              terrain.frame().east_curvature_per_m == 0),
        margin_cells_(margin_cells),
        last_cell_(terrain.layers()[0].grid->columns - 2, terrain.layers()[0].grid->rows - 2),
        eye_height_m_(terrain.frame().eye_height_m),
        z_scale_(terrain.frame().z_scale),
        edges_(edges) {}

  // The bounds of the sectors of lanes `first`, ... of the group.
  HWY_INLINE V at(const SectorRing& ring, std::size_t first) const {
    M outside;
    M wide;
    const V height = highest(ring, first, outside, wide);
    const V z = ceiling(ring, first, height);
    const V slack = of(kBoundRounding) *
                    (hn::Abs(of(z_scale_) * height) + of(std::abs(eye_height_m_)) + hn::Abs(z));
    const V top = z + slack;
    const V near = ring.near_m > 0 ? top / of(ring.near_m) : hn::Inf(D());
    const V bound = hn::IfThenElse(top < of(0), top / of(ring.far_m), near);
    // Above the rounding to a float.
    const V rounded_up = bound + hn::Abs(bound) * of(0x1p-22) + of(1e-30);
    const M empty = hn::Or(outside, height == of(-std::numeric_limits<double>::infinity()));
    const V known = hn::IfThenElse(wide, hn::Inf(D()), rounded_up);
    return hn::IfThenElse(empty, of(-std::numeric_limits<double>::infinity()), known);
  }

 private:
  // The first and last block along an axis.
  struct Blocks {
    V first, last;
  };

  // Those between the least and the greatest coordinate of a sector's corners.
  HWY_INLINE Blocks blocks(int level, const std::array<V, 4>& corners, double last_cell, M& outside,
                           M& wide) const {
    const V low = hn::Min(hn::Min(corners[0], corners[1]), hn::Min(corners[2], corners[3])) -
                  of(margin_cells_);
    const V high = hn::Max(hn::Max(corners[0], corners[1]), hn::Max(corners[2], corners[3])) +
                   of(margin_cells_);
    outside = hn::Or(high<of(0), low> of(last_cell + 1));
    const V per_block = of(std::ldexp(1.0, -level));
    const auto block = [&](V at) HWY_ATTR {
      return hn::Floor(hn::Floor(hn::Min(hn::Max(at, of(0)), of(last_cell))) * per_block);
    };
    const Blocks found{block(low), block(high)};
    wide = found.last > found.first + of(1);
    return found;
  }

  // Along one axis, where the edges cross the ends of a ring.
  using PieceValues = WedgeEdges::Values WedgeEdges::Piece::*;
  HWY_INLINE std::array<V, 4> corners(const SectorRing& ring, std::size_t first, PieceValues start,
                                      PieceValues rate) const {
    const auto at = [&](const std::vector<WedgeEdges::Piece>& pieces, std::size_t piece,
                        double distance_m) HWY_ATTR {
      return hn::Load(D(), (pieces[piece].*start).data() + first) +
             hn::Load(D(), (pieces[piece].*rate).data() + first) *
                 of(distance_m - edges_.begins_m[piece]);
    };
    return {at(edges_.pieces_a, ring.near_piece, ring.near_m),
            at(edges_.pieces_a, ring.far_piece, ring.far_m),
            at(edges_.pieces_b, ring.near_piece, ring.near_m),
            at(edges_.pieces_b, ring.far_piece, ring.far_m)};
  }

  HWY_INLINE V highest(const SectorRing& ring, std::size_t first, M& outside, M& wide) const {
    using Piece = WedgeEdges::Piece;
    M outside_u;
    M outside_v;
    M wide_u;
    M wide_v;
    const Blocks u = blocks(ring.level, corners(ring, first, &Piece::start_u, &Piece::rate_u),
                            last_cell_.x, outside_u, wide_u);
    const Blocks v = blocks(ring.level, corners(ring, first, &Piece::start_v, &Piece::rate_v),
                            last_cell_.y, outside_v, wide_v);
    wide = hn::Or(wide_u, wide_v);
    outside = hn::Or(outside_u, outside_v);
    if (ring.level == 0) return highest_of_cells(u, v);
    const V columns = of(ring.blocks->columns);
    const auto block = [&](V column, V row) HWY_ATTR {
      const hn::Rebind<float, D> floats;
      const hn::Rebind<std::int32_t, D> ints;
      return hn::GatherIndex(floats, ring.blocks->highest_m.data(),
                             hn::DemoteTo(ints, row * columns + column));
    };
    const auto north = hn::Max(block(u.first, v.first), block(u.last, v.first));
    const auto south = hn::Max(block(u.first, v.last), block(u.last, v.last));
    return hn::PromoteTo(D(), hn::Max(north, south));
  }

  HWY_INLINE V highest_of_cells(const Blocks& u, const Blocks& v) const {
    V highest = of(-std::numeric_limits<double>::infinity());
    for (const V row : {v.first, v.first + of(1), v.last + of(1)})
      for (const V column : {u.first, u.first + of(1), u.last + of(1)}) {
        const V post = posts_.at(row * of(last_cell_.x + 2) + column);
        highest = hn::IfThenElse(post > highest, post, highest);
      }
    return highest;
  }

  // The highest z over the sector. Along an edge z is monotonic in the distance, or bends by less
  // than the slack; and in the azimuth, because no wedge crosses an axis.
  HWY_INLINE V ceiling(const SectorRing& ring, std::size_t first, V height) const {
    if (flat_) return of(z_scale_) * height - of(eye_height_m_);
    const V x_a = hn::Load(D(), edges_.x_a.data() + first);
    const V y_a = hn::Load(D(), edges_.y_a.data() + first);
    const V x_b = hn::Load(D(), edges_.x_b.data() + first);
    const V y_b = hn::Load(D(), edges_.y_b.data() + first);
    const auto at = [&](double distance_m) HWY_ATTR {
      const V s = of(distance_m);
      return hn::Max(frame_.z(x_a * s, y_a * s, height), frame_.z(x_b * s, y_b * s, height));
    };
    return hn::Max(at(ring.near_m), at(ring.far_m));
  }

  VectorFrame frame_;
  VectorPosts posts_;
  bool flat_;
  double margin_cells_;
  glm::dvec2 last_cell_;
  double eye_height_m_;
  double z_scale_;
  const WedgeEdges& edges_;
};

// bounds[kGroup * i + j]: those of ring i and wedge j, of the rings before all wedges have met a
// bound above `highest_slope`. Returns how many rings these are.
std::size_t make_bounds(const Terrain& terrain, const WedgeEdges& edges,
                        std::span<const SectorRing> rings, double margin_cells,
                        double highest_slope, float* bounds) {
  const SectorBounds sectors(terrain, edges, margin_cells);
  const hn::Rebind<float, D> floats;
  const std::size_t lanes = hn::Lanes(D());
  std::array<V, EyeFront::kGroup> highest;  // of which kGroup / lanes are used
  std::fill(highest.begin(), highest.end(), of(-std::numeric_limits<double>::infinity()));
  for (std::size_t i = 0; i < rings.size(); ++i) {
    M closed = of(0) == of(0);
    for (std::size_t first = 0; first < EyeFront::kGroup; first += lanes) {
      const V bound = sectors.at(rings[i], first);
      hn::StoreU(hn::DemoteTo(floats, bound), floats, bounds + i * EyeFront::kGroup + first);
      V& so_far = highest[first / lanes];
      so_far = hn::Max(so_far, bound);
      closed = hn::And(closed, so_far > of(highest_slope));
    }
    if (hn::AllTrue(D(), closed)) return i + 1;
  }
  return rings.size();
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(make_bounds);

namespace {

// Sectors reach this far beyond what their corners say: above rounding, and above the bulge of a
// ring between the edges of a wedge. Where tracks bend, also above what they stray from the lines
// between the corners.
constexpr double kStraightMargin_cells = 0.02;
constexpr double kBentMargin_cells = 4 * GroundMap::kTrackError_cells;

// Wider than the rounding with which a ray finds its wedge.
constexpr double kEdgeMargin = 1e-12;

// The tracks of one edge, as piece `index` of each wedge's.
void set_piece(WedgeEdges::Piece& piece, std::size_t wedge, const TrackPiece& track) {
  piece.start_u[wedge] = track.start.x;
  piece.start_v[wedge] = track.start.y;
  piece.rate_u[wedge] = track.rate.x;
  piece.rate_v[wedge] = track.rate.y;
}

WedgeEdges edges_of(int group, int wedges_a_side, const GroundMap& map) {
  WedgeEdges edges;
  const EyeTracks* tracks = map.eye_tracks();
  edges.begins_m = tracks ? tracks->knots_m() : std::vector<double>{0, map.reach_m()};
  edges.begins_m.pop_back();
  edges.pieces_a.resize(edges.begins_m.size());
  edges.pieces_b.resize(edges.begins_m.size());
  for (int i = 0; i < EyeFront::kGroup; ++i) {
    const int wedge = group * EyeFront::kGroup + i;
    const int side = wedge / wedges_a_side;
    const double first = wedge % wedges_a_side;
    const glm::dvec2 a = sector_edge(side, first - kEdgeMargin * wedges_a_side, wedges_a_side);
    const glm::dvec2 b = sector_edge(side, first + 1 + kEdgeMargin * wedges_a_side, wedges_a_side);
    const auto j = static_cast<std::size_t>(i);
    edges.x_a[j] = a.x;
    edges.y_a[j] = a.y;
    edges.x_b[j] = b.x;
    edges.y_b[j] = b.y;
    for (std::size_t k = 0; k < edges.begins_m.size(); ++k) {
      const auto track = [&](glm::dvec2 direction) {
        return track_piece(map, {{0, 0}, direction}, edges.begins_m[k], map.to_grid({0, 0}),
                           map.reach_m());
      };
      set_piece(edges.pieces_a[k], j, track(a));
      set_piece(edges.pieces_b[k], j, track(b));
    }
  }
  return edges;
}

// The most posts along u or v that a metre of ground is worth.
double posts_per_metre(const GroundMap& map) {
  if (const glm::dmat2* jacobian = map.linear())
    return std::max(glm::length(glm::dvec2((*jacobian)[0].x, (*jacobian)[1].x)),
                    glm::length(glm::dvec2((*jacobian)[0].y, (*jacobian)[1].y)));
  // What the table's pieces say, and something for what lies between them. Sectors that come out
  // too wide all the same have no bound.
  const std::vector<double>& all = map.eye_tracks()->coefficients();
  double most = 0;
  for (std::size_t i = 0; i < all.size(); i += EyeTracks::kCoefficients)
    for (const std::size_t rate : {i + 4, i + 6})
      most = std::max(most, std::hypot(all[rate], all[rate + 1]));
  return 1.01 * most;
}

// A whole number of groups a side, and an even one of wedges, so that none crosses an axis.
int wedges_a_side(double wedge_rad) {
  constexpr int kStep = EyeFront::kGroup / 4;
  constexpr int kMost = 1 << 14;
  return kStep * static_cast<int>(std::ceil(std::clamp(2 / wedge_rad, 1.0, 1.0 * kMost) / kStep));
}

// The bin of a slope; continuous, before rounding down.
double start_bin(double slope) {
  return (slope / (1 + std::abs(slope)) + 1) * (EyeFront::kStartBins / 2);
}

int bin_of(double slope) {
  if (std::isinf(slope)) return slope < 0 ? 0 : EyeFront::kStartBins - 1;
  return std::min(static_cast<int>(start_bin(slope)), EyeFront::kStartBins - 1);
}

// Bin b holds the slopes from kBinSlopes[b] up; the inverse of the steepest of them, which meets
// the ground first.
const std::array<float, EyeFront::kStartBins>& inverse_bin_slopes() {
  static const auto inverses = [] {
    std::array<float, EyeFront::kStartBins> values{};
    for (std::size_t bin = 0; bin < values.size(); ++bin) {
      const double q = static_cast<double>(bin) / (EyeFront::kStartBins / 2) - 1;
      values[bin] = static_cast<float>((1 - std::abs(q)) / q);
    }
    return values;
  }();
  return inverses;
}

}  // namespace

bool EyeFront::serves(const Terrain& terrain) {
  if (terrain.layers().size() != 1 || terrain.model() != SurfaceModel::hyperboloid) return false;
  const TerrainLayer& layer = terrain.layers()[0];
  const VerticalFrame& frame = terrain.frame();
  const double gamma =
      terrain.reach_m() * std::max(frame.north_curvature_per_m, frame.east_curvature_per_m);
  constexpr double kMostPosts = 1 << 30;  // gathers index with 32 bits
  return layer.ceilings && (layer.map->linear() || layer.map->eye_tracks()) &&
         gamma * gamma < kSeriesLimit &&
         static_cast<double>(layer.grid->columns) * layer.grid->rows < kMostPosts;
}

EyeFront::EyeFront(const Terrain& terrain, const EyeFrontOptions& options)
    : terrain_(terrain),
      ceilings_(*terrain.layers()[0].ceilings),
      wedges_a_side_(terrview::wedges_a_side(options.wedge_rad)),
      margin_cells_(terrain.layers()[0].map->linear() ? kStraightMargin_cells : kBentMargin_cells),
      // Rays that rise may look over a near ridge and come far.
      highest_slope_(options.highest_slope < 0 ? static_cast<float>(options.highest_slope)
                                               : std::numeric_limits<float>::infinity()),
      first_bin_(bin_of(options.lowest_slope)),
      last_bin_(bin_of(options.highest_slope)) {
  lay_rings(2.0 / wedges_a_side_);
  index_rings();
  const auto wedges = static_cast<std::size_t>(4 * wedges_a_side_);
  const auto ring_count = static_cast<std::size_t>(rings());
  bounds_ = std::make_unique_for_overwrite<float[]>(wedges * (ring_count + 1));
  coarse_bounds_ =
      std::make_unique_for_overwrite<float[]>(wedges * static_cast<std::size_t>(coarse_rings()));
  bounds_beyond_ =
      std::make_unique_for_overwrite<float[]>(wedges * static_cast<std::size_t>(coarse_rings()));
  starts_m_ = std::make_unique_for_overwrite<float[]>(wedges * kStartBins);
  made_ = std::make_unique<std::once_flag[]>(wedges / kGroup);
}

void EyeFront::lay_rings(double wedge_rad) {
  // A sector may be this much wider than deep before the next level serves it better.
  constexpr double kWidest = 0.6;
  const double per_metre = posts_per_metre(*terrain_.layers()[0].map);
  const double reach_m = terrain_.reach_m();
  margin_m_ = margin_cells_ / per_metre / 2;
  ring_m_.push_back(0);
  int level = 0;
  while (ring_m_.back() < reach_m) {
    const double near_m = ring_m_.back();
    // Of 2^level cells, what the margins leave.
    const double box_m = (std::ldexp(1.0, level) - 2.5 * margin_cells_) / per_metre;
    const double arc_m = (near_m + box_m) * wedge_rad;
    if (arc_m > kWidest * box_m && level < ceilings_.last_level()) {
      ++level;
      continue;
    }
    const bool is_last = level == ceilings_.last_level();
    ring_m_.push_back(is_last ? std::max(reach_m, near_m + box_m)
                              : near_m + std::sqrt(box_m * box_m - arc_m * arc_m));
    levels_.push_back(level);
  }
}

void EyeFront::index_rings() {
  step_m_ = ring_m_.back();
  for (std::size_t i = 1; i < ring_m_.size(); ++i)
    step_m_ = std::min(step_m_, ring_m_[i] - ring_m_[i - 1]);
  int ring = 0;
  const auto steps = static_cast<std::size_t>(ring_m_.back() / step_m_) + 1;
  for (std::size_t i = 0; i < steps; ++i) {
    const double at_m = static_cast<double>(i) * step_m_;
    while (ring + 1 < rings() && ring_m_[static_cast<std::size_t>(ring) + 1] <= at_m) ++ring;
    ring_at_step_.push_back(ring);
  }
}

int EyeFront::ring_of(double distance_m) const {
  const auto step =
      std::min(static_cast<std::size_t>(distance_m / step_m_), ring_at_step_.size() - 1);
  int ring = ring_at_step_[step];
  while (ring + 1 < rings() && ring_m_[static_cast<std::size_t>(ring) + 1] <= distance_m) ++ring;
  return ring;
}

void EyeFront::make(int group) const {
  std::call_once(made_[static_cast<std::size_t>(group)], [&] {
    const GroundMap& map = *terrain_.layers()[0].map;
    const WedgeEdges edges = edges_of(group, wedges_a_side_, map);
    const auto piece_at = [tracks = map.eye_tracks()](double at_m) {
      return tracks ? static_cast<std::size_t>(tracks->piece_at(at_m)) : 0;
    };
    std::vector<SectorRing> rings;
    for (std::size_t i = 0; i < levels_.size(); ++i)
      rings.push_back({ring_m_[i], ring_m_[i + 1], piece_at(ring_m_[i]), piece_at(ring_m_[i + 1]),
                       levels_[i], levels_[i] == 0 ? nullptr : &ceilings_.level(levels_[i])});
    const std::size_t stride = (rings.size() + 1) * kGroup;
    float* bounds = bounds_.get() + static_cast<std::size_t>(group) * stride;
    const std::size_t made = HWY_DYNAMIC_DISPATCH(make_bounds)(
        terrain_, edges, rings, margin_cells_, highest_slope_, bounds);
    // A ray that comes so far, seldom, looks at every cell from there on.
    std::fill_n(bounds + made * kGroup, (rings.size() + 1 - made) * kGroup,
                std::numeric_limits<float>::infinity());
    make_coarse_bounds(group);
    make_starts(group);
  });
}

void EyeFront::make_coarse_bounds(int group) const {
  constexpr float kNone = -std::numeric_limits<float>::infinity();
  const auto count = static_cast<std::size_t>(rings());
  const auto coarse_count = static_cast<std::size_t>(coarse_rings());
  const auto place = static_cast<std::size_t>(group) * kGroup;
  const float* bounds = bounds_.get() + place * (count + 1);
  float* coarse = coarse_bounds_.get() + place * coarse_count;
  float* beyond = bounds_beyond_.get() + place * coarse_count;
  std::fill_n(coarse, coarse_count * kGroup, kNone);
  for (std::size_t ring = 0; ring < count; ++ring)
    for (std::size_t i = 0; i < kGroup; ++i) {
      float& highest = coarse[ring / kStride * kGroup + i];
      highest = std::max(highest, bounds[ring * kGroup + i]);
    }
  std::array<float, kGroup> highest{};
  highest.fill(kNone);
  for (std::size_t block = coarse_count; block-- > 0;)
    for (std::size_t i = 0; i < kGroup; ++i) {
      highest[i] = std::max(highest[i], coarse[block * kGroup + i]);
      beyond[block * kGroup + i] = highest[i];
    }
  // A search ends past the last ring.
  std::fill_n(coarse + (coarse_count - 1) * kGroup, kGroup, std::numeric_limits<float>::infinity());
}

void EyeFront::make_starts(int group) const {
  // Above the rounding with which a ray finds its bin.
  constexpr double kBinMargin = 1e-9;
  // Above that of the floats.
  constexpr float kShrink = 1 - 0x1p-20F;
  constexpr float kNever = std::numeric_limits<float>::infinity();
  const auto& inverse_slopes = inverse_bin_slopes();
  const auto count = static_cast<std::size_t>(rings()) + 1;
  const auto margin_m = static_cast<float>(margin_m_);
  const float* bounds = bounds_.get() + static_cast<std::size_t>(group) * count * kGroup;
  for (std::size_t i = 0; i < kGroup; ++i) {
    float* starts_m = starts_m_.get() + (static_cast<std::size_t>(group) * kGroup + i) * kStartBins;
    float highest = -kNever;
    int filled = first_bin_;
    for (std::size_t ring = 0; ring < count && filled <= last_bin_; ++ring) {
      const float bound = bounds[ring * kGroup + i];
      if (bound <= highest) continue;
      highest = bound;
      const double bin = std::isinf(bound) ? kStartBins : start_bin(bound) + kBinMargin;
      const int end = std::min(static_cast<int>(bin), last_bin_) + 1;
      const bool none = ring == count - 1;
      const float near_m =
          none ? kNever : static_cast<float>(std::max(0.0, ring_m_[ring] - margin_m_)) * kShrink;
      // Below the horizon no ground of the ring is above `bound` times its far end: a ray comes
      // down to that height later than to the ring.
      const float depth_m =
          none || bound >= 0 ? 0 : static_cast<float>(ring_m_[ring + 1]) * bound * kShrink;
      for (; filled < end; ++filled) {
        const float down_m = depth_m * inverse_slopes[static_cast<std::size_t>(filled)];
        starts_m[filled] = std::max(near_m, down_m * kShrink - margin_m);
      }
    }
    starts_m[first_bin_] = 0;
  }
}

}  // namespace terrview
#endif
