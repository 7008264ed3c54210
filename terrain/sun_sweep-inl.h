// The sweep of some strips, sixteen cells at a time. Included once for every instruction set.
#if defined(TERRVIEW_TERRAIN_SUN_SWEEP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TERRVIEW_TERRAIN_SUN_SWEEP_INL_H_
#undef TERRVIEW_TERRAIN_SUN_SWEEP_INL_H_
#else
#define TERRVIEW_TERRAIN_SUN_SWEEP_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "terrain/sun_map.h"
#include "terrain/sun_sweep.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_transpose-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Sweeps kSunStrips strips and those beside them.
class StripSweep {
 public:
  StripSweep(const SunSweep& sweep, int first_strip)
      : sweep_(sweep),
        field_(sweep.field),
        track_(sweep.field, first_strip),
        track_after_(sweep.field, first_strip + kSunStrips) {
    horizon_.fill(kInfinity);
    wall_.fill(-kInfinity);
    caster_.fill(-kInfinity);
    edge_.fill(-kInfinity);
    // Of the outermost strips nothing is known: cells beside them are not looked at.
    std::fill_n(horizon_.begin() + kPad + kOutermost, kCells - 2 * kOutermost, -kInfinity);
  }

  void run() {
    for (int line = 0; line <= sweep_.part.last.y; line += kSunPanelLines) {
      const int end = std::min(line + kSunPanelLines, field_.lines() - 1);
      if (line > 0 && line <= sweep_.first_line && sweep_.first_line < end) pass_skipped(line);
      if (end > sweep_.first_line && load_panel(line, end))
        sweep_panel(line, end);
      else  // bent tracks may come back
        for (int y = line; y < end; ++y) stray();
      track_.next_panel();
      track_after_.next_panel();
    }
  }

 private:
  using F = hn::CappedTag<float, 16>;
  using VF = hn::Vec<F>;
  using MF = hn::Mask<F>;

  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  static constexpr std::size_t kLanes = hn::MaxLanes(F());
  static constexpr std::size_t kCells = kSunStrips + 16 + 2 * kSunHalo;
  static constexpr std::size_t kPad = 16;
  static constexpr std::size_t kOutermost = 8;
  static constexpr std::size_t kPanelPosts = kCells + 2 * kSunPanelLines + kPad;
  static_assert(kCells % 16 == 0);
  // Rounding of the fall of a cell, as a share of its terms.
  static constexpr float kRounding = 0x1p-20F;
  // More than the rounding of a place on a line, in posts.
  static constexpr double kPlace = 0x1p-10;

  using Values = std::array<float, kCells + 2 * kPad>;

  // Of values next to each other, from i + first to i + last.
  struct Range {
    int first, last;
  };

  static VEC_INLINE VF of(double x) { return hn::Set(F(), static_cast<float>(x)); }
  static VEC_INLINE VF get(const Values& values, std::size_t i, int step = 0) {
    return hn::LoadU(F(), values.data() + static_cast<std::ptrdiff_t>(kPad + i) + step);
  }
  static VEC_INLINE void keep(Values& values, std::size_t i, VF value) {
    hn::StoreU(value, F(), values.data() + kPad + i);
  }
  static VEC_INLINE VF highest(const Values& values, std::size_t i, const Range& range) {
    VF result = get(values, i, range.first);
    for (int step = range.first + 1; step <= range.last; ++step)
      result = hn::Max(result, get(values, i, step));
    return result;
  }
  static VEC_INLINE VF lowest(const Values& values, std::size_t i, const Range& range) {
    VF result = get(values, i, range.first);
    for (int step = range.first + 1; step <= range.last; ++step)
      result = hn::Min(result, get(values, i, step));
    return result;
  }
  static Range range_of(double first, double last) {
    return {static_cast<int>(std::floor(first)), static_cast<int>(std::floor(last))};
  }
  // i + range holds k where k + this holds i.
  static Range turned(const Range& range) { return {-range.last, -range.first}; }

  // Copies the posts of some lines of cells; NaN where there are none. False: there are none.
  bool load_panel(int line, int end) {
    panel_line_ = line;
    panel_x_ = std::min(track_.x(line), track_.x(end)) - kSunHalo;
    const int width = static_cast<int>(kPanelPosts);
    const int first = std::clamp(-panel_x_, 0, width);
    const int last = std::clamp(field_.posts() - panel_x_, first, width);
    if (first == last) return false;
    for (int i = 0; i <= end - line; ++i) {
      auto& posts = panel_[static_cast<std::size_t>(i)];
      std::fill_n(posts.begin(), first, std::numeric_limits<float>::quiet_NaN());
      std::fill(posts.begin() + last, posts.end(), std::numeric_limits<float>::quiet_NaN());
    }
    if (field_.over_rows())
      copy_rows(line, end, {first, last});
    else
      copy_columns(line, end, {first, last});
    return true;
  }

