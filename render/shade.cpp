#include "render/shade.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/air.h"
#include "render/ambient_light.h"
#include "render/beams.h"
#include "render/drape.h"
#include "render/materials/shade_materials.h"
#include "render/natural_ground.h"
#include "render/objects/level_plane.h"
#include "render/objects/prism.h"
#include "render/objects/scene_objects.h"
#include "render/painted_sky.h"
#include "render/reflection.h"
#include "render/shadows.h"
#include "render/water.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

GroundDetail::Ground exact_ground(const Scene& scene, const Hit& hit) {
  const VerticalFrame& frame = scene.terrain->frame();
  return {scene.normals == NormalKind::facet ? scene.terrain->facet_normal(hit)
                                             : scene.terrain->smooth_normal(hit),
          frame.at(glm::dvec2(hit.position_m)).scene_height_m(hit.position_m.z) / frame.z_scale};
}

// The ground's own colour, as a pixel `width_m` wide sees it.
glm::vec3 ground_color(const Scene& scene, const Ray& ray, const Hit& hit, double width_m,
                       const GroundDetail::Ground& ground) {
  const double z_scale = scene.terrain->frame().z_scale;
  glm::vec3 color = scene.natural ? natural_color(*scene.natural, ground.height_m,
                                                  slope_of(ground.normal, z_scale))
                                  : scene.tints.at(ground.height_m);
  if (scene.drape)
    color = scene.drape->over(color, *scene.terrain, ray, hit, scene.detail ? width_m : 0,
                              ground.normal);
  const Contours& contours = scene.contours;
  if (contours.interval_m <= 0) return color;
  const double rise_m =
      rise_over(width_m * footprint(ray.direction, ground.normal), ground.normal, z_scale);
  const double share = contour_share(ground.height_m, rise_m, contours.interval_m);
  return glm::mix(color, contours.color, contours.opacity * static_cast<float>(share));
}

// Fills in the normal, and as clear colour the ground's, as a pixel `width_m` wide sees it.
void see_ground(const Scene& scene, const Ray& ray, const Hit& hit, double width_m,
                ShadedRay& shaded) {
  GroundDetail::Ground ground = exact_ground(scene, hit);
  if (scene.detail) ground = scene.detail->seen(*scene.terrain, ray, hit, width_m, ground);
  shaded.normal = ground.normal;
  shaded.clear = ground_color(scene, ray, hit, width_m, ground);
}

// Fills in the normals, and as clear colours those of ground and water, and returns N . L of each
// hit: 0 where the ground turns away from the sun, or the sun is below the local horizon.
std::vector<float> face_sun(const Scene& scene, const RayWidths& widths, std::span<const Ray> rays,
                            const RayHits& hits, std::span<ShadedRay> shaded) {
  std::vector<float> facings(rays.size(), 0);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits.ground[i]) continue;
    const Hit& hit = *hits.ground[i];
    shaded[i].distance_m = static_cast<float>(glm::distance(hit.position_m, rays[i].origin_m));
    if (hits.meets_water(i)) {
      shaded[i].normal = {0, 0, 1};
      shaded[i].clear = scene.water->color;
    } else {
      see_ground(scene, rays[i], hit, widths.at(i, shaded[i].distance_m), shaded[i]);
    }
    const glm::dvec3 to_sun =
        local_direction(scene.terrain->frame(), hit.position_m, scene.light.towards_sun);
    const double facing = glm::dot(glm::dvec3(shaded[i].normal), to_sun);
    if (to_sun.z > 0 && facing > 0) facings[i] = static_cast<float>(facing);
  }
  return facings;
}

// A surface's normal as those of Terrain are.
glm::dvec3 plumb_normal(const VerticalFrame& frame, const SurfaceHit& surface) {
  if (frame.is_flat()) return surface.normal;
  return glm::normalize(level_plane_at(frame, surface.position_m).plumb_normal(surface.normal));
}

// The same for the objects that are met, but of those made of a material, whose indices it returns,
// the normals alone.
std::vector<std::size_t> objects_face_sun(const Scene& scene, std::span<const Ray> rays,
                                          const RayHits& hits, std::span<ShadedRay> shaded,
                                          std::span<float> facings) {
  std::vector<std::size_t> with_material;
  for (std::size_t i = 0; i < hits.objects.size(); ++i) {
    if (!hits.objects[i]) continue;
    const SurfaceHit& surface = hits.objects[i]->surface;
    const ObjectLook& look =
        scene.objects->looks[static_cast<std::size_t>(hits.objects[i]->object)];
    shaded[i].distance_m = static_cast<float>(glm::distance(surface.position_m, rays[i].origin_m));
    shaded[i].normal = plumb_normal(scene.terrain->frame(), surface);
    if (material_of(look, surface.part)) {
      with_material.push_back(i);
      continue;
    }
    shaded[i].clear = surface.part == Prism::kRoof ? look.roof_color : look.color;
    const glm::dvec3 to_sun =
        local_direction(scene.terrain->frame(), surface.position_m, scene.light.towards_sun);
    const double facing = glm::dot(glm::dvec3(shaded[i].normal), to_sun);
    if (to_sun.z > 0 && facing > 0) facings[i] = static_cast<float>(facing);
  }
  return with_material;
}

