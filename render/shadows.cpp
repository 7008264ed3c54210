#include "render/shadows.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "terrain/occlusion.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

constexpr int kStrips = 4;
constexpr int kHalvings = 5;

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

// Rays from points of the ground towards parts of the sun, all sent at once.
class SunRays {
 public:
  SunRays(const Terrain& terrain, std::span<const Hit> points)
      : terrain_(terrain), points_(points) {}

  void add(std::size_t point, const glm::dvec3& true_direction) {
    const Hit& hit = points_[point];
    rays_.push_back(
        terrain_.leave(hit, direction_at(terrain_.frame(), hit.position_m, true_direction)));
  }

  // The answers in the order of add(), after which none is left.
  std::vector<std::uint8_t> send(std::int64_t& shadow_rays) {
    shadow_rays += static_cast<std::int64_t>(rays_.size());
    std::vector<std::uint8_t> answers = stopped(terrain_, rays_);
    rays_.clear();
    return answers;
  }

 private:
  const Terrain& terrain_;
  std::span<const Hit> points_;
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
                                       std::span<float> shares, float weight,
                                       std::int64_t& shadow_rays) {
  for (std::size_t i = 0; i < shares.size(); ++i) rays.add(i, disc.direction(strip, -1));
  const std::vector<std::uint8_t> foot_hidden = rays.send(shadow_rays);
  std::vector<std::size_t> partly;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (foot_hidden[i]) {
      partly.push_back(i);
      rays.add(i, disc.direction(strip, 1));
    } else {
      shares[i] += weight;
    }
  }
  const std::vector<std::uint8_t> top_hidden = rays.send(shadow_rays);
  std::vector<Horizon> horizons;
  for (std::size_t i = 0; i < partly.size(); ++i) {
    if (!top_hidden[i]) horizons.push_back({partly[i], -1, 1});
  }
  return horizons;
}

void add_strip(const SunDisc& disc, int strip, SunRays& rays, std::span<float> shares, float weight,
               std::int64_t& shadow_rays) {
  std::vector<Horizon> horizons = crossing_horizons(disc, strip, rays, shares, weight, shadow_rays);
  for (int halving = 0; halving < kHalvings; ++halving) {
    for (const Horizon& horizon : horizons)
      rays.add(horizon.point, disc.direction(strip, (horizon.hidden + horizon.free) / 2));
    const std::vector<std::uint8_t> hidden = rays.send(shadow_rays);
    for (std::size_t i = 0; i < horizons.size(); ++i)
      (hidden[i] ? horizons[i].hidden : horizons[i].free) =
          (horizons[i].hidden + horizons[i].free) / 2;
  }
  for (const Horizon& horizon : horizons)
    shares[horizon.point] +=
        weight * static_cast<float>((1 - (horizon.hidden + horizon.free) / 2) / 2);
}

}  // namespace

std::vector<std::uint8_t> stopped(const Terrain& terrain, std::span<const Ray> rays) {
  std::vector<std::uint8_t> stops(rays.size());
  TraceCounts counts;
  occluded(terrain, rays, stops, counts);
  return stops;
}

std::vector<float> sun_shares(const Terrain& terrain, const Light& light,
                              std::span<const Hit> points, std::int64_t& shadow_rays) {
  std::vector<float> shares(points.size(), 0);
  SunRays rays(terrain, points);
  if (light.sun_radius_rad > 0) {
    const SunDisc disc(light);
    double area = 0;
    for (int strip = 0; strip < kStrips; ++strip) area += SunDisc::half_height(strip);
    for (int strip = 0; strip < kStrips; ++strip)
      add_strip(disc, strip, rays, shares, static_cast<float>(SunDisc::half_height(strip) / area),
                shadow_rays);
  } else {
    for (std::size_t i = 0; i < points.size(); ++i) rays.add(i, light.towards_sun);
    const std::vector<std::uint8_t> hidden = rays.send(shadow_rays);
    for (std::size_t i = 0; i < points.size(); ++i) shares[i] = hidden[i] ? 0.0F : 1.0F;
  }
  return shares;
}

}  // namespace terrview
