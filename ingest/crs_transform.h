// From the coordinates of a DEM to WGS 84 and back, by one operation of PROJ.
//
// The operation is chosen once, for the area where the DEM lies: of those that PROJ can carry out
// without a network, the one it ranks first. Ballpark operations (datums taken as equal because
// nothing better is known) are refused. Heights take no part.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include <glm/vec2.hpp>

namespace terrview {

// A coordinate operation between a DEM's CRS and WGS 84, as PROJ chose it.
struct CrsOperation {
  std::string dem;
  std::string name;
  std::optional<double> accuracy_m;  // nullopt = unknown
};

// Safe to share between threads: calls into PROJ take turns.
class CrsTransform {
 public:
  // There and back again. Most operations are exact to nanometres; the worst, datum shifts taken at
  // height 0 and the series of equal-area projections, come back this near.
  static constexpr double kRoundTrip_m = 2e-3;

  // `area` are some points of the DEM, in the coordinates of the CRS. Throws InputError.
  CrsTransform(const std::string& dem, const std::string& crs_wkt,
               std::span<const glm::dvec2> area);
  ~CrsTransform();
  CrsTransform(CrsTransform&&) noexcept;
  CrsTransform& operator=(CrsTransform&&) noexcept;

  // In place, CRS (x, y) to (longitude, latitude) in degrees of WGS 84, and back. x is the east-ish
  // axis whatever the authority's order. NaN where the operation is not defined.
  void to_geographic(std::span<glm::dvec2> points) const;
  void from_geographic(std::span<glm::dvec2> points) const;

  // How much x grows in a full turn of longitude, where x is longitude times a constant (but for a
  // change of datum); nullopt for other projections.
  [[nodiscard]] std::optional<double> turn() const;

  [[nodiscard]] const CrsOperation& operation() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace terrview
