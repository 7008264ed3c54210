// terrview-zone-bench DEM X Y HEIGHT OBSERVER THREADS [OUT.tif [plain]]: from where on DEM the
// point X, Y (its coordinates) at HEIGHT over the ground is seen, OBSERVER over it. Prints
// processor and wall-clock seconds without reading and writing.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "ingest/zone.h"
#include "ingest/zone_file.h"
#include "render/post_sight.h"

namespace {

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

int main(int argc, char** argv) try {
  using namespace terrview;
  const std::vector<std::string> args(argv + 1, argv + argc);
  if (args.size() < 6) {
    std::cerr << "usage: terrview-zone-bench DEM X Y HEIGHT OBSERVER THREADS [OUT.tif [plain]]\n";
    return 1;
  }
  const std::vector<Dem> dems = read_dems({args[0]});
  const EyePlace target{.geographic = {},
                        .projected = glm::dvec2(std::stod(args[1]), std::stod(args[2])),
                        .height_m = std::stod(args[3]),
                        .above_ground = true};
  ZoneOptions options;
  options.observer_m = std::stod(args[4]);
  options.frame.threads = std::stoi(args[5]);
  options.plain = args.size() > 7;
  const double wall = wall_seconds();
  const double processor = processor_seconds();
  const Zone zone = visible_zone(dems, {target}, options);
  std::printf("%.3f %.3f\n", processor_seconds() - processor, wall_seconds() - wall);
  if (args.size() > 6) write_zone(args[6], zone);
} catch (const std::exception& error) {
  std::cerr << "terrview-zone-bench: " << error.what() << '\n';
  return 1;
}
