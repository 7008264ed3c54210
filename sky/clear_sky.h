// The sky without clouds, and sunlight.
//
// Model `preetham`: A. J. Preetham, P. Shirley & B. Smits, A Practical Analytic Model for Daylight,
// SIGGRAPH 1999: Perez's luminance distribution with coefficients linear in the turbidity, for
// turbidities from 2 to 6 and a sun above the horizon. Where its chromaticities lie on the purple
// side of the CIE's daylight locus, as near the horizon, they are lifted onto it. Luminance is
// scaled so that a white plain in full sun is about 1, and its brightest part compressed as film
// does. Under 5 degrees of sun the sky darkens as an adapted eye sees it, far less than nature's,
// and a glow over the sun's place takes over, fading until the sun is 16 degrees down; both chosen
// by eye.
//
// Model `gradient`: a blue that pales towards the horizon (Coquillart 1984, chapter 4, 1.1).
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace terrview {

enum class SkyModel { preetham, gradient };

struct ClearSkyOptions {
  SkyModel model = SkyModel::preetham;
  glm::dvec3 towards_sun{0, 0, 1};  // unit length
  double turbidity = 2.5;           // 2 very clear, 6 hazy
};

// Sunlight at the ground relative to that of a high sun, whitish to red: the transmittance of the
// air at 680, 550 and 440 nm by Rayleigh's and Angstrom's laws (Preetham et al. 1999, appendix).
// It stays where it is below the horizon, for clouds see the sun for a while longer; there it fades
// out until 6 degrees down.
[[nodiscard]] glm::vec3 sunlight(double sun_elevation_rad, double turbidity);

// By how much a low or sunken sun darkens the picture: 1 from 5 degrees up on.
[[nodiscard]] double dusk_dimming(double sun_elevation_rad);

class ClearSky {
 public:
  explicit ClearSky(const ClearSkyOptions& options);

  // Linear Rec. 709 of a direction of unit length; at the horizon and below, the horizon's.
  [[nodiscard]] glm::vec3 color(const glm::dvec3& direction) const;

  // The mean all around the horizon: the colour that distant ground melts into.
  [[nodiscard]] glm::vec3 horizon_color() const;

  [[nodiscard]] const ClearSkyOptions& options() const { return options_; }

 private:
  [[nodiscard]] glm::vec3 daylight(double up, double cos_to_sun) const;
  [[nodiscard]] glm::vec3 with_twilight(const glm::vec3& day, const glm::dvec3& direction) const;

  ClearSkyOptions options_;
  double sun_elevation_rad_;
  glm::dvec3 shown_sun_;  // of the model, which needs it above the horizon
  float dimming_;
  // Perez's two factors for x, y and Y, tabled: by the direction's height, and by the sine of half
  // the angle to the sun.
  std::vector<glm::vec3> by_height_;
  std::vector<glm::vec3> by_angle_;
};

// The formula itself, without tables, dusk or compression: luminance in kcd/m^2 and chromaticity
// (x, y, Y) for a direction at `up` = cos of its zenith angle and an angle from the sun.
[[nodiscard]] glm::dvec3 preetham_xyY(double turbidity, double sun_zenith_rad, double up,
                                      double angle_to_sun_rad);

}  // namespace terrview
