#include "render/shadows.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "render/cells_in_view.h"
#include "render/objects/scene_objects.h"
#include "render/parallel.h"
#include "terrain/occlusion.h"
#include "terrain/sun_map.h"
#include "terrain/sun_shadow.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

constexpr int kStrips = 4;
constexpr int kHalvings = 5;
constexpr int kObjectRays = 8;  // a strip

// Cells of a sun map that are made while a point finds its shadow without one: where all rays are
// parallel, and on a round Earth or where tracks bend (docs/decisions/sun-map.md).
constexpr double kCellsAParallelRay = 15;
constexpr double kCellsARay = 25;

// Cells that are made while cells_in_view() looks which they are.
constexpr double kCellsOfProbe = 1 << 20;

// Directions of the sun's disc.
class SunDisc {
 public:
  explicit SunDisc(const Light& light) : centre_(light.towards_sun), radius_(light.sun_radius_rad) {
    const glm::dvec3 level(centre_.y, -centre_.x, 0);
    right_ = glm::length(level) > 0 ? glm::normalize(level) : glm::dvec3(1, 0, 0);
    up_ = glm::cross(right_, centre_);
  }

  // How far the middle of a strip is to the right, in radii.
  [[nodiscard]] static double middle(int strip) { return (2 * strip + 1.0) / kStrips - 1; }

  // Half of a strip's height, in radii.
  [[nodiscard]] static double half_height(int strip) {
    return std::sqrt(1 - middle(strip) * middle(strip));
  }

  // The direction of a strip at `height`, from -1 at its foot to 1 at its top.
  [[nodiscard]] glm::dvec3 direction(int strip, double height) const {
    return glm::normalize(centre_ +
                          radius_ * (middle(strip) * right_ + height * half_height(strip) * up_));
  }

 private:
  glm::dvec3 centre_;
  double radius_;
  glm::dvec3 right_;
  glm::dvec3 up_;
};

// Rays from points towards parts of the sun, all sent at once.
class SunRays {
 public:
  SunRays(const ShadowCasters& casters, std::span<const Hit> points, ShadowCounts& counts)
      : casters_(casters), points_(points), counts_(counts) {}

  void add(std::size_t point, const glm::dvec3& true_direction) {
    rays_.push_back(ray(point, true_direction));
  }

  // Whether the map knows that the ground hides nothing of a sun without width.
  [[nodiscard]] bool is_lit(std::size_t point) {
    const bool lit = casters_.sun_map && points_[point].grid != kOffGround &&
                     casters_.sun_map->lights(points_[point]);
    counts_.rays += lit ? 1 : 0;
    return lit;
  }

  // As send(), for rays that all go towards the middle of the sun.
  std::vector<std::uint8_t> send_to_middle() {
    if (!casters_.sun_map) return send();
    counts_.rays += static_cast<std::int64_t>(rays_.size());
    std::vector<glm::dvec3> points_m;
    points_m.reserve(rays_.size());
    for (const Ray& each : rays_) points_m.push_back(each.origin_m);
    std::vector<std::uint8_t> answers(rays_.size());
    TraceCounts counts;
    shaded(casters_.terrain, *casters_.sun_map, points_m, answers, counts);
    rays_.clear();
    return answers;
  }

  // Whether the ground stops them, in the order of add(), after which none is left.
  std::vector<std::uint8_t> send() {
    counts_.rays += static_cast<std::int64_t>(rays_.size());
    std::vector<std::uint8_t> answers = stopped(casters_.terrain, rays_);
    rays_.clear();
    return answers;
  }

  // Whether an object stops the ray.
  [[nodiscard]] bool meets_object(std::size_t point, const glm::dvec3& true_direction) const {
    return casters_.objects &&
           casters_.objects->stops(ray(point, true_direction), &counts_.objects);
  }

  // The share of a strip above `height` that objects leave free.
  [[nodiscard]] float free_share(std::size_t point, const SunDisc& disc, int strip,
                                 double height) const {
    if (!casters_.objects) return 1;
    int free = 0;
    for (int i = 0; i < kObjectRays; ++i) {
      const double at = height + (1 - height) * (i + 0.5) / kObjectRays;
      free += meets_object(point, disc.direction(strip, at)) ? 0 : 1;
    }
    counts_.rays += kObjectRays;
    return static_cast<float>(free) / kObjectRays;
  }

 private:
  [[nodiscard]] Ray ray(std::size_t point, const glm::dvec3& true_direction) const {
    const Hit& hit = points_[point];
    return casters_.terrain.leave(
        hit, direction_at(casters_.terrain.frame(), hit.position_m, true_direction));
  }

  const ShadowCasters& casters_;
  std::span<const Hit> points_;
  ShadowCounts& counts_;
  std::vector<Ray> rays_;
};

// The heights between which the horizon of each of `points` lies in a strip.
struct Horizon {
  std::size_t point;
  double hidden;
  double free;
};

// The points whose horizon crosses the strip; adds `weight` to the shares of those that see all of
// it.
std::vector<Horizon> crossing_horizons(const SunDisc& disc, int strip, SunRays& rays,
                                       std::span<float> shares, float weight) {
  for (std::size_t i = 0; i < shares.size(); ++i) rays.add(i, disc.direction(strip, -1));
  const std::vector<std::uint8_t> foot_hidden = rays.send();
  std::vector<std::size_t> partly;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (foot_hidden[i]) {
      partly.push_back(i);
      rays.add(i, disc.direction(strip, 1));
    } else {
      shares[i] += weight * rays.free_share(i, disc, strip, -1);
    }
  }
  const std::vector<std::uint8_t> top_hidden = rays.send();
  std::vector<Horizon> horizons;
  for (std::size_t i = 0; i < partly.size(); ++i) {
    if (!top_hidden[i]) horizons.push_back({partly[i], -1, 1});
  }
  return horizons;
}

