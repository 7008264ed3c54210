#include <filesystem>
#include <utility>

#include <glm/matrix.hpp>

#include "bench/bench_dem.h"
#include "ingest/dem.h"
#include "ingest/view_frame.h"

namespace terrview {

BenchDem read_bench_dem(const std::string& path) {
  const std::vector<Dem> dems = read_dems({path});
  const Dem& dem = dems[0];
  const glm::dvec2 middle_uv(dem.grid->columns / 2, dem.grid->rows / 2);
  const EyePlace eye{.geographic = {},
                     .projected = dem.placement.at(middle_uv),
                     .height_m = kHighest_m,
                     .above_ground = false};
  const ViewFrame frame(dems, eye, {.earth = EarthModel::flat});
  const glm::dmat2 to_grid = frame.terrain()->layers()[0].map->jacobian({0, 0});
  return make_bench_dem(std::filesystem::path(path).stem(), *dem.grid, glm::inverse(to_grid));
}

}  // namespace terrview
