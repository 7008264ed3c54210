#include "ingest/dem_info.h"

#include <array>

#include <GeographicLib/Geodesic.hpp>
#include <glm/geometric.hpp>

#include "ingest/dem_crs.h"

namespace terrview {
namespace {

// Places of one DEM's posts.
class PostPlaces {
 public:
  explicit PostPlaces(const Dem& dem) : placement_(dem.placement) {
    if (dem.crs_wkt.empty()) return;
    const double columns = dem.grid->columns - 1;
    const double rows = dem.grid->rows - 1;
    const std::array<glm::dvec2, 5> area{placement_.at({0, 0}), placement_.at({columns, 0}),
                                         placement_.at({0, rows}), placement_.at({columns, rows}),
                                         placement_.at({columns / 2, rows / 2})};
    crs_.emplace(dem.name, dem.crs_wkt, area);
  }

  [[nodiscard]] PostCoordinates at(glm::dvec2 uv) const {
    PostCoordinates place{placement_.at(uv), std::nullopt};
    if (!crs_) return place;
    glm::dvec2 point = place.xy;
    crs_->to_geographic({&point, 1});
    place.geographic = GeoPoint{point.y, point.x};
    return place;
  }

  [[nodiscard]] double distance_m(glm::dvec2 uv, glm::dvec2 other_uv) const {
    const PostCoordinates a = at(uv);
    const PostCoordinates b = at(other_uv);
    if (!a.geographic) return glm::length(b.xy - a.xy);
    double metres = 0;
    GeographicLib::Geodesic::WGS84().Inverse(
        a.geographic->latitude_deg, a.geographic->longitude_deg, b.geographic->latitude_deg,
        b.geographic->longitude_deg, metres);
    return metres;
  }

  [[nodiscard]] const std::optional<CrsTransform>& crs() const { return crs_; }

 private:
  PostPlacement placement_;
  std::optional<CrsTransform> crs_;
};

}  // namespace

DemInfo describe_dem(const Dem& dem) {
  const PostPlaces places(dem);
  const glm::dvec2 last(dem.grid->columns - 1, dem.grid->rows - 1);
  const glm::dvec2 middle = 0.5 * last;
  DemInfo info;
  info.crs_name = crs_name(dem.crs_wkt);
  info.crs_code = crs_code(dem.crs_wkt);
  if (places.crs()) info.operation = places.crs()->operation();
  info.spacing_m = {places.distance_m(middle - glm::dvec2(0.5, 0), middle + glm::dvec2(0.5, 0)),
                    places.distance_m(middle - glm::dvec2(0, 0.5), middle + glm::dvec2(0, 0.5))};
  info.first_post = places.at({0, 0});
  info.last_post = places.at(last);
  info.middle = places.at(middle);
  info.range = height_range(*dem.grid);
  for (const Summit& summit : find_summits(*dem.grid, kListedSummits)) {
    info.summits.push_back({places.at(summit.post), summit.height_m});
  }
  return info;
}

}  // namespace terrview
