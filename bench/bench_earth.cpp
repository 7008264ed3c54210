#include "bench/bench_earth.h"

#include <cmath>
#include <numbers>

#include "ingest/view_frame.h"

namespace terrview {
namespace {

constexpr double kLatitude_deg = 47;
constexpr double kLongitude_deg = 9;
// Of that place in EPSG:32632.
constexpr glm::dvec2 kUtm_m{500'000, 5'205'200};

// Metres to a degree of longitude and of latitude there.
glm::dvec2 metres_per_degree() {
  constexpr double kRadius_m = 6'378'137;
  constexpr double kFlattening = 1 / 298.257223563;
  constexpr double kSquaredEccentricity = kFlattening * (2 - kFlattening);
  constexpr double kDegree = std::numbers::pi / 180;
  const double sine = std::sin(kLatitude_deg * kDegree);
  const double w2 = 1 - kSquaredEccentricity * sine * sine;
  return kDegree * kRadius_m / std::sqrt(w2) *
         glm::dvec2(std::cos(kLatitude_deg * kDegree), (1 - kSquaredEccentricity) / w2);
}

Dem placed(BenchEarth earth, const BenchDem& bench_dem) {
  Dem dem;
  dem.name = bench_dem.name;
  dem.grid = bench_dem.grid;
  const bool bent = earth == BenchEarth::bent;
  dem.crs_wkt = bent ? "EPSG:4326" : "EPSG:32632";
  const glm::dvec2 unit_m = bent ? metres_per_degree() : glm::dvec2(1);
  dem.placement.step = {bench_dem.step_m[0] / unit_m, bench_dem.step_m[1] / unit_m};
  const glm::dvec2 middle = bent ? glm::dvec2(kLongitude_deg, kLatitude_deg) : kUtm_m;
  dem.placement.origin = middle - dem.placement.step * bench_dem.middle_uv();
  return dem;
}

}  // namespace

std::shared_ptr<const Terrain> terrain_on(BenchEarth earth, const BenchDem& dem,
                                          const BenchView& view, SurfaceModel model,
                                          Search search) {
  if (earth == BenchEarth::flat)
    return std::make_shared<const Terrain>(terrain_of(dem, view, model, search));
  const Dem on_earth = placed(earth, dem);
  const EyePlace eye{.geographic = {},
                     .projected = on_earth.placement.at(view.eye_uv),
                     .height_m = view.eye_m.z,
                     .above_ground = false};
  return ViewFrame({on_earth}, eye, {.surface = model, .search = search}).terrain();
}

}  // namespace terrview
