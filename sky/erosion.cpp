#include "sky/erosion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>

namespace terrview {
namespace {

struct Post {
  std::size_t column;
  std::size_t row;
};

struct Stream {
  Post post;
  std::size_t next;  // index of the stream it flows into; its own index on the border
};

// Every post, each after the one it flows into.
std::vector<Stream> streams_upwards(const HeightRows& relief) {
  const std::size_t rows = relief.size();
  const std::size_t columns = relief[0].size();
  std::vector<std::vector<bool>> reached(rows, std::vector<bool>(columns, false));
  using Flooded = std::tuple<double, std::size_t, std::size_t, std::size_t>;  // level, post, next
  std::priority_queue<Flooded, std::vector<Flooded>, std::greater<>> shore;
  const std::size_t outside = rows * columns;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      if (row == 0 || column == 0 || row + 1 == rows || column + 1 == columns) {
        shore.emplace(relief[row][column], row, column, outside);
        reached[row][column] = true;
      }
  std::vector<Stream> streams;
  while (!shore.empty()) {
    const auto [level, row, column, next] = shore.top();
    shore.pop();
    const std::size_t index = streams.size();
    streams.push_back({{column, row}, next == outside ? index : next});
    for (std::size_t r = row - (row > 0); r <= row + 1 && r < rows; ++r)
      for (std::size_t c = column - (column > 0); c <= column + 1 && c < columns; ++c)
        if (!reached[r][c]) {
          shore.emplace(std::max(level, relief[r][c]), r, c, index);
          reached[r][c] = true;
        }
  }
  return streams;
}

std::vector<double> drained_posts(const std::vector<Stream>& streams) {
  std::vector<double> drained(streams.size(), 1);
  for (std::size_t i = streams.size(); i-- > 0;)
    if (streams[i].next != i) drained[streams[i].next] += drained[i];
  return drained;
}

void creep(HeightRows& relief, double share) {
  const HeightRows before_m = relief;
  for (std::size_t row = 1; row + 1 < relief.size(); ++row)
    for (std::size_t column = 1; column + 1 < relief[row].size(); ++column) {
      const double mean_m = (before_m[row - 1][column] + before_m[row + 1][column] +
                             before_m[row][column - 1] + before_m[row][column + 1]) /
                            4;
      relief[row][column] += share * (mean_m - before_m[row][column]);
    }
}

}  // namespace

void erode(HeightRows& relief, const ErosionOptions& options) {
  for (int step = 0; step < options.steps; ++step) {
    const std::vector<Stream> streams = streams_upwards(relief);
    const std::vector<double> drained = drained_posts(streams);
    for (std::size_t i = 0; i < streams.size(); ++i) {
      const Post& below = streams[streams[i].next].post;
      double& height_m = relief[streams[i].post.row][streams[i].post.column];
      const double cut = options.incision * std::sqrt(drained[i]);
      height_m = (height_m + cut * relief[below.row][below.column]) / (1 + cut);
    }
    creep(relief, options.creep);
    if (options.progress) options.progress((step + 1.0) / options.steps);
  }
}

}  // namespace terrview
