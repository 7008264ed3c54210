#include "render/materials/shade_materials.h"

#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/ambient_light.h"
#include "render/beams.h"
#include "render/materials/light_model.h"
#include "render/objects/level_plane.h"
#include "render/objects/scene_objects.h"
#include "render/water.h"

namespace terrview {
namespace {

struct Surface {
  std::size_t ray;
  const Material* material;
  ShadingPoint point;
  glm::dvec3 side;       // point.normal without bumps
  glm::dvec3 view_side;  // the same in the view frame
  LevelPlane level;      // between the two frames
};

// A normal that faces the eye, or is seen edge-on where it would not.
glm::dvec3 seen_normal(const glm::dvec3& normal, const glm::dvec3& towards_eye) {
  const double facing = glm::dot(normal, towards_eye);
  return facing >= 0 ? normal : glm::normalize(normal - facing * towards_eye);
}

Surface surface_of(const Scene& scene, const RayWidths& widths, const Ray& ray,
                   const ObjectHit& hit, std::size_t i) {
  const SurfaceHit& met = hit.surface;
  const ObjectLook& look = scene.objects->looks[static_cast<std::size_t>(hit.object)];
  Surface surface{};
  surface.ray = i;
  surface.material = material_of(look, met.part);
  surface.level = level_plane_at(scene.terrain->frame(), met.position_m);
  ShadingPoint& point = surface.point;
  point.position_m = met.position_m;
  point.towards_eye = -glm::normalize(surface.level.direction(ray.direction));
  point.width_m = widths.at(i, met.distance_m);
  point.inside = glm::dot(met.normal, ray.direction) > 0;
  const glm::dvec3 outward = glm::normalize(surface.level.plumb_normal(met.normal));
  const glm::dvec3 bumped =
      surface.material->bump_m ? bumped_normal(surface.material->bump_m, point, outward) : outward;
  const double side = point.inside ? -1 : 1;
  surface.side = side * outward;
  surface.view_side = side * met.normal;
  point.normal = bumped == outward ? surface.side : seen_normal(side * bumped, point.towards_eye);
  return surface;
}

// What the sources give to each surface that has a use for it.
std::vector<SourceLight> source_light(const Scene& scene, std::span<const Surface> surfaces,
                                      ShadowCounts& counts) {
  std::vector<SourceLight> light(surfaces.size());
  std::vector<LitPlace> places;
  std::vector<std::size_t> surface_of_place;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Surface& surface = surfaces[i];
    if (!surface.material->diffuse && !surface.material->specular) continue;
    places.push_back({off_surface(surface.point.position_m, surface.view_side), surface.side});
    surface_of_place.push_back(i);
  }
  const auto add = [&](std::span<const Beam> beams) {
    for (const Beam& beam : beams) {
      const std::size_t i = surface_of_place[beam.place];
      if (glm::dot(surfaces[i].point.normal, beam.towards) > 0)
        add_beam(*surfaces[i].material, surfaces[i].point, beam, light[i]);
    }
  };
  add(sun_beams(scene, places, counts));
  add(lamp_beams(scene, places, counts));
  return light;
}

// A ray that a surface sends on, and the share of what it shows.
struct Sent {
  std::size_t surface;
  glm::vec3 share;
  bool is_mirrored;
};

// The rays of one bounce, sent all at once.
class Bounce {
 public:
  explicit Bounce(std::span<const Surface> surfaces) : surfaces_(surfaces) {
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const Material& material = *surfaces[i].material;
      const ShadingPoint& point = surfaces[i].point;
      if (material.mirror) send(i, material.mirror->at(point), mirror_direction(surfaces[i]), true);
      if (material.transparency)
        send(i, material.transparency->at(point), through_direction(surfaces[i]), false);
    }
  }

