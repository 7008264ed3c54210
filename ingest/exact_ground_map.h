// The map between the ground of the view frame and the posts of one DEM, point by point.
//
// View-frame (x, y) to latitude and longitude by the azimuthal equidistant map of the WGS 84
// ellipsoid about the eye (GeographicLib: nanometres), on to the DEM's coordinates by PROJ, and to
// posts by its geotransform. A microsecond or two a point; CurvedGroundMap is the fast one.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "ingest/crs_transform.h"
#include "ingest/dem.h"

namespace terrview {

// Degrees only here: the door of the command line and of files.
struct GeoPoint {
  double latitude_deg;  // WGS 84
  double longitude_deg;
};

// Azimuth and distance of the geodesic from `eye`, as a vector to the east and north, and back.
[[nodiscard]] glm::dvec2 ground_from_geographic(GeoPoint eye, GeoPoint point);
[[nodiscard]] GeoPoint geographic_from_ground(GeoPoint eye, glm::dvec2 ground_m);

class ExactGroundMap {
 public:
  ExactGroundMap(GeoPoint eye, std::shared_ptr<const CrsTransform> crs,
                 const PostPlacement& placement);

  // In place, ground (x, y) to posts (u, v), and back. NaN where the CRS has no place for a point.
  // Where x is longitude, u and v are those nearest to near(), of all that differ by full turns.
  void to_grid(std::span<glm::dvec2> points) const;
  void to_ground(std::span<glm::dvec2> points) const;

  [[nodiscard]] glm::dvec2 to_grid(glm::dvec2 ground_m) const;
  [[nodiscard]] glm::dvec2 to_ground(glm::dvec2 uv) const;

  // d(u, v) / d(x, y) by central differences, right to 1e-9 of itself.
  [[nodiscard]] glm::dmat2 jacobian(glm::dvec2 ground_m) const;

  // The name of the DEM.
  [[nodiscard]] const std::string& dem() const { return crs_->operation().dem; }

  // At first the first post.
  void set_near(glm::dvec2 uv) { near_ = uv; }

  // For ground that holds the pole of this latitude (90 or -90): posts of the far side, where
  // longitude starts again, are moved off the grid beyond the pole, so that the map is continuous
  // but for the pole itself. near() becomes the grid's middle. Throws InputError where the grid
  // surrounds the pole and leaves no far side.
  void part_at_pole(double latitude_deg, glm::ivec2 grid_size);

  // The ground of a latitude and longitude.
  [[nodiscard]] glm::dvec2 to_ground(const GeoPoint& point) const {
    return ground_from_geographic(eye_, point);
  }

  // A full turn of longitude, in posts; nullopt where it does not lead back to the same place.
  [[nodiscard]] std::optional<glm::dvec2> turn() const { return turn_; }

 private:
  [[nodiscard]] glm::dvec2 unwrapped(glm::dvec2 uv) const;

  GeoPoint eye_;
  std::shared_ptr<const CrsTransform> crs_;
  PostPlacement placement_;
  glm::dmat2 to_posts_;
  std::optional<glm::dvec2> turn_;
  glm::dvec2 near_{0, 0};
  // The far side begins at this share of a turn from near(); one half = there is none.
  double far_side_ = 0.5;
  glm::dvec2 beyond_pole_{0, 0};
};

}  // namespace terrview
