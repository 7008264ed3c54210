// Promises of sky/field_stream.h.
#include "sky/field_stream.h"

#include <gtest/gtest.h>

#include <vector>

#include "sky/field_part.h"

namespace terrview {
namespace {

RandomField field_of(glm::ivec2 levels) {
  FieldOptions options;
  options.seed = 5;
  options.levels = levels;
  options.h = {0.4};
  return RandomField(options);
}

TEST(FieldStream, GivesEveryCellOnceWithTheValuesOfThePart) {
  for (const glm::ivec2 levels :
       {glm::ivec2(0, 0), glm::ivec2(4, 4), glm::ivec2(4, 7), glm::ivec2(6, 2)}) {
    const RandomField field = field_of(levels);
    const std::int64_t columns = std::int64_t{1} << levels.x;
    const std::int64_t rows = std::int64_t{1} << levels.y;
    const glm::i64vec2 cell(-3, 2);
    const LatticeRectangle whole{cell.x * columns, cell.y * rows, columns + 1, rows + 1};
    const std::vector<float> part = field_part(field, whole);
    std::vector<int> seen(static_cast<std::size_t>(columns * rows));
    const auto expect_vertex = [&](const FieldVertex& vertex) {
      const auto k = static_cast<std::size_t>((vertex.row - whole.row) * whole.columns +
                                              vertex.column - whole.column);
      ASSERT_EQ(vertex.value, part.at(k));
    };
    stream_root_cell(field, cell, [&](const FieldCorners& corners) {
      const FieldVertex& at = corners.south_west;
      ++seen.at(
          static_cast<std::size_t>((at.row - whole.row) * columns + at.column - whole.column));
      EXPECT_EQ(corners.south_east.column, at.column + 1);
      EXPECT_EQ(corners.south_east.row, at.row);
      EXPECT_EQ(corners.north_west.column, at.column);
      EXPECT_EQ(corners.north_west.row, at.row + 1);
      for (const FieldVertex& vertex :
           {at, corners.south_east, corners.north_west, corners.north_east})
        expect_vertex(vertex);
    });
    for (const int times : seen) ASSERT_EQ(times, 1);
  }
}

TEST(FieldStream, KeepsAsManyAliveAsTheThesisSays) {
  for (int n = 3; n <= 12; ++n) {
    std::size_t cells = 0;
    const StreamCounts most =
        stream_root_cell(field_of({n, n}), {0, 0}, [&](const FieldCorners&) { ++cells; });
    EXPECT_EQ(cells, std::size_t{1} << (2 * n));
    const auto levels = static_cast<std::size_t>(n);
    EXPECT_EQ(most.vertices, (std::size_t{2} << levels) + 3 * levels - 1) << n;
    EXPECT_EQ(most.edges, (std::size_t{4} << levels) + 10 * levels - 6) << n;
  }
}

}  // namespace
}  // namespace terrview