  // What the rays show; `widths` are those of the rays that met the surfaces.
  [[nodiscard]] std::vector<ShadedRay> seen(const Scene& scene, const RayWidths& widths,
                                            std::span<const ShadedRay> shaded,
                                            ShadowCounts& counts) const {
    if (rays_.empty()) return {};
    RayHits hits;
    std::vector<double> before_m;
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      const std::size_t i = surfaces_[sent_[k].surface].ray;
      before_m.push_back(shaded[i].distance_m + (widths.before_m.empty() ? 0 : widths.before_m[i]));
      hits.ground.push_back(scene.terrain->first_hit(rays_[k]));
    }
    meet_water(scene, rays_, hits);
    meet_objects(scene, rays_, hits, counts.objects);
    return shade(scene, {widths.pixel, before_m, widths.bounces + 1}, rays_, hits, counts);
  }

  [[nodiscard]] std::span<const Sent> sent() const { return sent_; }

 private:
  static glm::dvec3 mirror_direction(const Surface& surface) {
    const glm::dvec3 away = reflected(-surface.point.towards_eye, surface.point.normal);
    if (glm::dot(away, surface.side) > 0) return away;
    return reflected(-surface.point.towards_eye, surface.side);
  }

  static glm::dvec3 through_direction(const Surface& surface) {
    const double solid = surface.material->refractive_index;
    const double index = surface.point.inside ? 1 / solid : solid;
    const glm::dvec3 along = -surface.point.towards_eye;
    const auto beyond = refracted(along, surface.point.normal, index);
    if (!beyond) return mirror_direction(surface);
    if (glm::dot(*beyond, surface.side) < 0) return *beyond;
    return refracted(along, surface.side, index).value_or(mirror_direction(surface));
  }

  void send(std::size_t surface, const glm::vec3& share, const glm::dvec3& direction,
            bool is_mirrored) {
    if (share == glm::vec3(0)) return;
    const Surface& from = surfaces_[surface];
    const glm::dvec3 off = glm::dot(direction, from.side) < 0 ? -from.view_side : from.view_side;
    rays_.push_back(
        {off_surface(from.point.position_m, off), from.level.view_direction(direction)});
    sent_.push_back({surface, share, is_mirrored});
  }

  std::span<const Surface> surfaces_;
  std::vector<Sent> sent_;
  std::vector<Ray> rays_;
};

// kr R or kt T.
void add_seen(const Sent& sent, const Material& material, const ShadedRay& seen, glm::vec3& clear) {
  if (material.model == LightModel::whitted || !sent.is_mirrored) {
    clear += sent.share * seen.color;
  } else if (seen.normal != glm::vec3(0)) {
    clear = (1.0F - sent.share) * clear + sent.share * glm::min(seen.color, glm::vec3(1));
  }
}

}  // namespace

void shade_materials(const Scene& scene, const RayWidths& widths, std::span<const Ray> rays,
                     const RayHits& hits, std::span<const std::size_t> indices,
                     std::span<ShadedRay> shaded, ShadowCounts& counts) {
  std::vector<Surface> surfaces;
  for (const std::size_t i : indices)
    surfaces.push_back(surface_of(scene, widths, rays[i], *hits.objects[i], i));
  const std::vector<SourceLight> light = source_light(scene, surfaces, counts);
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const Surface& surface = surfaces[k];
    const bool is_guitteny = surface.material->model == LightModel::guitteny;
    const glm::vec3 ambient =
        is_guitteny ? scene.light.ambient
                    : light_on_object(scene, surface.point.position_m, shaded[surface.ray].normal);
    shaded[surface.ray].clear = own_color(*surface.material, surface.point, ambient, light[k]);
  }
  if (widths.bounces >= kMostBounces) return;
  const Bounce bounce(surfaces);
  const std::vector<ShadedRay> seen = bounce.seen(scene, widths, shaded, counts);
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const Sent& sent = bounce.sent()[k];
    const Surface& surface = surfaces[sent.surface];
    add_seen(sent, *surface.material, seen[k], shaded[surface.ray].clear);
  }
}

}  // namespace terrview
