#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/march.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "terrain/height_ceilings.h"
#include "terrain/march.h"
#include "terrain/march_set.h"
#include "terrain/sun_map.h"
#include "terrain/terrain.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_masks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Marches the rays of a set until each is decided or cannot be.
class Marcher {
 public:
  using F = hn::CappedTag<float, 16>;
  using I = hn::RebindToSigned<F>;
  using VF = hn::Vec<F>;
  using VI = hn::Vec<I>;
  using MF = hn::Mask<F>;

  Marcher(const Terrain& terrain, const SunMap* sun, MarchSet& set, Fates& fates)
      : grid_(*terrain.layers()[0].grid),
        ceilings_(*terrain.layers()[0].ceilings),
        highest_m_(ceilings_.level(ceilings_.last_level()).highest_m[0]),
        has_holes_(terrain.has_holes()),
        leaves_once_(terrain.layers()[0].map->linear() != nullptr),
        sun_(sun),
        set_(set),
        fates_(fates) {}

  // A few cells, then two blocks of each size; those that do not clear one begin again from there.
  void run(TraceCounts& counts) {
    constexpr int kCells = 3;
    constexpr int kBlocks = 2;
    while (set_.count > 0) {
      for (std::size_t first = 0; first < set_.count; first += kLanes)
        set_.marching[first / kLanes] = static_cast<std::uint16_t>(lanes_from(first));
      for (int i = 0; i < kCells; ++i)
        each_vector([&](std::size_t first) HWY_ATTR { cross_cells(first); });
      for (int level = 1; level <= ceilings_.last_level(); ++level)
        for (int i = 0; i < kBlocks; ++i)
          each_vector([&](std::size_t first) HWY_ATTR { cross_blocks(first, level); });
      pack();
    }
    counts.tests += tests_;
    counts.nodes += nodes_;
  }

 private:
  static constexpr std::size_t kLanes = hn::MaxLanes(F());

  // Rounding of a sum of a few terms, as a share of them; of a place, in posts, and how that grows
  // with the posts that are passed.
  static constexpr float kRounding = 0x1p-21F;
  static constexpr float kPlace = 0x1p-18F;
  static constexpr float kPlaceGrowth = 0x1p-20F;

  // The next line of a ray that a march meets.
  struct Exit {
    VF g;
    MF over_column;
    VI line;    // its column or row
    VF across;  // where it is crossed, in posts from the beginning
    VF doubt;   // of `across`
  };

  template <class Step>
  VEC_INLINE void each_vector(const Step& step) {
    for (std::size_t first = 0; first < set_.count; first += kLanes)
      if (set_.marching[first / kLanes] != 0) step(first);
  }

  static VEC_INLINE VF of(float x) { return hn::Set(F(), x); }
  static VEC_INLINE VI of_int(std::int32_t x) { return hn::Set(I(), x); }
  static VEC_INLINE VF get(const MarchSet::Floats& values, std::size_t first) {
    return hn::Load(F(), values.data() + first);
  }
  static VEC_INLINE VI get(const MarchSet::Ints& values, std::size_t first) {
    return hn::Load(I(), values.data() + first);
  }
  static VEC_INLINE std::uint32_t bits_of(MF mask) { return mask_bits(F(), mask); }
  static VEC_INLINE MF mask_of(std::uint32_t bits) { return mask_from(F(), bits); }
  static VEC_INLINE VI choose(MF mask, VI yes, VI no) {
    return hn::IfThenElse(hn::RebindMask(I(), mask), yes, no);
  }

  VEC_INLINE std::uint32_t lanes_from(std::size_t first) const {
    return (1U << std::min(kLanes, set_.count - first)) - 1;
  }

