#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/sight_sweep.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "terrain/eye_tracks.h"
#include "terrain/sight_edges.h"
#include "terrain/sight_posts-inl.h"
#include "terrain/sight_slopes-inl.h"
#include "terrain/sight_sweep.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_limits.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
constexpr float kInfinity = std::numeric_limits<float>::infinity();

VEC_INLINE VF load(const std::vector<float>& values, std::size_t first) {
  return hn::LoadU(F(), values.data() + first);
}

// The wedges of a part of a side, swept outwards.
class PartSweep {
 public:
  PartSweep(const Terrain& terrain, double observer_m, const SightSide& side, int part,
            std::span<std::uint8_t> fates)
      : grid_(*terrain.layers()[0].grid),
        side_(side),
        part_(part),
        fates_(fates),
        slopes_(terrain, observer_m),
        ground_(grid_, side),
        has_holes_(terrain.has_holes()),
        track_margin_(terrain.layers()[0].map->linear() ? 0
                                                        : static_cast<float>(SightEdges::kTurn)),
        observer_m_(static_cast<float>(observer_m)),
        reach_m_(static_cast<float>(terrain.reach_m())),
        terrain_(terrain),
        edges_(edges(kFirstWedges, side.ahead(side.first_line()))),
        lower_(size(), -kInfinity),
        upper_(size(), -kInfinity) {}

  void run() {
    double ahead = 0;
    begin();
    for (int line = side_.first_line(); line >= 0 && line < side_.lines; line += side_.forward) {
      const double before = ahead;
      ahead = side_.ahead(line);
      if (before >= halve_at_ && !halve(before)) return;
      if (!edges_.advance(ahead)) return;
      cross(line, static_cast<float>(before), static_cast<float>(ahead));
    }
  }

 private:
  // Wedges of a side at first, and how wide they may become, in posts.
  static constexpr int kFirstWedges = 32 * SightSweep::kParts;
  static constexpr double kWidest = 0.9;
  // Rounding of places across, as a share of the posts ahead.
  static constexpr float kPlace = 0x1p-21F;
  static constexpr float kLeastMargin = 2e-4F;
  // Nearer posts are left to rays.
  static constexpr float kNearest = 3;
  // 1 / s is off by less than this share over s^2, in posts, where it is mixed over a post; from
  // kNearest on also where it is over the post before.
  static constexpr float kBend = 0.4F;
  // No row of a grid.
  static constexpr float kNoRow = -1e9F;

  [[nodiscard]] std::size_t size() const { return edges_.padded(); }
  [[nodiscard]] SightEdges edges(int wedges, double ahead) const {
    const int count = wedges / SightSweep::kParts;
    return {terrain_, side_, wedges, part_ * count, count + 1, ahead};
  }

  void resize() {
    for (std::vector<float>* values :
         {&across_, &across_before_, &drop_, &drop_before_, &scale_, &scale_before_})
      values->resize(size());
  }

  // Where all edges are at the eye.
  void begin() {
    resize();
    for (std::vector<float>& posts : posts_before_) posts.assign(size(), kNoRow);
    std::fill(across_.begin(), across_.end(),
              static_cast<float>(side_.eye[1 - side_.axis] - side_.base));
  }

  // Halves each wedge where the sweep stands.
  bool halve(double ahead) {
    wedges_ *= 2;
    halve_at_ *= 2;
    edges_ = edges(wedges_, ahead);
    if (!edges_.advance(ahead)) return false;
    inherit(lower_);
    inherit(upper_);
    for (std::vector<float>& posts : posts_before_) inherit(posts);
    resize();
    place_edges(static_cast<float>(ahead));
    return true;
  }

  // What is of wedges becomes that of their halves.
  void inherit(std::vector<float>& values) const {
    std::vector<float> halves(size());
    for (std::size_t i = 0; i < halves.size(); ++i) halves[i] = values[i / 2];
    values = std::move(halves);
  }

  // Where the edges cross a line so far ahead.
  void place_edges(float ahead) {
    for (std::size_t i = 0; i < edges_.count(); i += hn::Lanes(F())) {
      hn::StoreU(load(edges_.across, i) + load(edges_.slope, i) * of(ahead), F(),
                 across_.data() + i);
      const VF away = load(edges_.metres, i) + load(edges_.metres_per_post, i) * of(ahead);
      const Slopes slopes = slopes_.at(away, load(edges_.curvature, i));
      hn::StoreU(slopes.drop, F(), drop_.data() + i);
      hn::StoreU(slopes.scale, F(), scale_.data() + i);
    }
  }

