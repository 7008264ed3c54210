#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/march_tracks.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <cstddef>
#include <span>

#include "terrain/march_lines-inl.h"
#include "terrain/march_tracks.h"
#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

class TrackLanes : LineLanes {
 public:
  TrackLanes(const Terrain& terrain, MarchLines& lines)
      : LineLanes(lines),
        terrain_(terrain),
        last_column_(of(terrain.layers()[0].grid->columns - 1)),
        last_row_(of(terrain.layers()[0].grid->rows - 1)) {}

  void lay_straight(Fates& fates) {
    const TerrainLayer& layer = terrain_.layers()[0];
    const glm::dmat2 j = *layer.map->linear();
    const glm::dvec2 eye_uv = layer.map->to_grid({0, 0});
    for (std::size_t i = 0; i < lines_.count; i += hn::Lanes(D())) {
      const M slanted = is_slanted(get(lines_.x, i), get(lines_.y, i), get(lines_.slope, i));
      const VectorLine line = put_line(i);
      const V x0 = get(lines_.x0, i);
      const V y0 = get(lines_.y0, i);
      const V u = of(eye_uv.x) + (of(j[0][0]) * x0 + of(j[1][0]) * y0);
      const V v = of(eye_uv.y) + (of(j[0][1]) * x0 + of(j[1][1]) * y0);
      keep(lines_.start_u, i, u);
      keep(lines_.start_v, i, v);
      const LinearRates rates = rates_along(line, j);
      keep(lines_.rate_u, i, rates.u.rate);
      keep(lines_.rate_v, i, rates.v.rate);
      keep(lines_.metres_u, i, rates.u.metres);
      keep(lines_.metres_v, i, rates.v.metres);
      keep(lines_.end, i, hn::Inf(D()));
      const M endless = get(lines_.to, i) == hn::Inf(D());
      const M known = hn::And(hn::And(slanted, endless), is_over_grid(u, v));
      mark(i, ~bits_of(known) & lanes_from(i), March::undecided, fates);
    }
  }

  void lay_lines(Fates& fates) {
    const V reach = of(terrain_.reach_m());
    for (std::size_t i = 0; i < lines_.count; i += hn::Lanes(D())) {
      const M slanted = is_slanted(get(lines_.x, i), get(lines_.y, i), get(lines_.slope, i));
      const VectorLine line = put_line(i);
      const V x0 = get(lines_.x0, i);
      const V y0 = get(lines_.y0, i);
      const V along = x0 * line.x + y0 * line.y;
      const V away2 = x0 * x0 + y0 * y0 - reach * reach;
      const V leaves = hn::Sqrt(along * along - away2) - along;
      const V length = get(lines_.to, i) / hn::Sqrt(of(1) + line.slope * line.slope);
      keep(lines_.to, i, hn::Min(leaves, length));
      const M from_eye = hn::And(x0 == of(0), y0 == of(0));
      // NaN: a line that misses the disc.
      const M has_length = hn::And(leaves > of(0), length > of(0));
      const M known = hn::AndNot(from_eye, hn::And(slanted, has_length));
      mark(i, ~bits_of(known) & lanes_from(i), March::undecided, fates);
    }
  }

  // Pieces whose ends are known.
  void lay_pieces(Fates& fates) {
    for (std::size_t i = 0; i < lines_.count; i += hn::Lanes(D())) {
      const V u = get(lines_.start_u, i);
      const V v = get(lines_.start_v, i);
      const V length = get(lines_.end, i) - get(lines_.begin, i);
      const VectorRate rate_u = invertible((get(lines_.end_u, i) - u) / length);
      const VectorRate rate_v = invertible((get(lines_.end_v, i) - v) / length);
      keep(lines_.rate_u, i, rate_u.rate);
      keep(lines_.rate_v, i, rate_v.rate);
      keep(lines_.metres_u, i, rate_u.metres);
      keep(lines_.metres_v, i, rate_v.metres);
      const M known = hn::And(is_over_grid(u, v), length > of(0));
      mark(i, ~bits_of(known) & lanes_from(i), March::undecided, fates);
    }
  }

  // Where the pieces end on the ground.
  void put_ends(MarchLines::Doubles& x_m, MarchLines::Doubles& y_m) const {
    for (std::size_t i = 0; i < lines_.count; i += hn::Lanes(D())) {
      const V end = get(lines_.end, i);
      keep(x_m, i, get(lines_.x0, i) + get(lines_.x, i) * end);
      keep(y_m, i, get(lines_.y0, i) + get(lines_.y, i) * end);
    }
  }

 private:
  // The line under a direction, from its beginning.
  VEC_INLINE VectorLine put_line(std::size_t first) {
    const VectorLine line =
        line_under(get(lines_.x, first), get(lines_.y, first), get(lines_.slope, first));
    keep(lines_.x, first, line.x);
    keep(lines_.y, first, line.y);
    keep(lines_.slope, first, line.slope);
    keep(lines_.begin, first, of(0));
    return line;
  }

  VEC_INLINE M is_over_grid(V u, V v) const {
    return hn::And(hn::And(u >= of(0), u <= last_column_), hn::And(v >= of(0), v <= last_row_));
  }

  const Terrain& terrain_;
  V last_column_, last_row_;
};

void straight_lines(const Terrain& terrain, MarchLines& lines, Fates& fates) {
  TrackLanes(terrain, lines).lay_straight(fates);
}

void bent_lines(const Terrain& terrain, MarchLines& lines, Fates& fates) {
  TrackLanes(terrain, lines).lay_lines(fates);
}

void bent_pieces(const Terrain& terrain, MarchLines& lines, Fates& fates) {
  TrackLanes(terrain, lines).lay_pieces(fates);
}

void put_ends(const Terrain& terrain, MarchLines& lines, MarchLines::Doubles& x_m,
              MarchLines::Doubles& y_m) {
  TrackLanes(terrain, lines).put_ends(x_m, y_m);
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(straight_lines);
HWY_EXPORT(bent_lines);
HWY_EXPORT(bent_pieces);
HWY_EXPORT(put_ends);

void lay_straight(const Terrain& terrain, MarchLines& lines, Fates& fates) {
  HWY_DYNAMIC_DISPATCH(straight_lines)(terrain, lines, fates);
}

void lay_lines(const Terrain& terrain, MarchLines& lines, Fates& fates) {
  HWY_DYNAMIC_DISPATCH(bent_lines)(terrain, lines, fates);
}

void lay_pieces(const Terrain& terrain, MarchLines& lines, Fates& fates) {
  const GroundMap& map = *terrain.layers()[0].map;
  alignas(64) MarchLines::Doubles x_m;
  alignas(64) MarchLines::Doubles y_m;
  const auto all = [&lines](auto& values) { return std::span(values.data(), lines.count); };
  map.piece_ends_m({all(lines.x0), all(lines.y0), all(lines.x), all(lines.y)},
                   {all(lines.begin), all(lines.to)}, all(lines.end));
  HWY_DYNAMIC_DISPATCH(put_ends)(terrain, lines, x_m, y_m);
  map.places({all(x_m), all(y_m)}, {all(lines.end_u), all(lines.end_v)});
  HWY_DYNAMIC_DISPATCH(bent_pieces)(terrain, lines, fates);
}

}  // namespace terrview
#endif
