#include "render/lines/line_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/geometric.hpp>

namespace terrview {
namespace {

constexpr std::int64_t kOutline = 0;

// A corner of a piece of a square, and the side that leads on from it.
struct Corner {
  glm::dvec2 at_px;
  LinePoint shows;
  std::int64_t side;  // the place of LineNode
};

class Square {
 public:
  using Sides = std::array<std::optional<LineCrossing>, 4>;

  // Corners clockwise from the upper left; sides from each corner to the next.
  Square(std::array<Corner, 4> corners, const Sides& sides, std::int64_t inside)
      : corners_(std::move(corners)), sides_(sides), inside_(inside) {
    for (int side = 0; side < 4; ++side)
      if (sides_[static_cast<std::size_t>(side)]) crossed_.push_back(side);
  }

  void add_outlines(std::vector<LineSegment>& segments) const {
    if (crossed_.size() == 2) join(crossed_[0], crossed_[1], segments);
    if (crossed_.size() == 3) add_junction(segments);
    if (crossed_.size() == 4) add_two(segments);
  }

  // What the outline leaves whole.
  [[nodiscard]] std::vector<std::vector<Corner>> pieces() const {
    // An outline that ends within the square leaves it whole.
    if (crossed_.size() < 2) return {{corners_.begin(), corners_.end()}};
    if (crossed_.size() != 2) return {};
    return {piece(crossed_[0], crossed_[1], 0), piece(crossed_[1], crossed_[0], 1)};
  }

 private:
  [[nodiscard]] const LineCrossing& crossing(int side) const {
    return *sides_[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] const Corner& corner(int index) const {
    return corners_[static_cast<std::size_t>(index % 4)];
  }

  // The corners from behind the crossing of side `from` to that of side `to`.
  [[nodiscard]] std::vector<Corner> piece(int from, int to, std::int64_t number) const {
    std::vector<Corner> result;
    result.push_back({crossing(from).at_px, crossing(from).second, corner(from).side});
    for (int i = from + 1; i % 4 != (to + 1) % 4; ++i) result.push_back(corner(i));
    result.push_back({crossing(to).at_px, crossing(to).first, inside_ + number});
    return result;
  }

  [[nodiscard]] static LineKind kind_of(const LineCrossing& crossing) {
    // Where an object stands on the ground, neither is before the other.
    constexpr double kTouch = 2e-3;
    const double apart_m = std::abs(crossing.first.distance_m - crossing.second.distance_m);
    const bool touch = apart_m < kTouch * crossing.front().distance_m;
    const bool object = std::max(crossing.first.thing, crossing.second.thing) > LinePoint::kGround;
    return object && (touch || crossing.front().thing > LinePoint::kGround) ? LineKind::object
                                                                            : LineKind::silhouette;
  }

  void join(int a, int b, std::vector<LineSegment>& segments) const {
    const bool object =
        kind_of(crossing(a)) == LineKind::object || kind_of(crossing(b)) == LineKind::object;
    segments.push_back({object ? LineKind::object : LineKind::silhouette,
                        {{corner(a).side, kOutline}, {corner(b).side, kOutline}},
                        {crossing(a).at_px, crossing(b).at_px},
                        {crossing(a).front().distance_m, crossing(b).front().distance_m},
                        std::max(crossing(a).gap, crossing(b).gap)});
  }

  // How unlike the outlines through two sides are.
  [[nodiscard]] double unlike(int a, int b) const {
    const LinePoint& one = crossing(a).front();
    const LinePoint& other = crossing(b).front();
    return (one.thing == other.thing ? 0.0 : 10.0) +
           std::abs(std::log(one.distance_m / other.distance_m));
  }

  // One outline ends at another.
  void add_junction(std::vector<LineSegment>& segments) const {
    const int a = crossed_[0];
    const int b = crossed_[1];
    const int c = crossed_[2];
    std::array<int, 3> order{a, b, c};
    if (unlike(a, c) < unlike(a, b) && unlike(a, c) <= unlike(b, c))
      order = {a, c, b};
    else if (unlike(b, c) < unlike(a, b))
      order = {b, c, a};
    join(order[0], order[1], segments);
    const LineCrossing& end = crossing(order[2]);
    segments.push_back({kind_of(end),
                        {{corner(order[2]).side, kOutline}, {inside_, kOutline}},
                        {end.at_px, 0.5 * (crossing(order[0]).at_px + crossing(order[1]).at_px)},
                        {end.front().distance_m, end.front().distance_m},
                        end.gap});
  }

  void add_two(std::vector<LineSegment>& segments) const {
    const double straight = unlike(0, 2) + unlike(1, 3);
    const double first = unlike(0, 1) + unlike(2, 3);
    const double second = unlike(1, 2) + unlike(3, 0);
    const bool crosses = straight < first && straight < second;
    const bool starts_first = first <= second;
    join(0, crosses ? 2 : starts_first ? 1 : 3, segments);
    join(crosses ? 1 : 2, crosses || starts_first ? 3 : 1, segments);
  }

  std::array<Corner, 4> corners_;
  const Sides& sides_;
  std::int64_t inside_;
  std::vector<int> crossed_;
};

bool all_ground(const std::vector<Corner>& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
    return corner.shows.thing == LinePoint::kGround &&
           corner.shows.grid == corners.front().shows.grid;
  });
}

// The lines of one axis of the grid through a piece of a square.
class GridLines {
 public:
  GridLines(const LineTracer& tracer, const GridLineOptions& options,
            const std::vector<Corner>& corners, int axis)
      : options_(options), corners_(corners), axis_(axis), step_(step_of(tracer)) {}