  void cross(int line, float before, float ahead) {
    std::swap(across_, across_before_);
    std::swap(drop_, drop_before_);
    std::swap(scale_, scale_before_);
    place_edges(ahead);
    line_ = line;
    before_ = before;
    ahead_ = ahead;
    margin_ = kLeastMargin + track_margin_ + kPlace * ahead;
    bend_ = kBend / (ahead * ahead);
    for (std::size_t first = 0; first + 1 < edges_.count(); first += hn::Lanes(F()))
      cross_wedges(first);
  }

  VEC_INLINE void cross_wedges(std::size_t first) {
    const VF low = load(across_, first) - of(margin_);
    const VF high = load(across_, first + 1) + of(margin_);
    const MF outside = hn::Or(high<ground_.first_row(), low> ground_.last_row());
    if (hn::AllTrue(F(), outside)) return remember(first, {of(kNoRow), low, low, low});
    const Posts posts = ground_.from(hn::Floor(low), line_);
    const VF lower = load(lower_, first);
    VF upper = load(upper_, first);
    if (!edges_.is_steep()) decide(first, posts, {lower, upper});
    upper = hn::Max(upper, rows_crossed(first, posts, low, high));
    if (edges_.is_steep()) decide(first, posts, {lower, upper});
    const Bounds here = line_crossed(first, posts, low, high);
    hn::StoreU(hn::IfThenElse(outside, lower, hn::Max(lower, here.low)), F(),
               lower_.data() + first);
    hn::StoreU(hn::IfThenElse(outside, upper, hn::Max(upper, here.high)), F(),
               upper_.data() + first);
    remember(first, posts);
  }

  // For the next line.
  VEC_INLINE void remember(std::size_t first, const Posts& posts) {
    hn::StoreU(posts.row, F(), posts_before_[0].data() + first);
    hn::StoreU(posts.first, F(), posts_before_[1].data() + first);
    hn::StoreU(posts.second, F(), posts_before_[2].data() + first);
    hn::StoreU(posts.third, F(), posts_before_[3].data() + first);
  }

  // The fates of the posts that lie in wedges on the line.
  VEC_INLINE void decide(std::size_t first, const Posts& posts, const Bounds& horizon) {
    if (ahead_ < kNearest) return;
    const VF left = load(across_, first);
    const VF right = load(across_, first + 1);
    const VF row = hn::Ceil(left);
    const VF lanes = hn::Iota(F(), static_cast<float>(first));
    const MF real = lanes < of(static_cast<float>(edges_.count() - 1));
    const MF on_grid = hn::And(row >= ground_.first_row(), row <= ground_.last_row());
    const MF here = hn::And(hn::And(real, on_grid), row < right);
    if (hn::AllFalse(F(), here)) return;

    const VF height = hn::IfThenElse(row > posts.row + of(1), posts.third, posts.second);
    const VF share = (row - left) / (right - left);
    const Slopes at{mix(drop_, first, share), mix(scale_, first, share)};
    const VF above = slopes_.lift(height, of(observer_m_), load(edges_.curvature, first));
    const VF slope = at.drop + at.scale * above;
    const VF doubt = slopes_.slack(at, above, of(margin_ / ahead_ + bend_));
    // The stretch in the scale is below 1.002.
    const VF reach = at.scale * of(reach_m_);
    const MF seen = hn::And(slope - doubt > horizon.high, reach > of(1.002F));
    const MF hidden = hn::Or(slope + doubt < horizon.low, reach < of(0.9999F));
    store(row, here, seen, hn::Or(hidden, height != height));
  }

  VEC_INLINE VF mix(const std::vector<float>& values, std::size_t first, VF share) const {
    const VF from = load(values, first);
    return from + share * (load(values, first + 1) - from);
  }

  VEC_INLINE void store(VF row, MF here, MF seen, MF hidden) {
    alignas(64) std::array<std::int32_t, SightEdges::kVector> rows;
    hn::Store(whole(row), I(), rows.data());
    const std::uint32_t seen_bits = bits_of(seen);
    std::uint32_t decided = bits_of(hn::And(here, hn::Or(seen, hidden)));
    for (; decided != 0; decided &= decided - 1) {
      const int lane = std::countr_zero(decided);
      fates_[ground_.index(rows[static_cast<std::size_t>(lane)], line_)] =
          (seen_bits >> lane & 1U) != 0 ? kSeen : kHidden;
    }
  }