  // Where rays leave blocks of cells, from the lines before the blocks to those after them.
  VEC_INLINE Exit leave(std::size_t first, VI west, VI east, VI north, VI south) const {
    const VF rate_u = get(set_.rate_u, first);
    const VF rate_v = get(set_.rate_v, first);
    const VF u = get(set_.u, first);
    const VF v = get(set_.v, first);
    const VF g = get(set_.g, first);
    const VI column = choose(rate_u > of(0), east, west);
    const VI row = choose(rate_v > of(0), south, north);
    const auto meets = [&](VI line, VI line0, VF start, VF rate, VF metres) HWY_ATTR {
      const VF at = (hn::ConvertTo(F(), line - line0) - start) * metres;
      return hn::IfThenElse(rate == of(0), hn::Inf(F()), hn::Max(g, at));
    };
    const VF g_u = meets(column, get(set_.column0, first), u, rate_u, get(set_.metres_u, first));
    const VF g_v = meets(row, get(set_.row0, first), v, rate_v, get(set_.metres_v, first));
    Exit exit;
    exit.over_column = g_u <= g_v;
    exit.g = hn::Min(g_u, g_v);
    exit.line = choose(exit.over_column, column, row);
    const VF moved = hn::IfThenElse(exit.over_column, rate_v, rate_u) * exit.g;
    exit.across = hn::IfThenElse(exit.over_column, v, u) + moved;
    const VF passed = hn::Max(hn::Abs(rate_u), hn::Abs(rate_v)) * exit.g;
    exit.doubt = of(kPlace) + of(kPlaceGrowth) * passed;
    return exit;
  }

  // Lanes whose place between two lines is not known, of the share of the way from one to the
  // other.
  static VEC_INLINE MF in_doubt(VF share, VF doubt) {
    return hn::Or(share<doubt, share> of(1) - doubt);
  }

  // Whether the cells with these first posts have a height at each of their corners.
  VEC_INLINE MF has_ground(VI post) const {
    const float* heights_m = grid_.heights_m.data();
    const VF north =
        hn::GatherIndex(F(), heights_m, post) + hn::GatherIndex(F(), heights_m, post + of_int(1));
    const VI south_post = post + of_int(grid_.columns);
    const VF south = hn::GatherIndex(F(), heights_m, south_post) +
                     hn::GatherIndex(F(), heights_m, south_post + of_int(1));
    const VF sum = north + south;
    return sum == sum;
  }

  // One cell of rays first, first + 1, ...
  VEC_INLINE void cross_cells(std::size_t first) {
    std::uint32_t active = set_.marching[first / kLanes];
    const VI column = get(set_.column, first);
    const VI row = get(set_.row, first);
    const Exit exit = leave(first, column, column + of_int(1), row, row + of_int(1));
    const VI across_cell =
        choose(exit.over_column, row - get(set_.row0, first), column - get(set_.column0, first));
    const VF share = exit.across - hn::ConvertTo(F(), across_cell);

    const VI columns = of_int(grid_.columns);
    const VI post =
        choose(exit.over_column, row * columns + exit.line, exit.line * columns + column);
    const VI next_post = post + choose(exit.over_column, columns, of_int(1));
    const MF live = mask_of(active);
    const VI zero = of_int(0);
    const VF from = hn::GatherIndex(F(), grid_.heights_m.data(), choose(live, post, zero));
    const VF to = hn::GatherIndex(F(), grid_.heights_m.data(), choose(live, next_post, zero));
    const VF edge = to - from;
    const MF on_ground =
        has_holes_ ? hn::And(live, has_ground(choose(live, row * columns + column, zero))) : live;
    const VF climb = get(set_.rise, first) * exit.g;
    const VF above = (get(set_.height, first) - from) + (climb - share * edge);
    const VF slack = get(set_.slack, first) +
                     of(kRounding) * (hn::Abs(climb) + hn::Abs(from) + hn::Abs(to)) +
                     exit.doubt * hn::Abs(edge);
    const VF bend = get(set_.bend, first) * exit.g * exit.g;

    const VF end = get(set_.end, first);
    const VF metres =
        hn::IfThenElse(exit.over_column, get(set_.metres_u, first), get(set_.metres_v, first));
    const std::uint32_t knot = bits_of(exit.g >= end) & active;
    // The next piece may begin beyond this edge, which would then be left out.
    const std::uint32_t near_knot = knot & bits_of(exit.g - end < exit.doubt * hn::Abs(metres));
    active &= ~knot;
    const std::uint32_t clear = bits_of(hn::AndNot(in_doubt(share, exit.doubt), above > slack));
    // The edge between two holes stops nothing.
    const MF below_edge = hn::And(on_ground, above + bend < hn::Neg(slack));
    const std::uint32_t below = bits_of(hn::AndNot(in_doubt(share, exit.doubt), below_edge));
    tests_ += __builtin_popcount(active);
    settle(first, active & below, March::stopped);
    settle(first, active & ~(below | clear), March::undecided);
    settle(first, knot & ~near_knot, March::at_knot);
    settle(first, near_knot, March::undecided);
    active &= clear;

    const MF forward =
        hn::IfThenElse(exit.over_column, get(set_.rate_u, first), get(set_.rate_v, first)) > of(0);
    const VI step = choose(forward, of_int(1), of_int(-1));
    const VI next_column = column + choose(exit.over_column, step, zero);
    const VI next_row = row + choose(exit.over_column, zero, step);
    go_on(first, active, exit, next_column, next_row);
  }

