// The geodesy of one eye: where the view frame stands on the Earth.
//
// Azimuth and distance on the ground of the view frame are those of the geodesic from the eye
// (azimuthal equidistant map of the WGS 84 ellipsoid, GeographicLib: nanometres); heights follow
// terrain/vertical_frame.h. On a flat Earth every DEM is laid by its affine map at the eye. A DEM
// without a CRS is flat: view-frame (x, y) = its (x, y) - eye. So is a frame without a DEM, which
// has no ground.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "ingest/crs_transform.h"
#include "ingest/dem.h"
#include "ingest/exact_ground_map.h"
#include "terrain/terrain.h"

namespace terrview {

enum class EarthModel { curved, flat };

struct ViewFrameOptions {
  EarthModel earth = EarthModel::curved;
  double refraction = 0.13;  // geodetic k
  double z_scale = 1;
  SurfaceModel surface = SurfaceModel::hyperboloid;
  Search search = Search::pyramid;
  bool beyond_sight = false;  // ground that the eye can't see matters too: for a plan
  double above_ground_m = 0;  // what stands so high above the ground is to be seen too
  bool under_ground = false;  // the eye may be under the ground, whence it sees nothing
  int threads = 0;            // 0 = all the processor has
};

// An eye's place: over a geographic point, or over a point of the first DEM's own coordinates. The
// height is absolute in the DEM's heights (before z_scale), or above the ground there.
struct EyePlace {
  std::optional<GeoPoint> geographic;
  std::optional<glm::dvec2> projected;
  double height_m = 0;
  bool above_ground = false;
};

class ViewFrame {
 public:
  // Throws InputError: an eye under the ground (saying by how much), above no ground when the
  // height is above ground, a CRS without a way to WGS 84, a ballpark operation.
  ViewFrame(const std::vector<Dem>& dems, const EyePlace& eye, const ViewFrameOptions& options);
  ~ViewFrame();
  ViewFrame(ViewFrame&&) noexcept;
  ViewFrame& operator=(ViewFrame&&) noexcept;

  // The ground, placed under the eye.
  [[nodiscard]] const std::shared_ptr<const Terrain>& terrain() const;

  // Whether points have a latitude and longitude (some CRS is known).
  [[nodiscard]] bool is_geographic() const;

  // View-frame ground (x, y) of a place, and back. from_ground needs is_geographic().
  [[nodiscard]] glm::dvec2 to_ground(const GeoPoint& point) const;
  [[nodiscard]] glm::dvec2 to_ground_from_projected(glm::dvec2 xy) const;  // first DEM's CRS
  [[nodiscard]] GeoPoint from_ground(glm::dvec2 ground_m) const;
  [[nodiscard]] glm::dvec2 projected_from_ground(glm::dvec2 ground_m) const;

  // True east, north, up at the eye (metres, refraction taken out) of a view-frame point, and back:
  // terrain/view_transform.h with this frame.
  [[nodiscard]] glm::dvec3 to_true_enu(const glm::dvec3& view_m) const;
  [[nodiscard]] glm::dvec3 from_true_enu(const glm::dvec3& enu_m) const;

  // The eye: degrees (or the first DEM's coordinates), DEM height, and the ground's below it.
  struct Eye {
    std::optional<GeoPoint> geographic;
    glm::dvec2 projected;
    double height_m;                 // before z_scale
    std::optional<double> ground_m;  // before z_scale; nullopt = no ground below
  };
  [[nodiscard]] const Eye& eye() const;

  // One for each DEM that has a CRS.
  [[nodiscard]] const std::vector<CrsOperation>& operations() const;

  // What the user should know, a line each: vertical datums that differ.
  [[nodiscard]] const std::vector<std::string>& warnings() const;

  // Bounds of what the frame's approximations add: the tracks' distance from the true curve, and
  // the direction of a post (rad) within the terrain's reach.
  [[nodiscard]] double track_error_cells() const;
  [[nodiscard]] double direction_error_rad() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace terrview
