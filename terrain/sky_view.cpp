#include "terrain/sky_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace terrview {
namespace {

constexpr int kLinesAtOnce = 64;

HeightGrid transpose(const HeightGrid& grid) {
  HeightGrid turned{grid.rows, grid.columns, std::vector<float>(grid.heights_m.size())};
  constexpr int kTile = 32;
  for (int row = 0; row < grid.rows; row += kTile) {
    for (int column = 0; column < grid.columns; ++column) {
      for (int r = row; r < std::min(row + kTile, grid.rows); ++r)
        turned.heights_m[static_cast<std::size_t>(column) * static_cast<std::size_t>(grid.rows) +
                         static_cast<std::size_t>(r)] = grid.at(column, r);
    }
  }
  return turned;
}

// pi / 2 - h - sin h cos h for the horizon h = atan(slope), slope >= 0, to 2e-5 (C. Hastings,
// Approximations for Digital Computers, 1955, for the arctangent).
float tilted_light(float slope) {
  const bool steep = slope > 1;
  const float x = steep ? 1 / slope : slope;
  const float x2 = x * x;
  const float atan_x =
      x *
      (0.9998660F + x2 * (-0.3302995F + x2 * (0.1801410F + x2 * (-0.0851330F + x2 * 0.0208351F))));
  constexpr auto kQuarter = static_cast<float>(std::numbers::pi / 2);
  return (steep ? atan_x : kQuarter - atan_x) - slope / (1 + slope * slope);
}

// The points of a line that may be seen from the point where the sweep stands, the nearest last.
class Hull {
 public:
  explicit Hull(int forward) : forward_(forward) {}

  void clear() { points_.clear(); }

  // The steepest of the slopes, metres a column, from a place at `column` up to the points; 0 where
  // none rises.
  [[nodiscard]] float steepest(int column, float height_m) const {
    if (points_.empty()) return 0;
    float steepest = slope(points_.back(), column, height_m);
    for (std::size_t i = points_.size() - 1; i-- > 0;) {
      const float next = slope(points_[i], column, height_m);
      if (next <= steepest) break;
      steepest = next;
    }
    return std::max(steepest, 0.0F);
  }

  void add(int column, float height_m) {
    while (points_.size() >= 2 && slope(points_.back(), column, height_m) <=
                                      slope(points_[points_.size() - 2], column, height_m))
      points_.pop_back();
    points_.push_back({column, height_m});
  }

 private:
  struct Point {
    int column;
    float height_m;
  };

  [[nodiscard]] float slope(const Point& point, int column, float height_m) const {
    return (point.height_m - height_m) / static_cast<float>(forward_ * (point.column - column));
  }

  int forward_;
  std::vector<Point> points_;
};

}  // namespace

// The lines of one part.
class SkyViewSweep::LineSweep {
 public:
  LineSweep(const HeightGrid& grid, const Azimuth& azimuth)
      : grid_(grid),
        azimuth_(azimuth),
        hull_(azimuth.forward),
        above_(static_cast<std::size_t>(grid.columns)),
        below_(above_.size()) {}

  // The horizons of the posts beside the line: of those above it (of greater row, or on it) and
  // those below, as their heights see the line's hull.
  void sweep(int line) {
    hull_.clear();
    const int first = azimuth_.forward > 0 ? grid_.columns - 1 : 0;
    for (int i = 0; i < grid_.columns; ++i) {
      const int column = first - azimuth_.forward * i;
      const double place = line + azimuth_.drift * column;
      if (place <= -1 || place >= grid_.rows) continue;
      const int row = static_cast<int>(std::floor(place));
      const auto share = static_cast<float>(place - row);
      const float low = height(column, row);
      const float high = share > 0 ? height(column, row + 1) : low;
      const auto c = static_cast<std::size_t>(column);
      above_[c] = hull_.steepest(column, high);
      below_[c] = hull_.steepest(column, low);
      const float height_m = low + share * (high - low);
      if (!std::isnan(height_m)) hull_.add(column, height_m);
    }
  }

  [[nodiscard]] std::vector<float>& above() { return above_; }
  [[nodiscard]] const std::vector<float>& below() const { return below_; }

 private:
  [[nodiscard]] float height(int column, int row) const {
    return row < 0 || row >= grid_.rows ? std::nanf("") : grid_.at(column, row);
  }

  const HeightGrid& grid_;
  const Azimuth& azimuth_;
  Hull hull_;
  std::vector<float> above_;
  std::vector<float> below_;
};

float SkyView::at(glm::dvec2 uv) const {
  const glm::ivec2 cell(std::clamp(static_cast<int>(uv.x), 0, columns - 2),
                        std::clamp(static_cast<int>(uv.y), 0, rows - 2));
  const glm::vec2 f = glm::clamp(glm::vec2(uv - glm::dvec2(cell)), glm::vec2(0), glm::vec2(1));
  const float* north = shares.data() + static_cast<std::ptrdiff_t>(cell.y) * columns + cell.x;
  const float* south = north + columns;
  return glm::mix(glm::mix(north[0], north[1], f.x), glm::mix(south[0], south[1], f.x), f.y);
}

