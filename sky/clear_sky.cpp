#include "sky/clear_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace terrview {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegrees = 180 / kPi;
constexpr double kLeastUp = 0.01;                       // Perez's formula has 1 / up
constexpr double kLowestModelSun_rad = 0.5 / kDegrees;  // lower ones are twilight's
constexpr double kTwilightFrom_deg = 9;
constexpr double kWhite_kcd = 15;  // this luminance is 1, before compression
constexpr std::size_t kSteps = 1024;

struct Perez {
  double a, b, c, d, e;

  [[nodiscard]] double height_factor(double up) const {
    return 1 + a * std::exp(b / std::max(up, kLeastUp));
  }
  [[nodiscard]] double angle_factor(double angle_rad) const {
    const double cosine = std::cos(angle_rad);
    return 1 + c * std::exp(d * angle_rad) + e * cosine * cosine;
  }
};

// For x, y and Y, as the tables of the paper's appendix A.2 have them.
std::array<Perez, 3> perez(double t) {
  return {{{-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
            -0.0033 * t + 0.0452},
           {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
            -0.0109 * t + 0.0529},
           {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
            -0.0670 * t + 0.3703}}};
}

// x, y and Y overhead.
glm::dvec3 zenith(double t, double s) {
  const double s2 = s * s;
  const double s3 = s2 * s;
  const double x = (0.00166 * s3 - 0.00375 * s2 + 0.00209 * s) * t * t +
                   (-0.02903 * s3 + 0.06377 * s2 - 0.03202 * s + 0.00394) * t +
                   (0.11693 * s3 - 0.21196 * s2 + 0.06052 * s + 0.25886);
  const double y = (0.00275 * s3 - 0.00610 * s2 + 0.00317 * s) * t * t +
                   (-0.04214 * s3 + 0.08970 * s2 - 0.04153 * s + 0.00516) * t +
                   (0.15346 * s3 - 0.26756 * s2 + 0.06670 * s + 0.26688);
  const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * s);
  const double luminance = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
  return {x, y, luminance};
}

// The y of the CIE's daylight locus (from x = 0.25 to 0.38).
float daylight_locus(float x) { return (2.870F - 3.000F * x) * x - 0.275F; }

// A white plain in sun and skylight is white in the picture, as film and eye balance it: D55.
glm::vec3 balanced_rec709(const glm::vec3& xyY) {
  const glm::vec3 white(1.0898F, 0.9851F, 0.7988F);  // D55 at Y = 1 in Rec. 709
  const float scale = xyY.z / xyY.y;
  const glm::vec3 xyz(xyY.x * scale, xyY.z, (1 - xyY.x - xyY.y) * scale);
  return glm::vec3(3.2404542F * xyz.x - 1.5371385F * xyz.y - 0.4985314F * xyz.z,
                   -0.9692660F * xyz.x + 1.8760108F * xyz.y + 0.0415560F * xyz.z,
                   0.0556434F * xyz.x - 0.2040259F * xyz.y + 1.0572252F * xyz.z) /
         white;
}

glm::vec3 interpolated(const std::vector<glm::vec3>& table, double share) {
  const double step = std::clamp(share, 0.0, 1.0) * static_cast<double>(kSteps - 1);
  const auto i = std::min(static_cast<std::size_t>(step), kSteps - 2);
  return glm::mix(table[i], table[i + 1], static_cast<float>(step - static_cast<double>(i)));
}

double smooth(double from, double to, double x) {
  const double share = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

double optical_mass(double elevation_rad) {
  const double degrees = std::max(0.0, elevation_rad * kDegrees);
  return 1 / (std::sin(degrees / kDegrees) + 0.15 * std::pow(degrees + 3.885, -1.253));
}

}  // namespace

glm::dvec3 preetham_xyY(double turbidity, double sun_zenith_rad, double up,
                        double angle_to_sun_rad) {
  const std::array<Perez, 3> coefficients = perez(turbidity);
  glm::dvec3 result = zenith(turbidity, sun_zenith_rad);
  for (int k = 0; k < 3; ++k) {
    const Perez& p = coefficients[static_cast<std::size_t>(k)];
    result[k] *= p.height_factor(up) * p.angle_factor(angle_to_sun_rad) /
                 (p.height_factor(1) * p.angle_factor(sun_zenith_rad));
  }
  return result;
}