  void copy_rows(int line, int end, const Range& posts) {
    const auto columns = static_cast<std::size_t>(field_.posts());
    for (int i = 0; i <= end - line; ++i) {
      const auto row = static_cast<std::size_t>(sweep_.post_line(line + i));
      std::memcpy(panel_[static_cast<std::size_t>(i)].data() + posts.first,
                  sweep_.grid.heights_m.data() + row * columns + (panel_x_ + posts.first),
                  static_cast<std::size_t>(posts.last - posts.first) * sizeof(float));
    }
  }

  // Four rows at a time, all lines of the panel in each, since their rows lie far apart in memory.
  void copy_columns(int line, int end, const Range& posts) {
    const auto columns = static_cast<std::size_t>(field_.lines());
    const auto post = [&](int x, int column) {
      return sweep_.grid.heights_m.data() + static_cast<std::size_t>(panel_x_ + x) * columns +
             column;
    };
    const auto at = [&](int y) { return panel_[static_cast<std::size_t>(y - line)].data(); };
    const int back = field_.from_last() ? 3 : 0;
    int x = posts.first;
    for (; x + 4 <= posts.last; x += 4) {
      int y = line;
      for (; y + 3 <= end; y += 4) {
        const float* from = post(x, sweep_.post_line(y + back));
        transpose_4x4<float>({from, from + columns, from + 2 * columns, from + 3 * columns},
                             {at(y + back) + x, at(y + (1 ^ back)) + x, at(y + (2 ^ back)) + x,
                              at(y + (3 ^ back)) + x});
      }
      for (; y <= end; ++y)
        for (int i = 0; i < 4; ++i) at(y)[x + i] = *post(x + i, sweep_.post_line(y));
    }
    for (; x < posts.last; ++x)
      for (int y = line; y <= end; ++y) at(y)[x] = *post(x, sweep_.post_line(y));
  }

  void sweep_panel(int line, int end) {
    for (int y = line; y < end; ++y) sweep_line(y);
    if (field_.over_rows())
      put_rows(end);
    else
      put_columns(end);
  }

  void sweep_line(int line) {
    const SunRates& rates = track_.rates();
    const double place = track_.place(line);
    const double in_strip = place - std::floor(place);
    const double astray = kPlace + rates.spread + field_.track_error() + strayed_;
    const Range strips = range_of(in_strip + std::min(0.0, rates.drift) - astray,
                                  in_strip + 1 + std::max(0.0, rates.drift) + astray);
    const double turn = rates.spread + field_.track_error();
    const Range beside{static_cast<int>(std::floor(std::min(0.0, rates.drift - turn))),
                       static_cast<int>(std::ceil(std::max(0.0, rates.drift + turn)))};
    look_at_cells(line);
    if (sweep_.part.has_line(line)) light_cells(line, strips, beside);
    pass_cells(turned(strips));
    pass_edges(turned(range_of(in_strip - astray, in_strip + 1 + astray)));
    stray();
  }

  // What the cells of a line do to rays, from their posts.
  VEC_INLINE void look_at_cells(int line) {
    const SunRates& rates = track_.rates();
    const auto row = static_cast<std::size_t>(line - panel_line_);
    const auto x = static_cast<std::size_t>(track_.x(line) - kSunHalo - panel_x_);
    const float* north = panel_[row].data() + x;
    const float* south = panel_[row + 1].data() + x;
    const VF north_least = of(track_.rise_least(line));
    const VF south_least = of(track_.rise_least(line + 1));
    const VF north_most = of(track_.rise_most(line));
    const VF drift = of(-rates.drift);
    const VF rise_anywhere = of(rates.rise_least * (1 - field_.track_turn()));
    const VF turn = of(rates.spread + field_.track_turn());
    const VF lower = of(slack_of(rates));
    const VF none = of(-kInfinity);
    const bool is_near_eye = near_eye(line, 0, kCells);
    for (std::size_t i = 0; i < kCells; i += kLanes) {
      const VF rise = is_near_eye && near_eye(line, i, kLanes)
                          ? hn::IfThenElse(cells_near_eye(line, i), none, rise_anywhere)
                          : rise_anywhere;
      const VF nw = hn::LoadU(F(), north + i);
      const VF ne = hn::LoadU(F(), north + i + 1);
      const VF sw = hn::LoadU(F(), south + i);
      const VF se = hn::LoadU(F(), south + i + 1);
      const VF sum = (nw + ne) + (sw + se);
      const MF ground = sum == sum;
      const VF along_north = ne - nw;
      const VF along_south = se - sw;
      const VF down_west = sw - nw;
      const VF down_east = se - ne;
      const VF fall = hn::Min(drift * along_north, drift * along_south) +
                      (hn::Min(down_west, down_east) + rise);
      const VF along = hn::Abs(along_north) + hn::Abs(along_south);
      const VF terms = along + (hn::Abs(down_west) + hn::Abs(down_east)) + rise;
      const MF faces_sun = hn::And(ground, fall > of(kRounding) * terms + turn * along);
      const VF low = hn::Min(hn::Min(nw, ne) + north_least, hn::Min(sw, se) + south_least);
      VF top_north = hn::Max(nw, ne);
      VF top_south = hn::Max(sw, se);
      if (HWY_UNLIKELY(!hn::AllTrue(F(), ground))) {
        top_north = hn::Max(height_or_none(nw), height_or_none(ne));
        top_south = hn::Max(height_or_none(sw), height_or_none(se));
      }
      const VF top = hn::Max(top_north + north_least, top_south + south_least);
      keep(caster_, i, hn::IfThenElse(faces_sun, none, top));
      keep(low_, i, hn::IfThenElse(faces_sun, low - lower, none));
      keep(edge_, i, hn::IfThenElse(ground, hn::Min(nw, ne) + north_most, none));
    }
    if (field_.is_linear()) clear_outside(line);
  }

