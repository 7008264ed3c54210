#include "bench/objects/object_contender.h"

#include <ctime>
#include <utility>

namespace terrview {

double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

ObjectContender set_contender(const std::string& name, std::shared_ptr<const ObjectSet> set,
                              double build_s, double bytes) {
  const auto first_hits = [set](std::span<const Ray> rays, std::span<Found> found) {
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (const auto hit = set->first_hit(rays[i]))
        found[i] = {hit->surface.distance_m, hit->object};
  };
  const auto stops = [set](std::span<const Ray> rays, std::span<std::uint8_t> stopped) {
    for (std::size_t i = 0; i < rays.size(); ++i) stopped[i] = set->stops(rays[i]) ? 1 : 0;
  };
  return {name, build_s, bytes, first_hits, stops, std::move(set)};
}

}  // namespace terrview