glm::vec3 sunlight(double sun_elevation_rad, double turbidity) {
  constexpr std::array<double, 3> kWavelengths_um{0.68, 0.55, 0.44};
  constexpr double kHighSunMass = 1.2;
  constexpr double kHeaviestMass = 14;
  const double mass = std::min(optical_mass(sun_elevation_rad), kHeaviestMass) - kHighSunMass;
  const double haze = 0.04608 * turbidity - 0.04586;
  const double left = smooth(-6, 0, sun_elevation_rad * kDegrees);
  glm::vec3 light;
  for (int k = 0; k < 3; ++k) {
    const double wavelength_um = kWavelengths_um[static_cast<std::size_t>(k)];
    const double depth =
        0.008735 * std::pow(wavelength_um, -4.08) + haze * std::pow(wavelength_um, -1.3);
    light[k] = static_cast<float>(std::exp(-depth * std::max(0.0, mass)) * left);
  }
  return light;
}

double dusk_dimming(double sun_elevation_rad) {
  struct Step {
    double elevation_deg;
    double logarithm;
  };
  static constexpr std::array<Step, 5> kSteps{
      {{-18, -4.4}, {-12, -3.5}, {-6, -1.8}, {0, -0.43}, {5, 0}}};
  const double degrees = sun_elevation_rad * kDegrees;
  if (degrees <= kSteps.front().elevation_deg) return std::exp(kSteps.front().logarithm);
  for (std::size_t i = 1; i < kSteps.size(); ++i) {
    const Step& low = kSteps[i - 1];
    const Step& high = kSteps[i];
    if (degrees > high.elevation_deg) continue;
    const double share = (degrees - low.elevation_deg) / (high.elevation_deg - low.elevation_deg);
    return std::exp(low.logarithm + share * (high.logarithm - low.logarithm));
  }
  return 1;
}

ClearSky::ClearSky(const ClearSkyOptions& options)
    : options_(options),
      sun_elevation_rad_(std::asin(std::clamp(options.towards_sun.z, -1.0, 1.0))),
      shown_sun_(options.towards_sun),
      dimming_(static_cast<float>(dusk_dimming(sun_elevation_rad_))) {
  const double shown_rad = std::max(sun_elevation_rad_, kLowestModelSun_rad);
  const double run = std::hypot(shown_sun_.x, shown_sun_.y);
  if (shown_rad > sun_elevation_rad_ && run > 0) {
    const double longer = std::cos(shown_rad) / run;
    shown_sun_ = {shown_sun_.x * longer, shown_sun_.y * longer, std::sin(shown_rad)};
  }
  const double sun_zenith_rad = kPi / 2 - shown_rad;
  const std::array<Perez, 3> coefficients = perez(options.turbidity);
  const glm::dvec3 overhead = zenith(options.turbidity, sun_zenith_rad);
  for (std::size_t step = 0; step < kSteps; ++step) {
    const double share = static_cast<double>(step) / static_cast<double>(kSteps - 1);
    glm::vec3 height;
    glm::vec3 angle;
    for (int k = 0; k < 3; ++k) {
      const Perez& p = coefficients[static_cast<std::size_t>(k)];
      height[k] = static_cast<float>(overhead[k] * p.height_factor(share) / p.height_factor(1));
      angle[k] =
          static_cast<float>(p.angle_factor(2 * std::asin(share)) / p.angle_factor(sun_zenith_rad));
    }
    by_height_.push_back(height);
    by_angle_.push_back(angle);
  }
}

