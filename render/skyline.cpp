#include "render/skyline.h"

#include <algorithm>

#include "render/objects/scene_objects.h"
#include "render/parallel.h"

namespace terrview {
namespace {

constexpr int kStep_px = 4;

bool shows_something(const Scene& scene, const Camera& camera, glm::ivec2 pixel) {
  const Ray ray = camera.ray(glm::dvec2(pixel) + 0.5);
  return scene.terrain->occluded(ray) || (scene.objects && scene.objects->set->stops(ray));
}

}  // namespace

std::vector<int> skyline_rows(const Scene& scene, const Camera& camera, int threads) {
  const glm::ivec2 size = camera.options().size_px;
  std::vector<int> traced(static_cast<std::size_t>((size.x - 1) / kStep_px + 2), size.y);
  parallel_for(static_cast<int>(traced.size()), threads, [&](int i) {
    int& row = traced[static_cast<std::size_t>(i)];
    const int column = std::min(i * kStep_px, size.x - 1);
    for (row = 0; row < size.y && !shows_something(scene, camera, {column, row}); row += kStep_px) {
    }
    row = row < size.y ? std::max(0, row - kStep_px + 1) : size.y;
  });
  std::vector<int> rows;
  rows.reserve(static_cast<std::size_t>(size.x));
  for (int column = 0; column < size.x; ++column) {
    const auto before = static_cast<std::size_t>(column / kStep_px);
    rows.push_back(std::min(traced[before], traced[before + 1]));
  }
  return rows;
}

}  // namespace terrview