  static VEC_INLINE std::uint32_t bits_of(MF mask) {
    std::array<std::uint8_t, 8> bytes{};
    hn::StoreMaskBits(F(), mask, bytes.data());
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U;
  }

  // How steeply the ground can be seen where lines of a wedge cross the line of the grid.
  VEC_INLINE Bounds line_crossed(std::size_t first, const Posts& posts, VF low, VF high) const {
    const VF past = high - posts.row - of(1);  // of the second post
    const MF has_second = past >= of(0);
    const Bounds ground = posts.between(low, high, has_second);
    const VF curvature = load(edges_.curvature, first);
    Bounds bounds = slopes_.between(
        {load(drop_, first), load(scale_, first)},
        {load(drop_, first + 1), load(scale_, first + 1)},
        {slopes_.lift(ground.low, of(0), curvature), slopes_.lift(ground.high, of(0), curvature)},
        of(2 * margin_ / ahead_));
    if (has_holes_) bounds = beside_holes(first, posts, bounds);
    const MF wide = past > of(1);
    const MF partly = hn::Or(low<ground_.first_row(), high> ground_.last_row());
    return {hn::IfThenElse(hn::Or(wide, partly), of(-kInfinity), bounds.low),
            hn::IfThenElse(wide, of(kInfinity), bounds.high)};
  }

  // Beside a hole there may be no ground, and no bound is less than it would be without the hole.
  VEC_INLINE Bounds beside_holes(std::size_t first, const Posts& here, const Bounds& bounds) const {
    const Posts before = ground_.from(here.row, line_ - side_.forward);
    const MF whole_ground = hn::And(here.are_known(), before.are_known());
    const VF above = slopes_.lift(here.highest(), of(0), load(edges_.curvature, first));
    const Bounds highest = slopes_.between({load(drop_, first), load(scale_, first)},
                                           {load(drop_, first + 1), load(scale_, first + 1)},
                                           {above, above}, of(2 * margin_ / ahead_));
    return {hn::IfThenElse(whole_ground, bounds.low, of(-kInfinity)),
            hn::IfThenElse(whole_ground, bounds.high, highest.high)};
  }

  // How steeply the ground can be seen at the most where lines of a wedge cross rows between the
  // line of the grid before and this one.
  VEC_INLINE VF rows_crossed(std::size_t first, const Posts& posts, VF low, VF high) const {
    const Bounds before{load(across_before_, first) - of(margin_),
                        load(across_before_, first + 1) + of(margin_)};
    const VF last = hn::Min(hn::Max(high, before.high), ground_.last_row());
    VF row = hn::Max(hn::Ceil(hn::Min(low, before.low)), ground_.first_row());
    VF highest = of(-kInfinity);
    for (MF met = row <= last; !hn::AllFalse(F(), met); met = row <= last) {
      const VF slope = row_crossed(first, posts, row, met, before);
      highest = hn::IfThenElse(met, hn::Max(highest, slope), highest);
      row = row + of(1);
    }
    return highest;
  }

  // Where `met`.
  VEC_INLINE VF row_crossed(std::size_t first, const Posts& posts, VF row, MF met,
                            const Bounds& before) const {
    const Bounds part = part_on_row(first, row, before);
    const Posts posts_before{load(posts_before_[0], first), load(posts_before_[1], first),
                             load(posts_before_[2], first), load(posts_before_[3], first)};
    const VF from_height = ground_.heights_in(posts_before, row, met, line_ - side_.forward);
    const VF rise = ground_.heights_in(posts, row, met, line_) - from_height;
    const VF skipped = of(1 - (ahead_ - before_));  // where the eye is between two lines
    const VF height = hn::Max(from_height + (part.low + skipped) * rise,
                              from_height + (part.high + skipped) * rise);

    const VF above = slopes_.lift(height, of(0), load(edges_.curvature, first));
    const Bounds bounds = slopes_.between(slopes_from(first, part.low), slopes_to(first, part.high),
                                          {above, above}, of(2 * margin_ / ahead_ + bend_));
    const MF crossed = hn::And(part.low <= part.high, height == height);
    return hn::IfThenElse(crossed, bounds.high, of(-kInfinity));
  }