  void add(std::vector<LineSegment>& segments) const {
    double low = value(0);
    double high = low;
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      low = std::min(low, value(i));
      high = std::max(high, value(i));
    }
    if ((high - low) * options_.least_px > step_) return;
    for (double line = std::ceil(low / step_) * step_; line <= high; line += step_)
      add_line(line, segments);
  }

 private:
  [[nodiscard]] double value(std::size_t corner) const {
    return corners_[corner % corners_.size()].shows.uv[axis_];
  }

  [[nodiscard]] double step_of(const LineTracer& tracer) const {
    if (options_.step_posts > 0) return options_.step_posts;
    const LinePoint& ground = corners_.front().shows;
    const double room_px = tracer.post_m(ground.grid) * tracer.px_per_m(ground.distance_m);
    return std::exp2(std::max(0.0, std::ceil(std::log2(options_.spacing_px / room_px))));
  }

  void add_line(double line, std::vector<LineSegment>& segments) const {
    std::optional<LineSegment> open;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const double from = value(i) - line;
      const double to = value(i + 1) - line;
      if ((from < 0) == (to < 0)) continue;
      const double share = from / (from - to);
      const Corner& a = corners_[i];
      const Corner& b = corners_[(i + 1) % corners_.size()];
      const LineNode node{a.side, 1 + axis_ + 2 * static_cast<std::int64_t>(line)};
      const glm::dvec2 at_px = a.at_px + share * (b.at_px - a.at_px);
      const double distance_m =
          a.shows.distance_m + share * (b.shows.distance_m - a.shows.distance_m);
      if (!open) {
        open = LineSegment{LineKind::grid, {node, {}}, {at_px, {}}, {distance_m, 0}, 0};
        continue;
      }
      open->ends[1] = node;
      open->points_px[1] = at_px;
      open->distances_m[1] = distance_m;
      segments.push_back(*open);
      open.reset();
    }
  }

  const GridLineOptions& options_;
  const std::vector<Corner>& corners_;
  int axis_;
  double step_;
};

}  // namespace

glm::dvec2 lattice_px(int column, int row) { return {column - 0.5, row - 0.5}; }

std::vector<LineSegment> row_segments(const LineTracer& tracer, int row,
                                      const std::vector<LinePoint>& upper,
                                      const std::vector<LinePoint>& lower,
                                      const GridLineOptions& options) {
  const int columns = static_cast<int>(upper.size()) - 1;
  // Of each point of the lattice: the side to the right, that downwards, and two inside.
  const auto place = [&](int column, int line, int which) {
    return 4 * (static_cast<std::int64_t>(line) * (columns + 1) + column) + which;
  };
  const auto down = [&](int column) {
    const auto i = static_cast<std::size_t>(column);
    return tracer.crossing(lattice_px(column, row), upper[i], lattice_px(column, row + 1),
                           lower[i]);
  };
  const auto turned = [](std::optional<LineCrossing> crossing) {
    if (crossing) std::swap(crossing->first, crossing->second);
    return crossing;
  };
  const auto across = [&](const std::vector<LinePoint>& points, int column, int line) {
    const auto i = static_cast<std::size_t>(column);
    return tracer.crossing(lattice_px(column, line), points[i], lattice_px(column + 1, line),
                           points[i + 1]);
  };
  std::vector<LineSegment> segments;
  std::optional<LineCrossing> left = down(0);
  for (int column = 0; column < columns; ++column) {
    const auto i = static_cast<std::size_t>(column);
    const std::optional<LineCrossing> right = down(column + 1);
    const Square::Sides sides{across(upper, column, row), right,
                              turned(across(lower, column, row + 1)), turned(left)};
    const Square square(
        {{{lattice_px(column, row), upper[i], place(column, row, 0)},
          {lattice_px(column + 1, row), upper[i + 1], place(column + 1, row, 1)},
          {lattice_px(column + 1, row + 1), lower[i + 1], place(column, row + 1, 0)},
          {lattice_px(column, row + 1), lower[i], place(column, row, 1)}}},
        sides, place(column, row, 2));
    square.add_outlines(segments);
    for (const auto& piece : square.pieces()) {
      if (!all_ground(piece)) continue;
      for (const int axis : {0, 1}) GridLines(tracer, options, piece, axis).add(segments);
    }
    left = right;
  }
  return segments;
}

}  // namespace terrview
