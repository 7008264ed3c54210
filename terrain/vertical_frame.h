// Where a height stands in the view frame.
//
// View frame: origin at the eye, x east, y north, z up, metres. The ground point (x, y) lies at the
// geodesic distance s = |(x, y)| and azimuth of (x, y) from the eye, and a point of height h above
// it has the z for which its apparent elevation angle is atan(z / s):
//
//   z = drop(s) + stretch(s) * w(h)
//   drop = -s tan(gamma / 2) + k s^2 / (2 R),  stretch = gamma / sin(gamma),  gamma = s / R,
//   w = R (h - h_eye) / (R + h)
//
// R is the ellipsoid's radius of curvature at the eye along the azimuth (Euler's formula) and k the
// geodetic coefficient of refraction. With both curvatures zero the Earth is flat and z = h -
// h_eye.
//
// Error: under 1e-6 rad of elevation to 100 km, against geocentric coordinates on the ellipsoid.
#pragma once

#include <glm/vec2.hpp>

namespace terrview {

struct VerticalFrame {
  double eye_height_m = 0;           // in scene heights, z_scale included
  double z_scale = 1;                // heights of grids are multiplied by this
  double north_curvature_per_m = 0;  // 1 / R along the meridian at the eye; 0 on a flat Earth
  double east_curvature_per_m = 0;   // 1 / R across the meridian
  double refraction = 0;             // k; light bends with the radius R / k

  [[nodiscard]] bool is_flat() const {
    return north_curvature_per_m == 0 && east_curvature_per_m == 0;
  }

  // The functions of one ground point.
  class Column {
   public:
    Column(double drop_m, double stretch, double curvature_per_m, double eye_height_m)
        : drop_m_(drop_m),
          stretch_(stretch),
          curvature_per_m_(curvature_per_m),
          eye_height_m_(eye_height_m) {}

    // z of a point of height `scene_height_m` (z_scale included).
    [[nodiscard]] double z_m(double scene_height_m) const {
      return drop_m_ +
             stretch_ * (scene_height_m - eye_height_m_) / (1 + curvature_per_m_ * scene_height_m);
    }

    // dz/dh at that height.
    [[nodiscard]] double slope(double scene_height_m) const {
      const double shrink = 1 + curvature_per_m_ * scene_height_m;
      return stretch_ * (1 + curvature_per_m_ * eye_height_m_) / (shrink * shrink);
    }

    // The inverse of z_m().
    [[nodiscard]] double scene_height_m(double z_m) const {
      const double w = (z_m - drop_m_) / stretch_;
      return (w + eye_height_m_) / (1 - curvature_per_m_ * w);
    }

   private:
    double drop_m_;
    double stretch_;
    double curvature_per_m_;
    double eye_height_m_;
  };

  // The column above the ground point (x, y) of the view frame.
  [[nodiscard]] Column at(glm::dvec2 ground_m) const;

  // An upper bound (but for rounding) of z for scene heights up to `scene_height_m` above the
  // ground segment from `a_m` to `b_m`. Needs refraction <= 1.
  [[nodiscard]] double ceiling_between(double scene_height_m, glm::dvec2 a_m, glm::dvec2 b_m) const;

  // An upper bound of z for scene heights up to `scene_height_m`, within `reach_m` of the eye.
  [[nodiscard]] double ceiling_m(double scene_height_m, double reach_m) const;

  // How the height of a straight line above the ellipsoid bends: at the distance g from a point it
  // lies at least `least_m` and at most `most_per_m2 (1 + 2 slope^2) g^2 - least_m` above its
  // tangent there, while its scene height stays within `height_bound_m` of 0. The tangent is that
  // of the line over an Earth as round in all directions as it is towards the point: next to the
  // eye the curvature turns with the azimuth. Needs is_convex().
  struct Bend {
    double least_m;
    double most_per_m2;
  };
  [[nodiscard]] Bend bend(double height_bound_m) const;
  // Within `reach_m` of the eye.
  [[nodiscard]] bool is_convex(double reach_m) const;

  // Bounds (but for rounding) of dz/dh for scene heights from `lowest_m` to `highest_m`, within
  // `reach_m` of the eye.
  struct Slopes {
    double least;
    double most;
  };
  [[nodiscard]] Slopes slopes(double lowest_m, double highest_m, double reach_m) const;
};

}  // namespace terrview
