#include "terrain/eye_front.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

#include "terrain/eye_cell.h"
#include "terrain/eye_tracks.h"
#include "terrain/line_starts.h"
#include "terrain/sector_bounds.h"
#include "terrain/vector_limits.h"

namespace terrview {

namespace {

// Sectors reach this far beyond what their corners say: above rounding, and above the bulge of a
// ring between the edges of a wedge. Where tracks bend, also above what they stray from the lines
// between the corners. Rays that look at floats stray by up to half of it.
constexpr double kStraightMargin_cells = 0.03;
constexpr double kBentMargin_cells = 4 * GroundMap::kTrackError_cells;

// Lines of the grid are looked at one by one where wedges are narrower, and no further.
constexpr double kWidest_cells = 2;
constexpr double kFurthest_cells = 200;
// As far as that, places in floats are off by less.
constexpr double kLineMargin_cells = 0x1p-9;

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
  return (slope / (EyeFront::kHalfwaySlope + std::abs(slope)) + 1) * (EyeFront::kStartBins / 2);
}

int bin_of(double slope) {
  if (std::isinf(slope)) return slope < 0 ? 0 : EyeFront::kStartBins - 1;
  return std::min(static_cast<int>(start_bin(slope)), EyeFront::kStartBins - 1);
}

// How many bins a bound is not below, with rounding.
std::size_t bins_up_to(float bound) {
  if (std::isinf(bound)) return bound < 0 ? 0 : EyeFront::kStartBins;
  return static_cast<std::size_t>(start_bin(bound) + EyeFront::kBinMargin) + 1;
}

// Above the rounding of floats.
constexpr float kShrink = 1 - 0x1p-20F;

// Somewhat nearer than a distance.
float before(float distance_m, float margin_m) {
  return std::max(0.0F, distance_m * kShrink - margin_m);
}

// By bin, the inverse of its lowest slope: that of the ray which meets the ground first.
const std::array<float, EyeFront::kStartBins>& inverse_bin_slopes() {
  static const auto inverses = [] {
    std::array<float, EyeFront::kStartBins> values{};
    for (std::size_t bin = 0; bin < values.size(); ++bin) {
      const double q =
          (static_cast<double>(bin) - EyeFront::kBinMargin) / (EyeFront::kStartBins / 2) - 1;
      values[bin] = static_cast<float>((1 - std::abs(q)) / (EyeFront::kHalfwaySlope * q));
    }
    return values;
  }();
  return inverses;
}

// The starts of a wedge from bin `first_bin` on, as rings have them.
class RingStarts {
 public:
  RingStarts(std::span<float> starts_m, int first_bin, double margin_m)
      : starts_m_(starts_m),
        inverses_(std::span(inverse_bin_slopes()).subspan(static_cast<std::size_t>(first_bin))),
        first_bin_(static_cast<std::size_t>(first_bin)),
        margin_m_(static_cast<float>(margin_m)) {}

  // Ground in a ring, no steeper than `bound`; no ring not yet met is nearer.
  void meet(float near_m, float far_m, float bound) {
    if (bound <= highest_) return;
    highest_ = bound;
    const std::size_t end =
        std::min(std::max(bins_up_to(bound), first_bin_) - first_bin_, starts_m_.size());
    const float begins_m = before(near_m, margin_m_);
    // Below the horizon no ground is above `bound` times its far end: a ray comes down to that
    // height later than to the near one.
    const float depth_m = bound >= 0 ? 0 : far_m * bound * kShrink;
    for (; filled_ < end; ++filled_) {
      const float down_m = depth_m * inverses_[filled_] * kShrink - margin_m_;
      starts_m_[filled_] = std::min(starts_m_[filled_], std::max(begins_m, down_m));
    }
  }

  // Goes on with the first bin of which nothing is known nearer than `known_m`.
  void skip(float known_m) {
    while (filled_ < starts_m_.size() && starts_m_[filled_] < known_m) ++filled_;
  }

  [[nodiscard]] bool are_full() const { return filled_ == starts_m_.size(); }

 private:
  std::span<float> starts_m_;
  std::span<const float> inverses_;
  std::size_t first_bin_;
  float margin_m_;
  std::size_t filled_ = 0;
  float highest_ = -std::numeric_limits<float>::infinity();
};

// Makes starts of the distances at which the ground of each bin begins: rays of a bin may meet that
// of the bins above it as well.
void spread_down(std::span<float> starts_m, double margin_m) {
  float nearest_m = std::numeric_limits<float>::infinity();
  for (std::size_t i = starts_m.size(); i-- > 0;) {
    nearest_m = std::min(nearest_m, starts_m[i]);
    starts_m[i] = before(nearest_m, static_cast<float>(margin_m));
  }
}

}  // namespace

bool EyeFront::serves(const Terrain& terrain) {
  if (!within_vector_limits(terrain) || !(terrain.frame().z_scale > 0)) return false;
  const TerrainLayer& layer = terrain.layers()[0];
  return layer.ceilings && (layer.map->linear() || layer.map->eye_tracks());
}

