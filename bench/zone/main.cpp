// terrview-zone-bench time DEM X Y HEIGHT OBSERVER THREADS flat|curved [ZONE.tif [plain]]
//   From where on DEM the point X, Y (its coordinates) at HEIGHT above the ground is seen, OBSERVER
//   above it. Prints the seconds of the processor and of the clock, without reading and writing.
// terrview-zone-bench judge DEM X Y HEIGHT OBSERVER ZONE.tif OTHER.tif
//   Where another viewshed on a flat Earth differs, and what brute force says.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "bench/zone/judge.h"
#include "ingest/zone.h"
#include "ingest/zone_file.h"

namespace terrview {
namespace {

using Arguments = std::vector<std::string>;

struct Target {
  Dem dem;
  glm::dvec2 place;
  double height_m;
  double observer_m;
};

Dem read_whole(const std::string& path) {
  DemOptions options;
  options.fill_voids = false;
  const std::vector<Dem> dems = read_dems({path}, options);
  if (dems.size() != 1) throw std::runtime_error(path + ": nothing in it");
  return dems[0];
}

Target target_of(const Arguments& args) {
  return {read_whole(args.at(1)),
          {std::stod(args.at(2)), std::stod(args.at(3))},
          std::stod(args.at(4)),
          std::stod(args.at(5))};
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void time_zone(const Arguments& args) {
  const Target target = target_of(args);
  ZoneOptions options;
  options.observer_m = target.observer_m;
  options.frame.threads = std::stoi(args.at(6));
  options.frame.earth = args.at(7) == "flat" ? EarthModel::flat : EarthModel::curved;
  options.plain = args.size() > 9;
  const EyePlace place{.geographic = {},
                       .projected = target.place,
                       .height_m = target.height_m,
                       .above_ground = true};
  const double wall = wall_seconds();
  const std::clock_t processor = std::clock();
  const Zone zone = visible_zone({target.dem}, {place}, options);
  std::printf("%.3f %.3f\n", static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC,
              wall_seconds() - wall);
  if (args.size() > 8) write_zone(args[8], zone);
}

void judge_other(const Arguments& args) {
  const Target target = target_of(args);
  const HeightGrid& grid = *target.dem.grid;
  const glm::dvec2 uv = target.dem.placement.posts(target.place);
  const float ground_m = grid.at(static_cast<int>(uv.x + 0.5), static_cast<int>(uv.y + 0.5));
  const Judgement found =
      judge({grid, glm::round(uv), ground_m + target.height_m, target.observer_m},
            *read_whole(args.at(6)).grid, *read_whole(args.at(7)).grid);
  const auto percent = [](std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  };
  std::printf(
      "differs in %.3f %% of %zu posts, %.0f %% of these shown by it alone; of %zu judged, brute "
      "force sides with the zone in %.2f %% (edges) and %.2f %% (bilinear); half pass the ground "
      "within %.2f m\n",
      percent(found.differ, found.posts), found.posts, percent(found.other_shows, found.differ),
      found.judged, percent(found.zone_edges, found.judged),
      percent(found.zone_bilinear, found.judged), found.median_m);
}

}  // namespace
}  // namespace terrview

int main(int argc, char** argv) try {
  const std::vector<std::string> args(argv + 1, argv + argc);
  if (!args.empty() && args[0] == "judge") {
    terrview::judge_other(args);
  } else {
    terrview::time_zone(args);
  }
} catch (const std::exception& error) {
  std::cerr << "terrview-zone-bench: " << error.what() << '\n';
  return 1;
}
