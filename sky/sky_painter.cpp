#include "sky/sky_painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace terrview {
namespace {

// Between the two samples that tell a cloud's lit side, in root cells.
constexpr double kSunStep_cells = 0.045;
// Sunward samples may be coarser: their difference is of that many pixels.
constexpr double kSunwardLeaf_px = 3;
// The halo is half as bright this far from the sun's middle.
constexpr double kHalo_rad = 0.035;

float smooth_step(float share) {
  share = std::clamp(share, 0.0F, 1.0F);
  return share * share * (3 - 2 * share);
}

// The share of the sky that is more cloud than clear, the field's values being normal.
double mean_cover(const ColorTable& table) {
  const double middle = (table.clear_until + table.cloud_from) / 2;
  return std::erfc((middle - table.window.middle) / table.window.width / std::numbers::sqrt2) / 2;
}

// The layer as seen from a place some way towards the sun.
CloudLayer sunward(CloudLayer layer, const glm::dvec3& towards_sun) {
  layer.origin_m += glm::dvec2(towards_sun) * (kSunStep_cells * layer.cell_m);
  return layer;
}

}  // namespace

SkyPainter::SkyPainter(SkyOptions options, const SkyCamera& camera)
    : options_(std::move(options)),
      camera_(camera),
      clear_(options_.clear),
      pixel_rad_(static_cast<float>(1 / camera.focal_px)) {
  const double elevation_rad = std::asin(std::clamp(options_.clear.towards_sun.z, -1.0, 1.0));
  const auto dimming = static_cast<float>(dusk_dimming(elevation_rad));
  sunlight_ = sunlight(elevation_rad, options_.clear.turbidity);
  skylight_ = 0.5F * (clear_.color({0, 0, 1}) + clear_.horizon_color()) + glm::vec3(0.1F) * dimming;
  // A set sun has no disc.
  if (elevation_rad < -options_.sun_radius_rad) options_.sun_radius_rad = 0;
  if (!options_.clouds) return;
  const Clouds& clouds = *options_.clouds;
  field_.emplace(clouds.field);
  density_.emplace(*field_, clouds.layer, camera, options_.leaf_px);
  sunward_.emplace(*field_, sunward(clouds.layer, options_.clear.towards_sun), camera,
                   options_.leaf_px * kSunwardLeaf_px);
  colors_.emplace(clouds.table);
  // Above the clouds the sky is clear.
  if (clouds.layer.height_m > 0)
    veil_ = 0.75F * static_cast<float>(std::pow(mean_cover(clouds.table), 2));
  addresses_per_unit_ =
      static_cast<float>(clouds.table.window.width / field_->expected_deviation());
}

std::vector<glm::vec3> SkyPainter::paint(const PixelWindow& window) const {
  std::vector<CloudSample> density(window.wanted.size());
  std::vector<CloudSample> towards_sun(window.wanted.size());
  if (density_) {
    density = density_->paint(window);
    towards_sun = sunward_->paint(window);
  }
  std::vector<glm::vec3> colors(window.wanted.size(), glm::vec3(0));
  for (int row = 0; row < window.size_px.y; ++row) {
    for (int column = 0; column < window.size_px.x; ++column) {
      const auto k = static_cast<std::size_t>(row * window.size_px.x + column);
      if (window.wanted[k])
        colors[k] = composed(window.first_px + glm::ivec2(column, row), density[k], towards_sun[k]);
    }
  }
  return colors;
}

glm::vec3 SkyPainter::color(const glm::ivec2& pixel) const {
  if (!density_) return composed(pixel, {}, {});
  return composed(pixel, density_->value(pixel), sunward_->value(pixel));
}

glm::vec3 SkyPainter::clear_color(const glm::dvec3& direction) const {
  const double cosine = glm::dot(direction, options_.clear.towards_sun);
  return background(direction) + sun_and_halo(std::acos(std::clamp(cosine, -1.0, 1.0)));
}

glm::vec3 SkyPainter::background(const glm::dvec3& direction) const {
  const glm::vec3 clear = clear_.color(direction);
  if (veil_ == 0) return clear;
  const float luminance = glm::dot(clear, glm::vec3(0.2126F, 0.7152F, 0.0722F));
  return glm::mix(clear, glm::vec3(0.85F * luminance), veil_);
}

glm::vec3 SkyPainter::sun_and_halo(double angle_rad) const {
  const auto radius = static_cast<float>(options_.sun_radius_rad);
  const float beyond = (static_cast<float>(angle_rad) - radius) / pixel_rad_;
  const float disc = radius > 0 ? std::clamp(0.5F - beyond, 0.0F, 1.0F) : 0;
  const auto share = static_cast<float>(angle_rad / kHalo_rad);
  const float halo = static_cast<float>(options_.halo) / (1 + share * share);
  // The disc is whitish even where its light on the ground is red.
  return halo * sunlight_ + disc * 3.0F * glm::mix(sunlight_, glm::vec3(sunlight_.r), 0.35F);
}

glm::vec3 SkyPainter::cloud_color(float address, float lit, double angle_to_sun_rad,
                                  float cover) const {
  // Thin rims near the sun shine.
  const auto ahead = static_cast<float>(std::exp(-angle_to_sun_rad / 0.25));
  const float rim = 1 + 1.2F * ahead * (1 - 0.7F * cover);
  const float side = std::clamp(0.85F + 4.0F * lit, 0.35F, 1.3F);
  return colors_->at(address) * (0.72F * side * rim * sunlight_ + 0.60F * skylight_);
}

glm::vec3 SkyPainter::composed(const glm::ivec2& pixel, const CloudSample& density,
                               const CloudSample& towards_sun) const {
  const glm::dvec3 direction = glm::normalize(camera_.direction(glm::dvec2(pixel) + 0.5));
  const glm::vec3 sky = background(direction);
  const double cosine = glm::dot(direction, options_.clear.towards_sun);
  const double angle_rad = std::acos(std::clamp(cosine, -1.0, 1.0));
  if (std::isnan(density.value)) return sky + sun_and_halo(angle_rad);

  const Clouds& clouds = *options_.clouds;
  const auto middle = static_cast<float>(clouds.table.window.middle);
  const float address = middle + addresses_per_unit_ * density.value;
  const auto clear_until = static_cast<float>(clouds.table.clear_until);
  const auto cloud_from = static_cast<float>(clouds.table.cloud_from);
  const float cover = smooth_step((address - clear_until) / (cloud_from - clear_until));
  const float less = std::isnan(towards_sun.value) ? 0 : density.value - towards_sun.value;
  const float lit = addresses_per_unit_ * less;
  const glm::vec3 cloud = cloud_color(std::max(address, cloud_from), lit, angle_rad, cover);
  const auto seen = static_cast<float>(
      std::exp(-clouds.extinction_per_m * static_cast<double>(density.distance_m)));
  return glm::mix(sky, cloud, cover * seen) + (1 - cover) * sun_and_halo(angle_rad);
}

}  // namespace terrview
