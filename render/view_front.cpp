#include "render/view_front.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "render/pixel_lattice.h"

namespace terrview {
namespace {

// Wedges a pixel wide would cost more than they spare. Of a view that looks down: where its rays
// mostly go, since a pixel spans more azimuth the nearer it is to the nadir.
constexpr double kWedge_px = 6;

// Rays below it meet the ground in the first cell or two whatever is known of it.
constexpr double kSteep = -1;

// The slopes at points of the image all over: for most rays, which is all that counts.
EyeFrontOptions options_of(const Camera& camera) {
  constexpr int kSteps = 32;
  const CameraOptions& options = camera.options();
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  double across = 0;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j) {
      const glm::dvec2 share = glm::dvec2(i, j) / static_cast<double>(kSteps);
      const glm::dvec3 direction = camera.ray(share * glm::dvec2(options.size_px)).direction;
      const double level = glm::length(glm::dvec2(direction));
      const double slope = direction.z / level;
      across += level / glm::length(direction) / ((kSteps + 1) * (kSteps + 1));
      lowest = std::min(lowest, slope);
      highest = std::max(highest, slope);
    }
  return {.wedge_rad = kWedge_px * options.fov_rad / camera.whole_px().x / across,
          .lowest_slope = lowest,
          .highest_slope = highest,
          .looks_at_lines = highest > kSteep && !column_view(camera)};
}

}  // namespace

std::unique_ptr<const EyeFront> view_front(const Terrain& terrain, const Camera& camera) {
  if (camera.options().projection == Projection::orthographic || !EyeFront::serves(terrain))
    return nullptr;
  return std::make_unique<const EyeFront>(terrain, options_of(camera));
}

}  // namespace terrview
