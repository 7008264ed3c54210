#include "sky/field_part.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace terrview {
namespace {

// A rectangle of a level with its values.
struct Part {
  LatticeRectangle at;
  std::vector<float> values;

  explicit Part(const LatticeRectangle& rectangle) : at(rectangle), values(rectangle.size()) {}
  // The row with the lattice's number `row`, from the part's first column on.
  [[nodiscard]] float* row(std::int64_t row_number) {
    return values.data() + (row_number - at.row) * at.columns;
  }
  [[nodiscard]] const float* row(std::int64_t row_number) const {
    return values.data() + (row_number - at.row) * at.columns;
  }
};

// First and last index of a level, as seen along one axis.
struct Span {
  std::int64_t first;
  std::int64_t last;
};

// The coarse vertices, or control points, that make `fine` where the axis is divided. Shifts round
// down, for negative numbers too.
Span parents(const Span& fine, bool divided, FieldKind kind) {
  if (!divided) return fine;
  if (kind == FieldKind::smooth) return {(fine.first - 1) >> 1, (fine.last + 1) >> 1};
  return {fine.first >> 1, (fine.last + 1) >> 1};
}

LatticeRectangle rectangle_of(const Span& columns, const Span& rows) {
  return {columns.first, rows.first, columns.last - columns.first + 1, rows.last - rows.first + 1};
}

struct Divided {
  bool x;
  bool y;
};

Divided divided_at(const RandomField& field, int level) {
  return {level <= field.options().levels.x, level <= field.options().levels.y};
}

// The rectangle of every level, each covering what the next one is made from.
std::vector<LatticeRectangle> rectangles(const RandomField& field, const LatticeRectangle& wanted) {
  const FieldKind kind = field.options().kind;
  Span columns{wanted.column, wanted.column + wanted.columns - 1};
  Span rows{wanted.row, wanted.row + wanted.rows - 1};
  if (kind == FieldKind::smooth) {
    // Control points around the vertices.
    --columns.first;
    --rows.first;
  }
  std::vector<LatticeRectangle> all(static_cast<std::size_t>(field.levels()) + 1);
  for (int level = field.levels();; --level) {
    all[static_cast<std::size_t>(level)] = rectangle_of(columns, rows);
    if (level == 0) return all;
    const Divided divided = divided_at(field, level);
    columns = parents(columns, divided.x, kind);
    rows = parents(rows, divided.y, kind);
  }
}

Part root_part(const RandomField& field, const LatticeRectangle& rectangle) {
  Part part(rectangle);
  for (std::int64_t j = 0; j < rectangle.rows; ++j)
    for (std::int64_t i = 0; i < rectangle.columns; ++i)
      part.row(rectangle.row + j)[i] = field.root_value(rectangle.column + i, rectangle.row + j);
  return part;
}

// One division of a part. Children cover all of the parent's cells, so that a centre finds its four
// mid-edges; cut() then leaves what is wanted.
class Division {
 public:
  Division(const RandomField& field, int level, const Part& parent)
      : random_(field.random()),
        level_(level),
        deviation_(field.deviation(level)),
        divided_(divided_at(field, level)),
        parent_(parent),
        child_({parent.at.column * (divided_.x ? 2 : 1), parent.at.row * (divided_.y ? 2 : 1),
                divided_.x ? 2 * parent.at.columns - 1 : parent.at.columns,
                divided_.y ? 2 * parent.at.rows - 1 : parent.at.rows}) {}

  [[nodiscard]] Part midpoints() {
    for (std::int64_t j = 0; j < parent_.at.rows; ++j) kept_row(j);
    for (std::int64_t j = 0; divided_.y && j + 1 < parent_.at.rows; ++j) middle_row(j);
    return std::move(child_);
  }

  [[nodiscard]] Part displaced() {
    for (std::int64_t j = 0; j < parent_.at.rows; ++j) interpolated_row(j);
    const std::int64_t end = child_.at.row + child_.at.rows;
    for (std::int64_t row = child_.at.row; row < end; ++row) {
      const std::uint64_t key = random_.row_key(level_, row);
      float* values = child_.row(row);
      for (std::int64_t i = 0; i < child_.at.columns; ++i) values[i] += draw(key, i);
    }
    return std::move(child_);
  }

 private:
  [[nodiscard]] std::uint64_t bits(std::uint64_t key, std::int64_t i) const {
    return KeyedRandom::bits(key, child_.at.column + i);
  }
  [[nodiscard]] float draw(std::uint64_t key, std::int64_t i) const {
    return deviation_ * random_.first(bits(key, i));
  }
  [[nodiscard]] std::int64_t child_row(std::int64_t j) const {
    return child_.at.row + j * (divided_.y ? 2 : 1);
  }

  // Row j of the parent: its vertices, and the middles of its horizontal edges.
  void kept_row(std::int64_t j) {
    const float* from = parent_.row(parent_.at.row + j);
    float* to = child_.row(child_row(j));
    const std::int64_t last = parent_.at.columns - 1;
    if (!divided_.x) {
      std::copy(from, from + last + 1, to);
      return;
    }
    const std::uint64_t key = random_.row_key(level_, child_row(j));
    for (std::int64_t i = 0; i < last; ++i) {
      to[2 * i] = from[i];
      to[2 * i + 1] = mean(from[i], from[i + 1]) + draw(key, 2 * i + 1);
    }
    to[2 * last] = from[last];
  }