EyeFront::EyeFront(const Terrain& terrain, const EyeFrontOptions& options)
    : terrain_(terrain),
      ceilings_(*terrain.layers()[0].ceilings),
      wedges_a_side_(terrview::wedges_a_side(options.wedge_rad)),
      margin_cells_(terrain.layers()[0].map->linear() ? kStraightMargin_cells : kBentMargin_cells),
      looks_at_lines_(options.looks_at_lines && EyeCell(terrain).is_above_ground()),
      // Rays that rise may look over a near ridge and come far.
      highest_slope_(options.highest_slope < 0 ? static_cast<float>(options.highest_slope)
                                               : std::numeric_limits<float>::infinity()),
      // That of the lowest slope itself does not stand for those below.
      first_bin_(std::max(bin_of(options.lowest_slope) - 1, 0)),
      last_bin_(bin_of(options.highest_slope)) {
  assert(options.lowest_slope <= options.highest_slope);
  lay_rings(2.0 / wedges_a_side_);
  index_rings();
  near_m_.assign(ring_m_.begin(), ring_m_.end());
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
  furthest_line_m_ = std::min(kFurthest_cells, kWidest_cells / wedge_rad) / per_metre;
  ring_m_.push_back(0);
  // Where lines are looked at, rings say little.
  int level = std::min(looks_at_lines_ ? 2 : 0, ceilings_.last_level());
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

void EyeFront::make(int group) const {
  std::call_once(made_[static_cast<std::size_t>(group)], [&] {
    const GroundMap& map = *terrain_.layers()[0].map;
    const WedgeEdges edges = wedge_edges(group, wedges_a_side_, map);
    const auto piece_at = [tracks = map.eye_tracks()](double at_m) {
      return tracks ? static_cast<std::size_t>(tracks->piece_at(at_m)) : 0;
    };
    std::vector<SectorRing> rings;
    for (std::size_t i = 0; i < levels_.size(); ++i)
      rings.push_back({ring_m_[i], ring_m_[i + 1], piece_at(ring_m_[i]), piece_at(ring_m_[i + 1]),
                       levels_[i], levels_[i] == 0 ? nullptr : &ceilings_.level(levels_[i])});
    const std::size_t stride = (rings.size() + 1) * kGroup;
    float* bounds = bounds_.get() + static_cast<std::size_t>(group) * stride;
    const std::size_t made =
        make_bounds(terrain_, edges, rings, margin_cells_, highest_slope_, bounds);
    // A ray that comes so far, seldom, looks at every cell from there on.
    std::fill_n(bounds + made * kGroup, (rings.size() + 1 - made) * kGroup,
                std::numeric_limits<float>::infinity());
    make_coarse_bounds(group);
    make_starts(group, edges);
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

std::size_t EyeFront::ring_before(float distance_m) const {
  if (!(distance_m < near_m_.back())) return static_cast<std::size_t>(rings());
  const auto step = static_cast<std::size_t>(distance_m / step_m_);
  const std::int32_t ring = ring_at_step_[std::min(step, ring_at_step_.size() - 1)];
  return static_cast<std::size_t>(std::max(ring - 1, 0));
}

void EyeFront::make_starts(int group, const WedgeEdges& edges) const {
  constexpr auto kBins = static_cast<std::size_t>(kStartBins);
  const auto count = static_cast<std::size_t>(rings());
  const float* bounds = bounds_.get() + static_cast<std::size_t>(group) * (count + 1) * kGroup;
  float* group_starts_m = starts_m_.get() + static_cast<std::size_t>(group) * kGroup * kBins;
  const auto starts_of = [&](std::size_t wedge) {
    return std::span(group_starts_m + wedge * kBins, static_cast<std::size_t>(last_bin_) + 1)
        .subspan(static_cast<std::size_t>(first_bin_));
  };
  for (std::size_t i = 0; i < kGroup; ++i)
    std::ranges::fill(starts_of(i), std::numeric_limits<float>::infinity());
  WedgeDistances known_m{};
  if (looks_at_lines_) {
    std::vector<double> margins_cells = bends_between_edges(
        edges, group, wedges_a_side_, *terrain_.layers()[0].map, 4 * furthest_line_m_);
    for (double& margin : margins_cells) margin += kLineMargin_cells;
    known_m = meet_lines(terrain_, edges,
                         {std::move(margins_cells), kBentMargin_cells, furthest_line_m_,
                          highest_slope_, first_bin_, last_bin_},
                         group_starts_m);
  }
  for (std::size_t i = 0; i < kGroup; ++i) {
    const std::span<float> starts_m = starts_of(i);
    if (looks_at_lines_) spread_down(starts_m, margin_m_);
    RingStarts by_rings(starts_m, first_bin_, margin_m_);
    by_rings.skip(known_m[i]);
    for (std::size_t ring = ring_before(known_m[i]); ring < count && !by_rings.are_full(); ++ring) {
      const float far_m = near_m_[ring + 1];
      if (far_m <= known_m[i]) continue;
      by_rings.meet(std::max(near_m_[ring], known_m[i]), far_m, bounds[ring * kGroup + i]);
    }
    // Slopes below those of the first bin are in it too.
    starts_m[0] = 0;
  }
}

}  // namespace terrview
