#include "ingest/visible_window.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace terrview {
namespace {

constexpr int kSteps = 64;  // of each side of the outline
// Between two points of the outline its image bulges by less than this share of the window.
constexpr double kBulge = 0.02;
constexpr int kMargin_posts = kFilledVoid_posts + 3;
constexpr double kPolarLatitude_deg = 85;

PostWindow whole(const DemHeader& header) { return {0, 0, header.columns, header.rows}; }

// The outline of a grid, in posts.
std::vector<glm::dvec2> rim_of(const DemHeader& header) {
  const glm::dvec2 last(header.columns - 1, header.rows - 1);
  std::vector<glm::dvec2> rim;
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    for (const double side : {0.0, 1.0}) {
      rim.push_back(last * glm::dvec2(share, side));
      rim.push_back(last * glm::dvec2(side, share));
    }
  }
  return rim;
}

// Ground points whose convex hull holds all that is seen.
std::vector<glm::dvec2> outline_of(const ViewSector& sector, double reach_m) {
  const double half_width = std::min(sector.half_width_rad, std::numbers::pi);
  // Chords of the arc cut it short by this factor.
  const double arc_m = reach_m / std::cos(half_width / kSteps);
  std::vector<glm::dvec2> outline;
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const double azimuth = sector.heading_rad + half_width * (2 * share - 1);
    outline.push_back(arc_m * glm::dvec2(std::sin(azimuth), std::cos(azimuth)));
    for (const double side : {-1.0, 1.0}) {
      const double edge = sector.heading_rad + side * half_width;
      outline.push_back(share * arc_m * glm::dvec2(std::sin(edge), std::cos(edge)));
    }
  }
  return outline;
}

// The same, and all that throws shadows on it.
std::vector<glm::dvec2> with_shadows(std::vector<glm::dvec2> outline, const ViewSector& sector) {
  const glm::dvec2 towards_sun(std::sin(sector.sun_azimuth_rad), std::cos(sector.sun_azimuth_rad));
  const std::size_t seen = outline.size();
  for (std::size_t i = 0; i < seen && sector.shadow_m > 0; ++i)
    outline.push_back(outline[i] + sector.shadow_m * towards_sun);
  return outline;
}

struct Box {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};
};

// nullopt where a point has no place.
std::optional<Box> box_of(const std::vector<glm::dvec2>& points) {
  Box box;
  for (const glm::dvec2& point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) return std::nullopt;
    box.low = glm::min(box.low, point);
    box.high = glm::max(box.high, point);
  }
  return box;
}

PostWindow clipped(const DemHeader& header, const Box& box) {
  const glm::dvec2 margin = kBulge * (box.high - box.low) + static_cast<double>(kMargin_posts);
  const glm::dvec2 last(header.columns - 1, header.rows - 1);
  const glm::dvec2 low = glm::clamp(glm::floor(box.low - margin), glm::dvec2(0), last);
  const glm::dvec2 high = glm::clamp(glm::ceil(box.high + margin), glm::dvec2(0), last);
  if (high.x <= low.x || high.y <= low.y) return whole(header);
  return {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x - low.x) + 1,
          static_cast<int>(high.y - low.y) + 1};
}

}  // namespace

PostWindow visible_window(const DemHeader& header, const ViewSector& sector) {
  if (header.crs_wkt.empty()) return whole(header);
  std::vector<glm::dvec2> rim = rim_of(header);
  std::vector<glm::dvec2> area;
  for (const glm::dvec2& uv : rim) area.push_back(header.placement.at(uv));
  const auto crs = std::make_shared<const CrsTransform>(header.name, header.crs_wkt, area);
  ExactGroundMap map(sector.eye, crs, header.placement);
  map.set_near(glm::dvec2(header.columns, header.rows) / 2.0);

  map.to_ground(rim);
  double farthest_m = 0;
  for (const glm::dvec2& point : rim) farthest_m = std::max(farthest_m, glm::length(point));
  const double reach_m = std::min(sector.reach_m, farthest_m);
  constexpr double kMetresPerDegree = 111'000;
  const bool near_pole =
      std::abs(sector.eye.latitude_deg) + (reach_m + sector.shadow_m) / kMetresPerDegree >
      kPolarLatitude_deg;
  if (!std::isfinite(farthest_m) || (header.geographic && near_pole)) return whole(header);

  std::vector<glm::dvec2> outline = with_shadows(outline_of(sector, reach_m), sector);
  map.to_grid(outline);
  const std::optional<Box> box = box_of(outline);
  return box ? clipped(header, *box) : whole(header);
}

}  // namespace terrview