glm::vec3 ClearSky::daylight(double up, double cos_to_sun) const {
  if (options_.model == SkyModel::gradient) {
    const glm::vec3 horizon(0.56F, 0.68F, 0.82F);
    const glm::vec3 overhead(0.08F, 0.20F, 0.52F);
    const double low = 1 - up;
    return dimming_ * glm::mix(horizon, overhead, static_cast<float>(1 - low * low * low));
  }
  const double half_sine = std::sqrt(std::max(0.0, 1 - cos_to_sun) / 2);
  glm::vec3 xyY = interpolated(by_height_, up) * interpolated(by_angle_, half_sine);
  xyY.y = std::max(xyY.y, daylight_locus(xyY.x));
  xyY.z = dimming_ * (1 - std::exp(-1.25F * xyY.z / static_cast<float>(kWhite_kcd)));
  return glm::max(balanced_rec709(xyY), glm::vec3(0));
}

glm::vec3 ClearSky::with_twilight(const glm::vec3& day, const glm::dvec3& direction) const {
  const double sun_deg = sun_elevation_rad_ * kDegrees;
  if (sun_deg > kTwilightFrom_deg) return day;
  const double up = std::clamp(direction.z, 0.0, 1.0);
  const double up_deg = std::asin(up) * kDegrees;
  const glm::dvec3& sun = options_.towards_sun;
  const double runs = std::hypot(direction.x, direction.y) * std::hypot(sun.x, sun.y);
  const double facing = runs > 0 ? (direction.x * sun.x + direction.y * sun.y) / runs : 0;
  const double near_sun = std::pow(0.5 + 0.5 * facing, 2);

  // The blue hour's gradient takes the place of a model that knows no sunken sun.
  const auto low = static_cast<float>(std::pow(1 - up, 4));
  const glm::vec3 blue =
      dimming_ * glm::mix(glm::vec3(0.09F, 0.17F, 0.42F), glm::vec3(0.46F, 0.50F, 0.62F), low);
  glm::vec3 color =
      glm::mix(day, blue, static_cast<float>(0.95 * smooth(kTwilightFrom_deg, 0, sun_deg)));
  // The glow: yellow at the horizon, redder above it and the lower the sun.
  const double strength = smooth(kTwilightFrom_deg, 0, sun_deg) * (1 - smooth(-5, -16, sun_deg));
  const double height_deg =
      (4 + 11 * near_sun + 0.4 * std::max(0.0, sun_deg)) * (0.4 + 0.6 * smooth(-9, 1, sun_deg));
  const double band = std::exp(-std::pow(up_deg / height_deg, 1.3));
  const auto glow = static_cast<float>(strength * band * (0.10 + 0.90 * near_sun));
  const auto red = static_cast<float>(smooth(-1, 13, up_deg - 1.2 * sun_deg));
  const glm::vec3 warm =
      glm::mix(glm::vec3(1.05F, 0.66F, 0.28F), glm::vec3(0.88F, 0.30F, 0.17F), red);
  color = glm::mix(color, warm * (0.25F + 0.75F * dimming_), glow);
  // Opposite, the belt of Venus above the Earth's shadow.
  const double belt = std::exp(-std::pow((up_deg - 8 + sun_deg) / 6, 2)) *
                      std::pow(0.5 - 0.5 * facing, 2) * smooth(3, -1, sun_deg) *
                      (1 - smooth(-3, -8, sun_deg));
  return glm::mix(color, dimming_ * glm::vec3(0.78F, 0.50F, 0.58F),
                  0.7F * static_cast<float>(belt));
}

glm::vec3 ClearSky::color(const glm::dvec3& direction) const {
  glm::dvec3 shown = direction;
  const double across = glm::length(glm::dvec2(direction));
  if (direction.z < 0 && across > 0) shown = {glm::dvec2(direction) / across, 0};
  return with_twilight(daylight(std::clamp(shown.z, 0.0, 1.0), glm::dot(shown, shown_sun_)), shown);
}

glm::vec3 ClearSky::horizon_color() const {
  constexpr int kDirections = 36;
  glm::vec3 sum(0);
  for (int k = 0; k < kDirections; ++k) {
    const double azimuth_rad = 2 * kPi * k / kDirections;
    sum += color({std::sin(azimuth_rad), std::cos(azimuth_rad), 0});
  }
  return sum / static_cast<float>(kDirections);
}

}  // namespace terrview