  // One block of 2^level x 2^level cells.
  VEC_INLINE void cross_blocks(std::size_t first, int level) {
    std::uint32_t active = set_.marching[first / kLanes];
    const VI column = get(set_.column, first);
    const VI row = get(set_.row, first);
    const HeightCeilings::Level& blocks = ceilings_.level(level);
    const VI block_column = hn::ShiftRightSame(column, level);
    const VI block_row = hn::ShiftRightSame(row, level);
    const VI side = of_int(1 << level);
    const VI west = hn::ShiftLeftSame(block_column, level);
    const VI north = hn::ShiftLeftSame(block_row, level);
    const VI east = hn::Min(west + side, of_int(grid_.columns - 1));
    const VI south = hn::Min(north + side, of_int(grid_.rows - 1));
    const Exit exit = leave(first, west, east, north, south);

    const MF live = mask_of(active);
    const VI block = choose(live, block_row * of_int(blocks.columns) + block_column, of_int(0));
    const VF ceiling = hn::GatherIndex(F(), blocks.highest_m.get(), block);
    const VF rise = get(set_.rise, first);
    const VF climb = hn::Min(rise * exit.g, rise * get(set_.g, first));
    const VF slack =
        get(set_.slack, first) + of(kRounding) * (hn::Abs(rise * exit.g) + hn::Abs(ceiling));
    const MF above = (get(set_.height, first) - ceiling) + climb > slack;
    const MF empty = ceiling == hn::Neg(hn::Inf(F()));
    nodes_ += __builtin_popcount(active);

    const VF cell = hn::Floor(exit.across);
    const VI across_cell =
        hn::ConvertTo(I(), cell) +
        choose(exit.over_column, get(set_.row0, first), get(set_.column0, first));
    const MF known =
        hn::AndNot(in_doubt(exit.across - cell, exit.doubt), exit.g < get(set_.end, first));
    active &= bits_of(hn::And(hn::Or(above, empty), known));

    const MF forward =
        hn::IfThenElse(exit.over_column, get(set_.rate_u, first), get(set_.rate_v, first)) > of(0);
    const VI beyond = choose(forward, exit.line, exit.line - of_int(1));
    go_on(first, active, exit, choose(exit.over_column, beyond, across_cell),
          choose(exit.over_column, across_cell, beyond));
  }

  // Moves the `active` lanes; those that have left the grid, or rise above all of it, are decided.
  VEC_INLINE void go_on(std::size_t first, std::uint32_t active, const Exit& exit, VI column,
                        VI row) {
    const VF g = exit.g;
    const MF moving = mask_of(active);
    hn::Store(hn::IfThenElse(moving, g, get(set_.g, first)), F(), set_.g.data() + first);
    hn::Store(choose(moving, column, get(set_.column, first)), I(), set_.column.data() + first);
    hn::Store(choose(moving, row, get(set_.row, first)), I(), set_.row.data() + first);
    const VI last_column = of_int(grid_.columns - 2);
    const VI last_row = of_int(grid_.rows - 2);
    const auto beyond =
        hn::Or(hn::Or(column<of_int(0), column> last_column), hn::Or(row<of_int(0), row> last_row));
    const std::uint32_t outside = active & bits_of(hn::RebindMask(F(), beyond));
    const VF rise = get(set_.rise, first);
    const VF climb = rise * g;
    const VF highest = of(highest_m_);
    const VF slack = get(set_.slack, first) + of(kRounding) * (hn::Abs(climb) + hn::Abs(highest));
    const MF over_all = hn::And(rise >= of(0), (get(set_.height, first) - highest) + climb > slack);
    const std::uint32_t free = active & bits_of(over_all);
    settle(first, free, March::free);
    settle(first, outside & ~free, leaves_once_ ? March::free : March::undecided);
    active &= ~(outside | free);
    if (sun_ != nullptr) active = look_up(first, active, exit, column, row);
    set_.marching[first / kLanes] = static_cast<std::uint16_t>(active);
  }

