#include "ingest/frame_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <GeographicLib/LocalCartesian.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/view_transform.h"

namespace terrview {
namespace {

constexpr int kDirections = 32;
constexpr int kSamplesPerLine = 64;

class TrackMeasure {
 public:
  TrackMeasure(const LaidGrid& laid, const HeightGrid& grid) : laid_(laid), grid_(grid) {}

  void measure(const GroundLine& line, double length_m) {
    double from_m = 0;
    while (from_m < length_m && off_grid_pieces_ < kSamplesPerLine) {
      const double to_m = laid_.map->piece_end_m(line, from_m, length_m);
      measure_piece(line, from_m, to_m, length_m);
      from_m = to_m;
    }
    off_grid_pieces_ = 0;
  }

  [[nodiscard]] const FrameErrors& worst() const { return worst_; }

 private:
  void measure_piece(const GroundLine& line, double from_m, double to_m, double length_m) {
    const double share_of_line = (to_m - from_m) / length_m;
    const int samples = std::max(3, static_cast<int>(kSamplesPerLine * share_of_line));
    const glm::dvec2 start = laid_.map->to_grid(line.at(from_m));
    const glm::dvec2 end = laid_.map->to_grid(line.at(to_m));
    std::vector<glm::dvec2> exact;
    for (int i = 1; i <= samples; ++i)
      exact.push_back(line.at(glm::mix(from_m, to_m, i / (samples + 1.0))));
    laid_.exact.to_grid(exact);
    bool on_grid = false;
    for (int i = 1; i <= samples; ++i) {
      const glm::dvec2 uv = exact[static_cast<std::size_t>(i - 1)];
      if (!grid_.covers(uv)) continue;
      on_grid = true;
      const double share = i / (samples + 1.0);
      add(line.at(glm::mix(from_m, to_m, share)), glm::mix(start, end, share) - uv);
    }
    if (!on_grid) ++off_grid_pieces_;
  }

  void add(glm::dvec2 ground_m, glm::dvec2 error_cells) {
    const glm::dmat2 to_ground = glm::inverse(laid_.map->jacobian(ground_m));
    const double cell_m = std::min(glm::length(to_ground[0]), glm::length(to_ground[1]));
    const double away_m = std::max(glm::length(ground_m), cell_m);
    worst_.track_cells = std::max(worst_.track_cells, glm::length(error_cells));
    worst_.direction_rad =
        std::max(worst_.direction_rad, glm::length(to_ground * error_cells) / away_m);
  }

  const LaidGrid& laid_;
  const HeightGrid& grid_;
  FrameErrors worst_;
  int off_grid_pieces_ = 0;
};

// The largest angle between where posts are drawn and where they are.
double measure_posts(const LaidGrid& laid, const HeightGrid& grid, const GeoPoint& eye,
                     const VerticalFrame& frame, double sight_m) {
  constexpr int kDivisions = 16;
  const GeographicLib::LocalCartesian enu_at_eye(eye.latitude_deg, eye.longitude_deg,
                                                 frame.eye_height_m);
  double worst = 0;
  for (int i = 0; i <= kDivisions; ++i) {
    for (int j = 0; j <= kDivisions; ++j) {
      const int column = i * (grid.columns - 1) / kDivisions;
      const int row = j * (grid.rows - 1) / kDivisions;
      const double height_m = frame.z_scale * grid.at(column, row);
      const glm::dvec2 ground_m = laid.exact.to_ground(glm::dvec2(column, row));
      if (!(glm::length(ground_m) <= sight_m) || std::isnan(height_m)) continue;
      const GeoPoint place = geographic_from_ground(eye, ground_m);
      glm::dvec3 truth;
      enu_at_eye.Forward(place.latitude_deg, place.longitude_deg, height_m, truth.x, truth.y,
                         truth.z);
      const glm::dvec3 drawn = to_true_enu(frame, {ground_m, frame.at(ground_m).z_m(height_m)});
      const double size = glm::length(truth) * glm::length(drawn);
      if (size > 0) worst = std::max(worst, glm::length(glm::cross(truth, drawn)) / size);
    }
  }
  return worst;
}

}  // namespace

FrameErrors measure_errors(const LaidGrid& laid, const HeightGrid& grid, const GeoPoint& eye,
                           const VerticalFrame& frame, double sight_m) {
  TrackMeasure tracks(laid, grid);
  for (int i = 0; i < kDirections; ++i) {
    const double azimuth = 2 * std::numbers::pi * (i + 0.25) / kDirections;
    tracks.measure({{0, 0}, {std::sin(azimuth), std::cos(azimuth)}},
                   std::min(laid.map->reach_m(), sight_m));
  }
  FrameErrors errors = tracks.worst();
  errors.direction_rad += measure_posts(laid, grid, eye, frame, sight_m);
  return errors;
}

}  // namespace terrview
