#include "render/reflection.h"

#include <glm/common.hpp>

#include "render/fresnel.h"
#include "render/water.h"

namespace terrview {

void add_reflections(const Scene& scene, const RayWidths& widths, std::span<const Ray> rays,
                     const RayHits& hits, std::span<ShadedRay> shaded, ShadowCounts& counts) {
  std::vector<std::size_t> indices;
  std::vector<Ray> mirrored_rays;
  std::vector<double> before_m;
  std::vector<float> shares;
  RayHits mirrored_hits;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits.meets_water(i)) continue;
    const MirroredRay mirror = mirrored(*scene.terrain, rays[i], *hits.ground[i]);
    indices.push_back(i);
    mirrored_rays.push_back(mirror.ray);
    before_m.push_back(shaded[i].distance_m + (widths.before_m.empty() ? 0 : widths.before_m[i]));
    shares.push_back(static_cast<float>(fresnel_reflectance(mirror.cosine, kWaterIndex)));
    mirrored_hits.ground.push_back(scene.terrain->first_hit(mirror.ray));
  }
  if (indices.empty()) return;
  const Scene& reflected = *scene.water->reflected;
  meet_water(reflected, mirrored_rays, mirrored_hits);
  meet_objects(reflected, mirrored_rays, mirrored_hits, counts.objects);
  const std::vector<ShadedRay> seen = shade(reflected, {widths.pixel, before_m, widths.bounces},
                                            mirrored_rays, mirrored_hits, counts);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    glm::vec3& clear = shaded[indices[k]].clear;
    clear = glm::mix(clear, seen[k].color, shares[k]);
  }
}

}  // namespace terrview
