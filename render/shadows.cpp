#include "render/shadows.h"

namespace terrview {

std::vector<std::uint8_t> stopped(const Terrain& terrain, std::span<const Ray> rays) {
  std::vector<std::uint8_t> stops;
  stops.reserve(rays.size());
  for (const Ray& ray : rays) stops.push_back(terrain.occluded(ray) ? 1 : 0);
  return stops;
}

}  // namespace terrview