// Where light that reaches a hit comes to: on the ground, or just off the object.
Hit lit_point(const RayHits& hits, std::size_t i) {
  if (!hits.meets_object(i)) return *hits.ground[i];
  const SurfaceHit& surface = hits.objects[i]->surface;
  Hit point{};
  point.grid = kOffGround;
  point.position_m = off_surface(surface.position_m, surface.normal);
  return point;
}

// Takes from the facings what ground and objects hide of the sun.
void cast_shadows(const Scene& scene, const RayHits& hits, std::span<float> facings,
                  ShadowCounts& counts) {
  std::vector<std::size_t> indices;
  std::vector<Hit> points;
  for (std::size_t i = 0; i < facings.size(); ++i) {
    if (facings[i] <= 0) continue;
    indices.push_back(i);
    points.push_back(lit_point(hits, i));
  }
  const std::vector<float> shares = sun_shares(shadow_casters(scene), scene.light, points, counts);
  for (std::size_t i = 0; i < indices.size(); ++i) facings[indices[i]] *= shares[i];
  if (!scene.painted_sky) return;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    float& facing = facings[indices[i]];
    if (facing > 0) facing *= scene.painted_sky->sun_share(points[i].position_m);
  }
}

glm::vec3 sky_at(const Scene& scene, const RayHits& hits, std::size_t i, const glm::vec3& normal) {
  if (const auto& hit = hits.ground[i]) return sky_light(scene, hit->grid, hit->uv);
  return light_on_object(scene, hits.objects[i]->surface.position_m, normal);
}

// What hits that are not black have of the lamps, by ray; empty in a scene without lamps.
std::vector<glm::vec3> light_of_lamps(const Scene& scene, const RayHits& hits,
                                      std::span<const ShadedRay> shaded, ShadowCounts& counts) {
  if (scene.lamps.empty()) return {};
  std::vector<std::size_t> indices;
  std::vector<LitPlace> places;
  for (std::size_t i = 0; i < shaded.size(); ++i) {
    if (shaded[i].clear == glm::vec3(0)) continue;
    indices.push_back(i);
    places.push_back({lit_point(hits, i).position_m, shaded[i].normal});
  }
  const std::vector<glm::vec3> light = lamplight(scene, places, counts);
  std::vector<glm::vec3> by_ray(shaded.size(), glm::vec3(0));
  for (std::size_t k = 0; k < indices.size(); ++k) by_ray[indices[k]] = light[k];
  return by_ray;
}

// Puts the air before what the ray meets.
void add_air(const Scene& scene, const Ray& ray, const glm::dvec3& position_m, ShadedRay& shaded) {
  shaded.color = shaded.clear;
  if (scene.air.extinction_per_m <= 0) return;
  const VerticalFrame& frame = scene.terrain->frame();
  const double distance_m =
      glm::distance(to_true_enu(frame, position_m), to_true_enu(frame, ray.origin_m));
  shaded.transmission = transmission(scene.air, distance_m);
  shaded.air = air_color(scene, glm::normalize(ray.direction));
  shaded.color = shaded.clear * shaded.transmission + shaded.air * (1 - shaded.transmission);
}

}  // namespace

PixelWidth pixel_width(const Camera& camera) {
  if (camera.options().projection == Projection::orthographic) return {0, camera.per_px()};
  return {camera.per_px(), 0};
}

std::vector<ShadedRay> shade(const Scene& scene, const RayWidths& widths, std::span<const Ray> rays,
                             const RayHits& hits, ShadowCounts& counts) {
  std::vector<ShadedRay> shaded(rays.size());
  std::vector<float> sunlit = face_sun(scene, widths, rays, hits, shaded);
  const auto with_material = objects_face_sun(scene, rays, hits, shaded, sunlit);
  if (scene.light.casts_shadows) cast_shadows(scene, hits, sunlit, counts);
  const std::vector<glm::vec3> lamps = light_of_lamps(scene, hits, shaded, counts);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits.ground[i] || hits.meets_object(i)) {
      glm::vec3 light = sky_at(scene, hits, i, shaded[i].normal) + sunlit[i] * scene.light.sun;
      if (!lamps.empty()) light += lamps[i];
      shaded[i].clear *= light;
    } else {
      shaded[i].clear =
          background_color(scene, glm::normalize(rays[i].direction), widths.bounces == 0);
      shaded[i].color = shaded[i].clear;
    }
  }
  if (!with_material.empty())
    shade_materials(scene, widths, rays, hits, with_material, shaded, counts);
  if (scene.water && scene.water->reflected)
    add_reflections(scene, widths, rays, hits, shaded, counts);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits.ground[i])
      add_air(scene, rays[i], hits.ground[i]->position_m, shaded[i]);
    else if (hits.meets_object(i))
      add_air(scene, rays[i], hits.objects[i]->surface.position_m, shaded[i]);
  }
  return shaded;
}

}  // namespace terrview