  // At most those of a wedge from a place `on` posts beyond the line before: distances grow, and
  // their inverses are convex.
  VEC_INLINE Slopes slopes_from(std::size_t first, VF on) const {
    const VF scale = hn::Max(load(scale_, first), load(scale_, first + 1));
    const VF drop = hn::Max(load(drop_, first), load(drop_, first + 1));
    const VF share = on * of(1 / (ahead_ - before_));
    if (before_ == 0) return {share * drop, scale / hn::Max(share, of(kLeastMargin))};
    const VF scale_before = hn::Max(load(scale_before_, first), load(scale_before_, first + 1));
    const VF drop_before = hn::Max(load(drop_before_, first), load(drop_before_, first + 1));
    return {drop_before + share * (drop - drop_before),
            scale_before + share * (scale - scale_before)};
  }

  // At least those of a wedge up to there, but for `bend_`.
  VEC_INLINE Slopes slopes_to(std::size_t first, VF on) const {
    const VF scale = hn::Min(load(scale_, first), load(scale_, first + 1));
    const VF drop = hn::Min(load(drop_, first), load(drop_, first + 1));
    if (before_ < kNearest) return {drop, scale};
    const VF share = on * of(1 / (ahead_ - before_));
    const VF scale_before = hn::Min(load(scale_before_, first), load(scale_before_, first + 1));
    const VF drop_before = hn::Min(load(drop_before_, first), load(drop_before_, first + 1));
    return {drop_before + share * (drop - drop_before),
            scale_before + share * (scale - scale_before)};
  }

  // From where to where in the step from line to line some line of the wedge is on the row.
  VEC_INLINE Bounds part_on_row(std::size_t first, VF row, const Bounds& before) const {
    const VF none = of(0);
    const VF step = of(ahead_ - before_);
    const MF low_falls = load(edges_.slope, first) < none;
    const MF high_rises = load(edges_.slope, first + 1) >= none;
    const VF by_low = (row - before.low) * load(edges_.inverse_slope, first);
    const VF by_high = (row - before.high) * load(edges_.inverse_slope, first + 1);
    return {hn::Max(none, hn::Max(hn::IfThenElse(low_falls, by_low, none),
                                  hn::IfThenElse(high_rises, by_high, none))),
            hn::Min(step, hn::Min(hn::IfThenElse(low_falls, step, by_low),
                                  hn::IfThenElse(high_rises, step, by_high)))};
  }

  const HeightGrid& grid_;
  SightSide side_;
  int part_;
  std::span<std::uint8_t> fates_;
  SightSlopes slopes_;
  SightPosts ground_;
  bool has_holes_;
  float track_margin_;
  float observer_m_;
  float reach_m_;
  const Terrain& terrain_;

  int wedges_ = kFirstWedges;  // of the side
  double halve_at_ = kWidest * kFirstWedges / 2;
  SightEdges edges_;
  // Of the wedges: bounds of the horizon.
  std::vector<float> lower_, upper_;
  std::array<std::vector<float>, 4> posts_before_;  // on the line before, as Posts
  // Of the edges, on this line and the one before.
  std::vector<float> across_, across_before_, drop_, drop_before_, scale_, scale_before_;
  int line_ = 0;
  float before_ = 0;  // posts from the eye to these lines
  float ahead_ = 0;
  float margin_ = 0;  // posts that wedges are widened by
  float bend_ = 0;    // what mixing slopes across a wedge, or from line to line, may be off
};

void run_part(const Terrain& terrain, double observer_m, const SightSide& side, int part,
              std::span<std::uint8_t> fates) {
  PartSweep(terrain, observer_m, side, part, fates).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(run_part);

bool SightSweep::serves(const Terrain& terrain, const HeightGrid& grid) {
  if (!within_vector_limits(terrain)) return false;
  const TerrainLayer& layer = terrain.layers()[0];
  return layer.grid.get() == &grid && (layer.map->linear() || layer.map->eye_tracks()) &&
         grid.covers(layer.map->to_grid({0, 0}));
}

void SightSweep::run(int side, int part, std::span<std::uint8_t> fates) const {
  HWY_DYNAMIC_DISPATCH(run_part)(terrain_, observer_m_, SightSide(terrain_, side), part, fates);
}

}  // namespace terrview
#endif