  // Whether one of the cells from cell i on is so near to the eye that it may not face the sun.
  [[nodiscard]] bool near_eye(int line, std::size_t i, std::size_t cells) const {
    const int x = track_.x(line) - kSunHalo + static_cast<int>(i);
    return field_.is_near_eye({x, line}, {x + static_cast<int>(cells), line + 1});
  }

  // Which cells from cell i on are.
  [[nodiscard]] MF cells_near_eye(int line, std::size_t i) const {
    alignas(64) std::array<float, kLanes> is_near;
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      is_near[lane] = near_eye(line, i + lane, 1) ? 1 : 0;
    return hn::Load(F(), is_near.data()) > of(0);
  }

  static VEC_INLINE VF height_or_none(VF post) {
    return hn::IfThenElse(post == post, post, of(-kInfinity));
  }

  // Straight tracks do not come back over the grid's border, onto ground that faces the sun.
  void clear_outside(int line) {
    const int cells = static_cast<int>(kCells);
    const int x = track_.x(line) - kSunHalo;
    const int first = std::clamp(-x, 0, cells);
    const int end = std::clamp(field_.posts() - 1 - x, 0, cells);
    std::fill_n(caster_.begin() + kPad, first, -kInfinity);
    std::fill(caster_.begin() + kPad + end, caster_.end(), -kInfinity);
  }

  // What is known of rays over the cells of a line from the ground towards the sun: what was
  // passed, and the cells from which rays come over the line itself, their own among them.
  VEC_INLINE void light_cells(int line, const Range& strips, const Range& beside) {
    const hn::RebindToSigned<F> ints;
    const double slack = slack_of(track_.rates());
    const VF per_height = of(sweep_.per_height);
    const VF free0 = of(sweep_.low + track_.rise_least(line) - slack);
    const VF stopped0 = of(sweep_.low + track_.rise_most(line) + slack);
    const VF most = of(SunMap::Codes::kMost);
    std::uint32_t* words = words_[static_cast<std::size_t>(line - panel_line_)].data();
    for (std::size_t i = 0; i < kCells; i += kLanes) {
      const VF ahead = hn::Max(highest(horizon_, i, strips), highest(caster_, i, beside));
      const VF free_above = hn::Ceil((ahead - free0) * per_height);
      const VF not_free = hn::Max(of(0), hn::Min(free_above, most));
      const VF free_code = most - hn::IfThenElseZero(get(low_, i) <= ahead, not_free);
      const VF stopped_below = hn::Floor((lowest(wall_, i, strips) - stopped0) * per_height);
      const VF stopped_code = hn::Max(of(0), hn::Min(stopped_below, most));
      const auto codes = hn::Or(hn::ConvertTo(ints, free_code),
                                hn::ShiftLeft<16>(hn::ConvertTo(ints, stopped_code)));
      hn::StoreU(hn::BitCast(hn::RebindToUnsigned<F>(), codes), hn::RebindToUnsigned<F>(),
                 words + i);
    }
  }

  // The cells of a line that are kept and these strips', as far as the next strips' own: rays
  // towards one sun do not cross, so each cell is of one sweep.
  [[nodiscard]] Range own_cells(int line) const {
    assert(track_.x(line) <= track_after_.x(line));
    if (!sweep_.part.has_line(line)) return {0, 0};
    const int end = sweep_.part.last.x + 1;
    const int most = static_cast<int>(kCells) - 2 * kSunHalo;
    const int first = std::clamp(track_.x(line), sweep_.part.first.x, end);
    return {first, std::clamp(std::min(track_after_.x(line), track_.x(line) + most), first, end)};
  }

