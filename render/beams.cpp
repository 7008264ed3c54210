#include "render/beams.h"

#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/objects/level_plane.h"
#include "render/painted_sky.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

// How far a ray begins off an object, as a share of the numbers that its place is made of.
constexpr double kOffSurface = 1e-10;

double lift_m(const glm::dvec3& position_m) {
  const glm::dvec3 size = glm::abs(position_m);
  return kOffSurface * (size.x + size.y + size.z + 1);
}

Hit point_at(const glm::dvec3& position_m) {
  Hit hit{};
  hit.grid = kOffGround;
  hit.position_m = position_m;
  return hit;
}

// The ray from a place to a lamp, which ends just before it.
Ray ray_to(const Lamp& lamp, const Terrain& terrain, const glm::dvec3& place_m) {
  Ray ray = terrain.leave(point_at(place_m), glm::dvec3(0, 0, 1));
  ray.direction = lamp.position_m - ray.origin_m;
  ray.length_m = glm::length(ray.direction) - lift_m(lamp.position_m);
  return ray;
}

// Takes away the beams that ground or objects stop.
void drop_hidden(const Scene& scene, const Lamp& lamp, std::span<const LitPlace> places,
                 std::vector<Beam>& beams, ShadowCounts& counts) {
  const ShadowCasters stop = shadow_casters(scene);
  std::vector<Ray> rays;
  for (const Beam& beam : beams)
    rays.push_back(ray_to(lamp, stop.terrain, places[beam.place].position_m));
  counts.rays += static_cast<std::int64_t>(rays.size());
  const std::vector<std::uint8_t> hidden = stopped(stop.terrain, rays);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (hidden[i] || (stop.objects && stop.objects->stops(rays[i], &counts.objects))) continue;
    beams[kept++] = beams[i];
  }
  beams.resize(kept);
}

// The beams of a lamp with nothing between.
std::vector<Beam> free_beams(const VerticalFrame& frame, const Lamp& lamp,
                             std::span<const LitPlace> places) {
  std::vector<Beam> beams;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3& place_m = places[i].position_m;
    const glm::dvec3 towards = level_plane_at(frame, place_m).direction(lamp.position_m - place_m);
    if (!(glm::dot(places[i].normal, towards) > 0)) continue;
    const double intensity = intensity_at(lamp, place_m);
    if (intensity > 0)
      beams.push_back({i, glm::normalize(towards), lamp.color, static_cast<float>(intensity)});
  }
  return beams;
}

}  // namespace

glm::dvec3 off_surface(const glm::dvec3& position_m, const glm::dvec3& side) {
  return position_m + lift_m(position_m) * side;
}

double intensity_at(const Lamp& lamp, const glm::dvec3& point_m) {
  const glm::dvec3 from_lamp_m = point_m - lamp.position_m;
  const double distance_m = glm::length(from_lamp_m);
  if (!(distance_m > 0)) return 0;
  double intensity = lamp.intensity;
  if (lamp.reference_m > 0) intensity *= std::pow(lamp.reference_m / distance_m, 2);
  if (!lamp.spot) return intensity;
  const double cosine = glm::dot(glm::normalize(lamp.spot->direction), from_lamp_m) / distance_m;
  return cosine > 0 && cosine >= std::cos(lamp.spot->half_angle_rad) ? intensity * cosine : 0;
}

std::vector<Beam> sun_beams(const Scene& scene, std::span<const LitPlace> places,
                            ShadowCounts& counts) {
  const VerticalFrame& frame = scene.terrain->frame();
  std::vector<Beam> beams;
  if (scene.light.sun == glm::vec3(0)) return beams;
  std::vector<Hit> points;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const LitPlace& place = places[i];
    const glm::dvec3 towards = local_direction(frame, place.position_m, scene.light.towards_sun);
    if (!(towards.z > 0 && glm::dot(place.normal, towards) > 0)) continue;
    beams.push_back({i, towards, scene.light.sun, 1});
    points.push_back(point_at(place.position_m));
  }
  if (!scene.light.casts_shadows || beams.empty()) return beams;
  const std::vector<float> shares = sun_shares(shadow_casters(scene), scene.light, points, counts);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    beams[i].intensity = shares[i];
    if (shares[i] > 0 && scene.painted_sky)
      beams[i].intensity *= scene.painted_sky->sun_share(points[i].position_m);
  }
  std::erase_if(beams, [](const Beam& beam) { return !(beam.intensity > 0); });
  return beams;
}

std::vector<Beam> lamp_beams(const Scene& scene, std::span<const LitPlace> places,
                             ShadowCounts& counts) {
  std::vector<Beam> all;
  for (const Lamp& lamp : scene.lamps) {
    std::vector<Beam> beams = free_beams(scene.terrain->frame(), lamp, places);
    if (scene.light.casts_shadows) drop_hidden(scene, lamp, places, beams, counts);
    all.insert(all.end(), beams.begin(), beams.end());
  }
  return all;
}

std::vector<glm::vec3> lamplight(const Scene& scene, std::span<const LitPlace> places,
                                 ShadowCounts& counts) {
  std::vector<glm::vec3> light(places.size(), glm::vec3(0));
  for (const Beam& beam : lamp_beams(scene, places, counts)) {
    const double facing = glm::dot(places[beam.place].normal, beam.towards);
    light[beam.place] += static_cast<float>(facing) * beam.intensity * beam.color;
  }
  return light;
}

}  // namespace terrview
