#include "render/shade.h"

#include <glm/geometric.hpp>

#include "render/air.h"
#include "render/painted_sky.h"
#include "render/shadows.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

GroundDetail::Ground exact_ground(const Scene& scene, const Hit& hit) {
  const VerticalFrame& frame = scene.terrain->frame();
  return {scene.normals == NormalKind::facet ? scene.terrain->facet_normal(hit)
                                             : scene.terrain->smooth_normal(hit),
          frame.at(glm::dvec2(hit.position_m)).scene_height_m(hit.position_m.z) / frame.z_scale};
}

// Fills in the normals, and as clear colours those of the ground, and returns N . L of each hit: 0
// where the ground turns away from the sun, or the sun is below the local horizon.
std::vector<float> face_sun(const Scene& scene, const PixelWidth& pixel, std::span<const Ray> rays,
                            std::span<const std::optional<Hit>> hits, std::span<ShadedRay> shaded) {
  std::vector<float> facings(hits.size(), 0);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!hits[i]) continue;
    shaded[i].distance_m = static_cast<float>(glm::distance(hits[i]->position_m, rays[i].origin_m));
    GroundDetail::Ground ground = exact_ground(scene, *hits[i]);
    if (scene.detail)
      ground = scene.detail->seen(*scene.terrain, rays[i], *hits[i], pixel.at(shaded[i].distance_m),
                                  ground);
    shaded[i].normal = ground.normal;
    shaded[i].clear = scene.tints.at(ground.height_m);
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
  if (!scene.painted_sky) return;
  for (const std::size_t i : indices) {
    if (facings[i] > 0) facings[i] *= scene.painted_sky->sun_share(hits[i]->position_m);
  }
}

glm::vec3 sky_light(const Scene& scene, const Hit& hit) {
  if (!scene.sky_views) return scene.light.ambient;
  return scene.light.ambient * (*scene.sky_views)[static_cast<std::size_t>(hit.grid)].at(hit.uv);
}

// Puts the air before what the ray meets at `hit`.
void add_air(const Scene& scene, const Ray& ray, const Hit& hit, ShadedRay& shaded) {
  shaded.color = shaded.clear;
  if (scene.air.extinction_per_m <= 0) return;
  const VerticalFrame& frame = scene.terrain->frame();
  const double distance_m =
      glm::distance(to_true_enu(frame, hit.position_m), to_true_enu(frame, ray.origin_m));
  shaded.transmission = transmission(scene.air, distance_m);
  shaded.air = air_color(scene, glm::normalize(ray.direction));
  shaded.color = shaded.clear * shaded.transmission + shaded.air * (1 - shaded.transmission);
}

}  // namespace

PixelWidth pixel_width(const Camera& camera) {
  if (camera.options().projection == Projection::orthographic) return {0, camera.per_px()};
  return {camera.per_px(), 0};
}

std::vector<ShadedRay> shade(const Scene& scene, const PixelWidth& pixel, std::span<const Ray> rays,
                             std::span<const std::optional<Hit>> hits, std::int64_t& shadow_rays) {
  std::vector<ShadedRay> shaded(hits.size());
  std::vector<float> sunlit = face_sun(scene, pixel, rays, hits, shaded);
  if (scene.light.casts_shadows) cast_shadows(scene, hits, sunlit, shadow_rays);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i]) {
      shaded[i].clear *= sky_light(scene, *hits[i]) + sunlit[i] * scene.light.sun;
      add_air(scene, rays[i], *hits[i], shaded[i]);
    } else {
      shaded[i].clear = background_color(scene, glm::normalize(rays[i].direction));
      shaded[i].color = shaded[i].clear;
    }
  }
  return shaded;
}

}  // namespace terrview
