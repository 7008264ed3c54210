#include "render/shade.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/shadows.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

// How much the colour about the sun shows towards `direction`, of unit length: all of it at the
// sun.
double sunward_share(const glm::dvec3& direction, const Light& light) {
  const double half = (1 + glm::dot(direction, light.towards_sun)) / 2;
  return half * half * half * half;
}

glm::vec3 sky_color(const Scene& scene, const glm::dvec3& direction) {
  const glm::dvec3 unit = glm::normalize(direction);
  const SkyGradient& sky = scene.sky;
  glm::vec3 horizon = sky.horizon;
  if (sky.sunward)
    horizon = glm::mix(horizon, *sky.sunward, static_cast<float>(sunward_share(unit, scene.light)));
  // Steep at the horizon, as the air's depth is, but without an edge.
  const double below = 1 - std::max(0.0, unit.z);
  return glm::mix(sky.zenith, horizon, static_cast<float>(below * below * below));
}

glm::vec3 normal_at(const Scene& scene, const Hit& hit) {
  return scene.normals == NormalKind::facet ? scene.terrain->facet_normal(hit)
                                            : scene.terrain->smooth_normal(hit);
}

glm::vec3 ground_color(const Scene& scene, const Hit& hit) {
  const VerticalFrame& frame = scene.terrain->frame();
  const double height_m =
      frame.at(glm::dvec2(hit.position_m)).scene_height_m(hit.position_m.z) / frame.z_scale;
  return scene.tints.at(height_m);
}

// N . L at each hit, 0 where the ground turns away from the sun, or the sun is below the local
// horizon.
std::vector<float> facings(const Scene& scene, std::span<const std::optional<Hit>> hits,
                           std::span<ShadedRay> shaded) {
  std::vector<float> facings(hits.size(), 0);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!hits[i]) continue;
    shaded[i].normal = normal_at(scene, *hits[i]);
    const glm::dvec3 to_sun =
        local_direction(scene.terrain->frame(), hits[i]->position_m, scene.light.towards_sun);
    const double facing = glm::dot(glm::dvec3(shaded[i].normal), to_sun);
    if (to_sun.z > 0 && facing > 0) facings[i] = static_cast<float>(facing);
  }
  return facings;
}

// Takes from the facings what the ground hides of the sun.
void cast_shadows(const Scene& scene, std::span<const std::optional<Hit>> hits,
                  std::span<float> facings, std::int64_t& shadow_rays) {
  std::vector<std::size_t> indices;
  std::vector<Hit> points;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (facings[i] <= 0) continue;
    indices.push_back(i);
    points.push_back(*hits[i]);
  }
  const std::vector<float> shares = sun_shares(*scene.terrain, scene.light, points, shadow_rays);
  for (std::size_t i = 0; i < indices.size(); ++i) facings[indices[i]] *= shares[i];
}

}  // namespace

std::vector<ShadedRay> shade(const Scene& scene, std::span<const Ray> rays,
                             std::span<const std::optional<Hit>> hits, std::int64_t& shadow_rays) {
  std::vector<ShadedRay> shaded(hits.size());
  std::vector<float> sunlit = facings(scene, hits, shaded);
  if (scene.light.casts_shadows) cast_shadows(scene, hits, sunlit, shadow_rays);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    shaded[i].color = hits[i] ? (scene.light.ambient + sunlit[i] * scene.light.sun) *
                                    ground_color(scene, *hits[i])
                              : sky_color(scene, rays[i].direction);
  }
  return shaded;
}

}  // namespace terrview