  // Between rows j and j + 1: the middles of vertical edges, then the centres between them.
  void middle_row(std::int64_t j) {
    const float* south = child_.row(child_row(j));
    const float* north = child_.row(child_row(j) + 2);
    float* to = child_.row(child_row(j) + 1);
    const std::uint64_t key = random_.row_key(level_, child_row(j) + 1);
    const std::int64_t step = divided_.x ? 2 : 1;
    for (std::int64_t i = 0; i < child_.at.columns; i += step)
      to[i] = mean(south[i], north[i]) + draw(key, i);
    for (std::int64_t i = 1; divided_.x && i < child_.at.columns; i += 2) {
      const std::uint64_t two = bits(key, i);
      const float across = mean(to[i - 1], to[i + 1]) + deviation_ * random_.first(two);
      const float along = mean(south[i], north[i]) + deviation_ * random_.second(two);
      to[i] = mean(across, along);
    }
  }

  // Row j and the row between it and j + 1, none of it displaced.
  void interpolated_row(std::int64_t j) {
    const float* from = parent_.row(parent_.at.row + j);
    const float* next = parent_.row(parent_.at.row + std::min(j + 1, parent_.at.rows - 1));
    const bool between = divided_.y && j + 1 < parent_.at.rows;
    const std::int64_t step = divided_.x ? 2 : 1;
    float* to = child_.row(child_row(j));
    float* middle = between ? child_.row(child_row(j) + 1) : nullptr;
    for (std::int64_t i = 0; i < parent_.at.columns; ++i) {
      to[step * i] = from[i];
      if (between) middle[step * i] = mean(from[i], next[i]);
      if (!divided_.x || i + 1 == parent_.at.columns) continue;
      to[2 * i + 1] = mean(from[i], from[i + 1]);
      if (between) middle[2 * i + 1] = mean(from[i], from[i + 1], next[i], next[i + 1]);
    }
  }

  const KeyedRandom& random_;
  int level_;
  float deviation_;
  Divided divided_;
  const Part& parent_;
  Part child_;
};

Part cut(const Part& part, const LatticeRectangle& rectangle) {
  Part smaller(rectangle);
  for (std::int64_t row = rectangle.row; row < rectangle.row + rectangle.rows; ++row) {
    const float* from = part.row(row) + (rectangle.column - part.at.column);
    std::copy(from, from + rectangle.columns, smaller.row(row));
  }
  return smaller;
}

// The parent that a control point lies in, and its neighbour on the other side.
struct NearAndFar {
  std::int64_t near;
  std::int64_t far;
};

NearAndFar near_and_far(std::int64_t index, bool divided) {
  if (!divided) return {index, index};
  return {index >> 1, (index >> 1) + ((index & 1) != 0 ? 1 : -1)};
}

// One square-square division: refined along x, then along y, then displaced.
Part square_square(const RandomField& field, int level, const Part& parent,
                   const LatticeRectangle& rectangle) {
  const Divided divided = divided_at(field, level);
  const float deviation = field.deviation(level);
  Part child(rectangle);
  std::vector<float> near_row(static_cast<std::size_t>(rectangle.columns));
  std::vector<float> far_row = near_row;
  const auto refine = [&](std::int64_t parent_row, std::vector<float>& to) {
    const float* from = parent.row(parent_row) - parent.at.column;
    for (std::int64_t i = 0; i < rectangle.columns; ++i) {
      const NearAndFar at = near_and_far(rectangle.column + i, divided.x);
      to[static_cast<std::size_t>(i)] =
          divided.x ? three_to_one(from[at.near], from[at.far]) : from[at.near];
    }
  };
  for (std::int64_t row = rectangle.row; row < rectangle.row + rectangle.rows; ++row) {
    const NearAndFar at = near_and_far(row, divided.y);
    refine(at.near, near_row);
    refine(at.far, far_row);
    const std::uint64_t key = field.random().row_key(level, row);
    float* to = child.row(row);
    for (std::int64_t i = 0; i < rectangle.columns; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const float value = divided.y ? three_to_one(near_row[k], far_row[k]) : near_row[k];
      to[i] =
          value + deviation * field.random().first(KeyedRandom::bits(key, rectangle.column + i));
    }
  }
  return child;
}

Part divide(const RandomField& field, int level, const Part& parent,
            const LatticeRectangle& rectangle) {
  switch (field.options().kind) {
    case FieldKind::midpoint:
      return cut(Division(field, level, parent).midpoints(), rectangle);
    case FieldKind::displaced:
      return cut(Division(field, level, parent).displaced(), rectangle);
    case FieldKind::smooth:
      break;
  }
  return square_square(field, level, parent, rectangle);
}

// Vertices as means of the control points around them.
std::vector<float> vertices(const Part& points, const LatticeRectangle& rectangle) {
  std::vector<float> values(rectangle.size());
  auto to = values.begin();
  for (std::int64_t j = 0; j < rectangle.rows; ++j) {
    const float* south = points.row(points.at.row + j);
    const float* north = points.row(points.at.row + j + 1);
    for (std::int64_t i = 0; i < rectangle.columns; ++i)
      *to++ = mean(south[i], south[i + 1], north[i], north[i + 1]);
  }
  return values;
}

}  // namespace

std::vector<float> field_part(const RandomField& field, const LatticeRectangle& rectangle) {
  assert(rectangle.columns > 0 && rectangle.rows > 0);
  const std::vector<LatticeRectangle> of_level = rectangles(field, rectangle);
  Part part = root_part(field, of_level[0]);
  for (int level = 1; level <= field.levels(); ++level)
    part = divide(field, level, part, of_level[static_cast<std::size_t>(level)]);
  if (field.options().kind == FieldKind::smooth) return vertices(part, rectangle);
  return std::move(part.values);
}

}  // namespace terrview
