#include "render/view_front.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/parallel.h"
#include "render/pixel_lattice.h"
#include "terrain/square_sectors.h"

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

std::unique_ptr<const EyeFront> view_front(const Terrain& terrain, const Camera& camera,
                                           int threads) {
  if (camera.options().projection == Projection::orthographic || !EyeFront::serves(terrain))
    return nullptr;
  auto front = std::make_unique<const EyeFront>(terrain, options_of(camera));
  // Level views are traced by columns.
  if (threads != 1 && !column_view(camera)) {
    const std::vector<int> groups = groups_in_view(*front, camera);
    parallel_for(static_cast<int>(groups.size()), threads,
                 [&](int i) { front->make(groups[static_cast<std::size_t>(i)]); });
  }
  return front;
}

// Looks at points half a group apart.
std::vector<int> groups_in_view(const EyeFront& front, const Camera& camera) {
  constexpr int kStep_px = static_cast<int>(kWedge_px) * EyeFront::kGroup / 2;
  constexpr int kFewestSteps = 8;
  const glm::ivec2 last_px = camera.options().size_px - 1;
  const glm::ivec2 steps = glm::max(last_px / kStep_px + 1, kFewestSteps);
  std::vector<bool> is_seen(static_cast<std::size_t>(4 * front.wedges_a_side() / EyeFront::kGroup));
  for (int i = 0; i <= steps.y; ++i)
    for (int j = 0; j <= steps.x; ++j) {
      const glm::dvec2 at_px = glm::dvec2(last_px) * glm::dvec2(j, i) / glm::dvec2(steps);
      const glm::dvec2 across(camera.ray(at_px + 0.5).direction);
      if (across == glm::dvec2(0)) continue;
      const int group = sector_of(across, front.wedges_a_side()) / EyeFront::kGroup;
      is_seen[static_cast<std::size_t>(group)] = true;
    }
  std::vector<int> groups;
  for (std::size_t i = 0; i < is_seen.size(); ++i)
    if (is_seen[i]) groups.push_back(static_cast<int>(i));
  return groups;
}

}  // namespace terrview