void add_strip(const SunDisc& disc, int strip, SunRays& rays, std::span<float> shares,
               float weight) {
  std::vector<Horizon> horizons = crossing_horizons(disc, strip, rays, shares, weight);
  for (int halving = 0; halving < kHalvings; ++halving) {
    for (const Horizon& horizon : horizons)
      rays.add(horizon.point, disc.direction(strip, (horizon.hidden + horizon.free) / 2));
    const std::vector<std::uint8_t> hidden = rays.send();
    for (std::size_t i = 0; i < horizons.size(); ++i)
      (hidden[i] ? horizons[i].hidden : horizons[i].free) =
          (horizons[i].hidden + horizons[i].free) / 2;
  }
  for (const Horizon& horizon : horizons) {
    const double height = (horizon.hidden + horizon.free) / 2;
    shares[horizon.point] += weight * static_cast<float>((1 - height) / 2) *
                             rays.free_share(horizon.point, disc, strip, height);
  }
}

// Adds the share of the sun's disc that each point sees.
void add_disc(const Light& light, SunRays& rays, std::span<float> shares) {
  const SunDisc disc(light);
  double area = 0;
  for (int strip = 0; strip < kStrips; ++strip) area += SunDisc::half_height(strip);
  for (int strip = 0; strip < kStrips; ++strip)
    add_strip(disc, strip, rays, shares, static_cast<float>(SunDisc::half_height(strip) / area));
}

// A sun without width: what the map knows, and a ray for every other point.
void add_point(const Light& light, SunRays& rays, std::span<float> shares) {
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shares[i] = 1;
    if (rays.is_lit(i)) continue;
    asked.push_back(i);
    rays.add(i, light.towards_sun);
  }
  const std::vector<std::uint8_t> hidden = rays.send_to_middle();
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (hidden[i]) shares[asked[i]] = 0;
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i] > 0 && rays.meets_object(i, light.towards_sun)) shares[i] = 0;
}

bool can_have_sun_map(const Scene& scene) {
  return scene.light.casts_shadows && !(scene.light.sun_radius_rad > 0) && !scene.sun_map &&
         scene.terrain->skips_blocks() && scene.terrain->layers().size() == 1;
}

CellRect all_cells(const Terrain& terrain) {
  const HeightGrid& grid = *terrain.layers()[0].grid;
  return {{0, 0}, glm::ivec2(grid.columns, grid.rows) - 2};
}

double count_of(const CellRect& cells) {
  return static_cast<double>(cells.size().x) * cells.size().y;
}

Scene mapped(const Scene& scene, const CellRect& cells, std::int64_t points, int threads) {
  const Terrain& terrain = *scene.terrain;
  const bool parallel = terrain.frame().is_flat() && terrain.layers()[0].map->linear();
  if (static_cast<double>(points) * (parallel ? kCellsAParallelRay : kCellsARay) < count_of(cells))
    return scene;
  Scene lit = scene;
  lit.sun_map = SunMap::make(
      terrain, scene.light.towards_sun,
      [&](int count, const std::function<void(int)>& work) { parallel_for(count, threads, work); },
      cells);
  return lit;
}

}  // namespace

ShadowCasters shadow_casters(const Scene& scene) {
  if (!scene.objects) return {*scene.terrain, nullptr, scene.sun_map.get()};
  const SceneObjects& objects = *scene.objects;
  return {*scene.terrain, (objects.casters ? objects.casters : objects.set).get(),
          scene.sun_map.get()};
}

Scene with_sun_map(const Scene& scene, std::int64_t points, int threads) {
  return can_have_sun_map(scene) ? mapped(scene, all_cells(*scene.terrain), points, threads)
                                 : scene;
}

Scene with_sun_map(const Scene& scene, const Camera& camera, int threads) {
  if (!can_have_sun_map(scene)) return scene;
  const glm::ivec2 size_px = camera.options().size_px;
  const CellRect all = all_cells(*scene.terrain);
  CellRect cells = all;
  if (count_of(all) > kCellsOfProbe) cells = cells_in_view(*scene.terrain, camera, threads);
  // What is seen here and there beyond the part is worth more than the rest of the grid.
  if (count_of(cells) > count_of(all) / 2) cells = all;
  return mapped(scene, cells, std::int64_t{size_px.x} * size_px.y, threads);
}

std::vector<std::uint8_t> stopped(const Terrain& terrain, std::span<const Ray> rays) {
  std::vector<std::uint8_t> stops(rays.size());
  TraceCounts counts;
  occluded(terrain, rays, stops, counts);
  return stops;
}

std::vector<float> sun_shares(const ShadowCasters& casters, const Light& light,
                              std::span<const Hit> points, ShadowCounts& counts) {
  std::vector<float> shares(points.size(), 0);
  SunRays rays(casters, points, counts);
  if (light.sun_radius_rad > 0)
    add_disc(light, rays, shares);
  else
    add_point(light, rays, shares);
  return shares;
}

}  // namespace terrview