SkyViewSweep::SkyViewSweep(const HeightGrid& grid, const glm::dmat2& jacobian, double z_scale,
                           int azimuths)
    : grid_(grid),
      jacobian_(jacobian),
      z_scale_(z_scale),
      transposed_(transpose(grid)),
      sums_(grid.heights_m.size()),
      transposed_sums_(grid.heights_m.size()) {
  for (int i = 0; i < azimuths; ++i) {
    const double azimuth_rad = 2 * std::numbers::pi * (i + 0.5) / azimuths;
    const glm::dvec2 towards(std::sin(azimuth_rad), std::cos(azimuth_rad));
    const glm::dvec2 posts = jacobian * towards;  // a metre of the azimuth
    const bool turned = std::abs(posts.y) > std::abs(posts.x);
    const double along = turned ? posts.y : posts.x;
    const double across = turned ? posts.x : posts.y;
    azimuths_.push_back({towards, turned, along > 0 ? 1 : -1, across / along, 1 / std::abs(along)});
  }
}

int SkyViewSweep::first_line(const Azimuth& azimuth) const {
  const double end = azimuth.drift * (grid_of(azimuth).columns - 1);
  return static_cast<int>(std::floor(-std::max(0.0, end)));
}

int SkyViewSweep::last_line(const Azimuth& azimuth) const {
  const double end = azimuth.drift * (grid_of(azimuth).columns - 1);
  return static_cast<int>(std::ceil(grid_of(azimuth).rows - 1 - std::min(0.0, end)));
}

int SkyViewSweep::parts(int step) const {
  const Azimuth& azimuth = azimuths_[static_cast<std::size_t>(step)];
  const int lines = last_line(azimuth) - first_line(azimuth) + 1;
  return (lines + kLinesAtOnce - 1) / kLinesAtOnce;
}

void SkyViewSweep::sweep(int step, int part) {
  const Azimuth& azimuth = azimuths_[static_cast<std::size_t>(step)];
  const HeightGrid& grid = grid_of(azimuth);
  std::vector<SkySum>& sums = azimuth.transposed ? transposed_sums_ : sums_;
  const auto to_slope = static_cast<float>(z_scale_ / azimuth.step_m);
  const int first = first_line(azimuth) + part * kLinesAtOnce;
  const int end = std::min(first + kLinesAtOnce, last_line(azimuth) + 1);
  LineSweep lines(grid, azimuth);
  lines.sweep(first);
  std::vector<float> above;
  for (int line = first; line < end; ++line) {
    above.swap(lines.above());
    lines.above().resize(above.size());
    lines.sweep(line + 1);
    for (int column = 0; column < grid.columns; ++column) {
      // The one post of the column that lies between the lines, or on the first.
      const double place = line + azimuth.drift * column;
      const double row = std::ceil(place);
      if (row < 0 || row >= grid.rows) continue;
      const auto c = static_cast<std::size_t>(column);
      const auto share = static_cast<float>(row - place);
      const float slope =
          to_slope * (share > 0 ? above[c] + share * (lines.below()[c] - above[c]) : above[c]);
      SkySum& sum =
          sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + c];
      sum.level += 1 / (1 + slope * slope);
      sum.tilt += tilted_light(slope) * azimuth.towards;
    }
  }
}

SkyView SkyViewSweep::result() const {
  SkyView view{grid_.columns, grid_.rows, {}};
  view.shares.reserve(sums_.size());
  const auto height = [&](int column, int row, float otherwise) {
    const float found =
        grid_.at(std::clamp(column, 0, grid_.columns - 1), std::clamp(row, 0, grid_.rows - 1));
    return std::isnan(found) ? otherwise : found;
  };
  const auto count = static_cast<float>(azimuths_.size());
  for (int row = 0; row < grid_.rows; ++row) {
    for (int column = 0; column < grid_.columns; ++column) {
      const SkySum& sum = sums_[view.shares.size()];
      const SkySum& turned =
          transposed_sums_[static_cast<std::size_t>(column) * static_cast<std::size_t>(grid_.rows) +
                           static_cast<std::size_t>(row)];
      const float here = grid_.at(column, row);
      if (std::isnan(here)) {
        view.shares.push_back(1);
        continue;
      }
      const glm::dvec2 slope_m((height(column + 1, row, here) - height(column - 1, row, here)) / 2,
                               (height(column, row + 1, here) - height(column, row - 1, here)) / 2);
      const glm::dvec2 gradient = z_scale_ * (glm::transpose(jacobian_) * slope_m);
      const glm::vec3 normal(glm::normalize(glm::dvec3(-gradient.x, -gradient.y, 1)));
      const float light = normal.z * (sum.level + turned.level) +
                          glm::dot(glm::vec2(normal), sum.tilt + turned.tilt);
      view.shares.push_back(std::clamp(light / count, 0.0F, 1.0F));
    }
  }
  return view;
}

}  // namespace terrview