  // Of a cell of the panel.
  [[nodiscard]] const std::uint32_t* word(int x, int line) const {
    return words_[static_cast<std::size_t>(line - panel_line_)].data() +
           (kSunHalo + x - track_.x(line));
  }

  void put_rows(int end) {
    for (int line = panel_line_; line < end; ++line)
      if (const Range own = own_cells(line); own.first < own.last)
        std::copy_n(word(own.first, line), own.last - own.first, sweep_.at(own.first, line));
  }

  // Four rows at a time, where all lines have them.
  void put_columns(int end) {
    Range common{0, field_.posts()};
    for (int line = panel_line_; line < end; ++line) {
      const Range own = own_cells(line);
      common = {std::max(common.first, own.first), std::min(common.last, own.last)};
    }
    if (end - panel_line_ < kSunPanelLines || common.last < common.first) common = {0, 0};
    common.last -= (common.last - common.first) % 4;
    const int back = field_.from_last() ? 3 : 0;
    const auto columns = static_cast<std::size_t>(sweep_.words_a_row);
    std::array<const std::uint32_t*, kSunPanelLines> from{};
    for (int i = 0; i < kSunPanelLines; ++i)
      from[static_cast<std::size_t>(i)] = word(0, panel_line_ + i);
    for (int x = common.first; x < common.last; x += 4) {
      for (std::size_t i = 0; i < kSunPanelLines; i += 4) {
        std::uint32_t* to = sweep_.at(x, panel_line_ + static_cast<int>(i) + back);
        const auto row = [&](int k) { return from[i + static_cast<std::size_t>(k ^ back)] + x; };
        transpose_4x4<std::uint32_t>({row(0), row(1), row(2), row(3)},
                                     {to, to + columns, to + 2 * columns, to + 3 * columns});
      }
    }
    for (int line = panel_line_; line < end; ++line) {
      const Range own = own_cells(line);
      for (int x = own.first; x < own.last; ++x)
        if (x < common.first || x >= common.last) *sweep_.at(x, line) = *word(x, line);
    }
  }

  [[nodiscard]] double slack_of(const SunRates& rates) const {
    return sweep_.slack + field_.blur() + field_.track_error() * rates.rise_most;
  }

  // Raises all horizons over the ground of the lines before, whatever it is.
  void pass_skipped(int line) {
    const VF top = of(sweep_.highest + track_.rise_least(line));
    for (std::size_t i = 0; i < kCells; i += kLanes)
      keep(horizon_, i, hn::Max(get(horizon_, i), top));
  }

  // Raises the horizons of the strips over cells that do not face the sun.
  VEC_INLINE void pass_cells(const Range& cells) {
    for (std::size_t i = 0; i < kCells; i += kLanes)
      keep(horizon_, i, hn::Max(get(horizon_, i), highest(caster_, i, cells)));
  }

  // Raises the walls across the strips that the edges on the line's side towards the sun span.
  VEC_INLINE void pass_edges(const Range& edges) {
    for (std::size_t i = 0; i < kCells; i += kLanes)
      keep(wall_, i, hn::Max(get(wall_, i), lowest(edge_, i, edges)));
  }

  // Rays stray from the mean way over a line: those of a strip may come from another.
  void stray() {
    strayed_ += track_.rates().spread;
    for (; strayed_ > 0.5; strayed_ = std::max(0.0, strayed_ - 1)) widen();
  }

  // What is known of strips is what is of both beside them, too.
  void widen() {
    const Values horizon = horizon_;
    const Values wall = wall_;
    for (std::size_t i = 0; i < kCells; i += kLanes) {
      keep(horizon_, i, highest(horizon, i, {-1, 1}));
      keep(wall_, i, lowest(wall, i, {-1, 1}));
    }
  }

  const SunSweep& sweep_;
  const SunField& field_;
  StripTrack track_;
  StripTrack track_after_;
  double strayed_ = 0;  // how far rays may have strayed from their strips, in posts
  int panel_line_ = 0;
  int panel_x_ = 0;
  // By strip, the first kSunHalo before those of track_.
  alignas(64) Values horizon_, wall_;
  // By cell of the line, cell i where strip i begins.
  alignas(64) Values caster_, low_, edge_;
  alignas(64) std::array<std::array<std::uint32_t, kCells>, kSunPanelLines> words_;
  alignas(64) std::array<std::array<float, kPanelPosts>, kSunPanelLines + 1> panel_;
};

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#endif
