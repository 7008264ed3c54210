#include "sky/field_cell.h"

namespace terrview {
namespace {

// The nine vertices of a divided cell, row by row.
using Nine = std::array<float, 9>;

Nine midpoints(const RandomField& field, const CellPlace& at, const std::array<float, 4>& corner) {
  const int level = at.level + 1;
  const std::int64_t column = 2 * at.column;
  const CellDraws south(field, level, 2 * at.row);
  const CellDraws middle(field, level, 2 * at.row + 1);
  const CellDraws north(field, level, 2 * at.row + 2);
  const float s = mean(corner[0], corner[1]) + south.first(column + 1);
  const float n = mean(corner[2], corner[3]) + north.first(column + 1);
  const float w = mean(corner[0], corner[2]) + middle.first(column);
  const float e = mean(corner[1], corner[3]) + middle.first(column + 2);
  const float across = mean(w, e) + middle.first(column + 1);
  const float along = mean(s, n) + middle.second(column + 1);
  return {corner[0], s, corner[1], w, mean(across, along), e, corner[2], n, corner[3]};
}

Nine all_displaced(const RandomField& field, const CellPlace& at,
                   const std::array<float, 4>& corner) {
  Nine nine{corner[0],
            mean(corner[0], corner[1]),
            corner[1],
            mean(corner[0], corner[2]),
            mean(corner[0], corner[1], corner[2], corner[3]),
            mean(corner[1], corner[3]),
            corner[2],
            mean(corner[2], corner[3]),
            corner[3]};
  for (std::size_t j = 0; j < 3; ++j) {
    const CellDraws draws(field, at.level + 1, 2 * at.row + static_cast<std::int64_t>(j));
    for (std::size_t i = 0; i < 3; ++i)
      nine[3 * j + i] += draws.first(2 * at.column + static_cast<std::int64_t>(i));
  }
  return nine;
}

}  // namespace

template <FieldKind kKind>
FieldCell<kKind> FieldCell<kKind>::root(const RandomField& field, const CellPlace& at) {
  return FieldCell({field.root_value(at.column, at.row), field.root_value(at.column + 1, at.row),
                    field.root_value(at.column, at.row + 1),
                    field.root_value(at.column + 1, at.row + 1)});
}

template <FieldKind kKind>
std::array<FieldCell<kKind>, 4> FieldCell<kKind>::divided(const RandomField& field,
                                                          const CellPlace& at) const {
  const Nine nine = kKind == FieldKind::midpoint ? midpoints(field, at, corners_)
                                                 : all_displaced(field, at, corners_);
  const auto cell = [&](std::size_t k) {
    return FieldCell({nine[k], nine[k + 1], nine[k + 3], nine[k + 4]});
  };
  return {cell(0), cell(1), cell(3), cell(4)};
}

template class FieldCell<FieldKind::midpoint>;
template class FieldCell<FieldKind::displaced>;

using SmoothCell = FieldCell<FieldKind::smooth>;

SmoothCell SmoothCell::root(const RandomField& field, const CellPlace& at) {
  SmoothCell cell;
  for (std::size_t k = 0; k < 9; ++k)
    cell.points_[k] = field.root_value(at.column + static_cast<std::int64_t>(k % 3) - 1,
                                       at.row + static_cast<std::int64_t>(k / 3) - 1);
  return cell;
}

std::array<SmoothCell, 4> SmoothCell::divided(const RandomField& field, const CellPlace& at) const {
  // Which of three parents is near a refined point, and which far: of the points 2i - 1 to 2i + 2
  // of a cell i, whose parents are i - 1, i and i + 1.
  constexpr std::array<std::size_t, 4> kNear{0, 1, 1, 2};
  constexpr std::array<std::size_t, 4> kFar{1, 0, 2, 1};
  std::array<float, 12> wide;  // refined along x: three rows of four
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t i = 0; i < 4; ++i)
      wide[4 * row + i] = three_to_one(points_[3 * row + kNear[i]], points_[3 * row + kFar[i]]);
  std::array<float, 16> refined;
  for (std::size_t j = 0; j < 4; ++j) {
    const CellDraws draws(field, at.level + 1, 2 * at.row - 1 + static_cast<std::int64_t>(j));
    for (std::size_t i = 0; i < 4; ++i)
      refined[4 * j + i] = three_to_one(wide[4 * kNear[j] + i], wide[4 * kFar[j] + i]) +
                           draws.first(2 * at.column - 1 + static_cast<std::int64_t>(i));
  }
  std::array<SmoothCell, 4> cells;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t start = 4 * (k >> 1) + (k & 1);
    for (std::size_t p = 0; p < 9; ++p) cells[k].points_[p] = refined[start + 4 * (p / 3) + p % 3];
  }
  return cells;
}

}  // namespace terrview