  // Decides what the map of the sun knows of rays that come to a cell from above; returns the
  // others.
  VEC_INLINE std::uint32_t look_up(std::size_t first, std::uint32_t active, const Exit& exit,
                                   VI column, VI row) {
    using Codes = SunMap::Codes;
    const Codes& codes = sun_->codes();
    const glm::ivec2 size = sun_->cells().size();
    const VI place_u = column - of_int(sun_->cells().first.x);
    const VI place_v = row - of_int(sun_->cells().first.y);
    const auto below = [](VI place, int end) HWY_ATTR {
      const hn::RebindToUnsigned<I> u;
      return hn::BitCast(u, place) < hn::Set(u, static_cast<std::uint32_t>(end));
    };
    const auto among = hn::And(below(place_u, size.x), below(place_v, size.y));
    const std::uint32_t over_map =
        active & bits_of(hn::RebindMask(F(), hn::RebindMask(I(), among)));
    if (over_map == 0) return active;
    const VI index = place_v * of_int(size.x) + place_u;
    const VI live = hn::IfThenElseZero(hn::RebindMask(I(), mask_of(over_map)), index);
    const VI word =
        hn::GatherIndex(I(), reinterpret_cast<const std::int32_t*>(sun_->words()), live);
    const hn::RebindToUnsigned<F> words;
    const VI most = of_int(Codes::kMost);
    const VF free_above = hn::ConvertTo(F(), most - hn::And(word, most));
    const VF stopped_below =
        hn::ConvertTo(F(), hn::BitCast(I(), hn::ShiftRight<16>(hn::BitCast(words, word))));

    const VF climb = get(set_.rise, first) * exit.g;
    const VF height = get(set_.height, first) + climb;
    const VF slack = get(set_.slack, first) + of(kRounding) * (hn::Abs(climb) + hn::Abs(height));
    const VF highest = height + slack + get(set_.bend, first) * exit.g * exit.g;
    // From line to line of the map; a ray that comes in over a side has less of that before it.
    const MF over_side = codes.over_rows ? exit.over_column : hn::Not(exit.over_column);
    const VF rise = hn::IfThenZeroElse(over_side, of(static_cast<float>(codes.rise_least)));
    const VF low = of(static_cast<float>(codes.low));
    const VF per_height = of(static_cast<float>(codes.per_height));
    const VF rounding = of(static_cast<float>(Codes::kRounding));
    const VF least_code = (height - slack + rise - low) * per_height;
    const VF most_code = (highest + of(static_cast<float>(codes.rise_most)) - low) * per_height;
    const MF known = free_above < of(static_cast<float>(Codes::kMost));
    const MF free = hn::Or(free_above == of(0), hn::And(known, least_code > free_above + rounding));
    const MF stopped = most_code < stopped_below - rounding;
    const std::uint32_t free_lanes = over_map & bits_of(free);
    const std::uint32_t stopped_lanes = over_map & ~free_lanes & bits_of(stopped);
    settle(first, free_lanes, March::free);
    settle(first, stopped_lanes, March::stopped);
    return active & ~(free_lanes | stopped_lanes);
  }

  VEC_INLINE void settle(std::size_t first, std::uint32_t lanes, March fate) {
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto i = first + static_cast<std::size_t>(__builtin_ctz(lanes));
      fates_[static_cast<std::size_t>(set_.index[i])] = fate;
    }
  }

  // Moves the rays that are on their way to the front of the set.
  void pack() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < set_.count; ++i) {
      if (fates_[static_cast<std::size_t>(set_.index[i])] != March::on_its_way) continue;
      if (kept != i) set_.move(i, kept);
      ++kept;
    }
    set_.count = kept;
  }

  const HeightGrid& grid_;
  const HeightCeilings& ceilings_;
  float highest_m_;
  bool has_holes_;
  bool leaves_once_;
  const SunMap* sun_;
  MarchSet& set_;
  Fates& fates_;
  std::int64_t tests_ = 0;
  std::int64_t nodes_ = 0;
};

void march_to_end(const Terrain& terrain, const SunMap* sun, MarchSet& set, Fates& fates,
                  TraceCounts& counts) {
  Marcher(terrain, sun, set, fates).run(counts);
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(march_to_end);

void march(const Terrain& terrain, const SunMap* sun, MarchSet& set, Fates& fates,
           TraceCounts& counts) {
  HWY_DYNAMIC_DISPATCH(march_to_end)(terrain, sun, set, fates, counts);
}

}  // namespace terrview
#endif
