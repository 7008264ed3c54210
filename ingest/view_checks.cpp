#include "ingest/view_checks.h"

#include <cmath>
#include <cstdio>

#include <glm/matrix.hpp>

#include "terrain/error.h"

namespace terrview {

std::string in_words(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

void check_request(const std::vector<Dem>& dems, const EyePlace& eye,
                   const ViewFrameOptions& options) {
  if (!(options.z_scale > 0) || !std::isfinite(options.z_scale))
    throw InputError("--z-scale " + in_words("%g", options.z_scale) + ": give a number above 0");
  if (!(std::abs(options.refraction) <= 1))
    throw InputError("--refraction: k lies between -1 and 1 (0.13 by day)");
  for (const Dem& dem : dems) {
    if (dem.crs_wkt.empty() != dems[0].crs_wkt.empty())
      throw InputError("'" + (dem.crs_wkt.empty() ? dem : dems[0]).name +
                       "': no coordinate system, while another DEM has one: give one for all with "
                       "--a-srs EPSG:CODE");
    if (dem.grid->columns < 2 || dem.grid->rows < 2)
      throw InputError("'" + dem.name + "': " + std::to_string(dem.grid->columns) + " x " +
                       std::to_string(dem.grid->rows) +
                       " posts make no ground: give at least 2 x 2");
    const double area = glm::determinant(dem.placement.step);
    if (!std::isfinite(area) || area == 0)
      throw InputError("'" + dem.name + "': its posts lie on a line: check its geotransform");
  }
  if (!std::isfinite(eye.height_m)) throw InputError("the eye's height is not a number");
  if (eye.geographic) {
    if (dems.empty())
      throw InputError("no DEM, so no latitude for the eye: place it with --eye-xy");
    if (dems[0].crs_wkt.empty())
      throw InputError("'" + dems[0].name +
                       "': no coordinate system, so no latitude for the eye: " +
                       "place it with --eye-xy, or give one with --a-srs EPSG:CODE");
    if (!(std::abs(eye.geographic->latitude_deg) <= 90) ||
        !std::isfinite(eye.geographic->longitude_deg))
      throw InputError("the eye's latitude is not within 90 degrees: give LAT,LON in this order");
  } else if (!eye.projected || !std::isfinite(eye.projected->x + eye.projected->y)) {
    throw InputError("no place for the eye: give it with --eye or --eye-xy");
  }
}

std::vector<std::string> datum_warnings(const std::vector<Dem>& dems) {
  std::vector<std::string> warnings;
  const Dem* first = nullptr;
  for (const Dem& dem : dems) {
    if (dem.vertical_datum.empty()) continue;
    if (first == nullptr) first = &dem;
    if (dem.vertical_datum != first->vertical_datum)
      warnings.push_back("'" + dem.name + "' has heights in " + dem.vertical_datum + ", '" +
                         first->name + "' in " + first->vertical_datum +
                         ": they are used as they are");
  }
  return warnings;
}

}  // namespace terrview
