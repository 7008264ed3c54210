#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "terrain/directions_at.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "terrain/vec_inline.h"
#include "terrain/vector_ground-inl.h"
#include "terrain/vertical_math.h"
#include "terrain/view_transform.h"

HWY_BEFORE_NAMESPACE();
namespace terrview {
namespace HWY_NAMESPACE {

// As direction_at(), lane by lane, where the series hold and the eye's plumb line is not near.
class TurnedLight {
 public:
  TurnedLight(const VerticalFrame& frame, const glm::dvec3& true_direction)
      : frame_(frame),
        earth_(frame),
        x_(of(true_direction.x)),
        y_(of(true_direction.y)),
        z_(of(true_direction.z)) {}

  struct Directions {
    V x, y, z;
    M known;
  };

  VEC_INLINE Directions at(V view_x, V view_y, V view_z) const {
    const V view_curvature = earth_.curvature(view_x, view_y);
    const V s = hn::Sqrt(view_x * view_x + view_y * view_y);
    const V gamma = s * view_curvature;
    const V gamma2 = gamma * gamma;
    const V sinc = series(kSinc, gamma2);
    const V cosine = series(kCosine, gamma2);
    const V refraction = of(frame_.refraction);
    const V sunk = view_z - refraction * view_curvature * s * s / of(2);
    const V eye = of(frame_.eye_height_m);
    const V to_true =
        (of(1) + view_curvature * eye) * sinc / (cosine - view_curvature * sunk * sinc);
    const V east = to_true * view_x;
    const V north = to_true * view_y;
    const V up_m = to_true * sunk;

    const V curvature = earth_.curvature(east, north);
    const V rho = hn::Sqrt(east * east + north * north);
    const V up = of(1) + curvature * (eye + up_m);
    const V out_x = east / rho;
    const V out_y = north / rho;
    const V d_rho = out_x * x_ + out_y * y_;
    const V scale = s / rho;
    const V d_s =
        (up * d_rho - curvature * rho * z_) / (up * up + curvature * curvature * rho * rho);
    const V d_scale = (d_s - scale * d_rho) / rho;
    const V d_z = scale * z_ + up_m * d_scale + refraction * curvature * s * d_s;
    const V d_x = d_s * out_x + scale * (x_ - d_rho * out_x);
    const V d_y = d_s * out_y + scale * (y_ - d_rho * out_y);
    const V inverse = of(1) / hn::Sqrt(d_x * d_x + d_y * d_y + d_z * d_z);
    return {d_x * inverse, d_y * inverse, d_z * inverse,
            hn::And(gamma2 <= of(kSeriesLimit), rho >= of(kPlumbLine_m))};
  }

 private:
  const VerticalFrame& frame_;
  VectorFrame earth_;
  V x_, y_, z_;
};

void turn_light(const VerticalFrame& frame, std::span<const glm::dvec3> view_m,
                const glm::dvec3& true_direction, std::span<glm::dvec3> directions) {
  using Lanes = std::array<double, kVectorLanes>;
  alignas(64) Lanes x{};
  alignas(64) Lanes y{};
  alignas(64) Lanes z{};
  const TurnedLight light(frame, true_direction);
  const std::size_t lanes = hn::Lanes(D());
  for (std::size_t first = 0; first < view_m.size(); first += lanes) {
    const std::size_t count = std::min(lanes, view_m.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = view_m[first + i].x;
      y[i] = view_m[first + i].y;
      z[i] = view_m[first + i].z;
    }
    const TurnedLight::Directions found =
        light.at(hn::Load(D(), x.data()), hn::Load(D(), y.data()), hn::Load(D(), z.data()));
    hn::Store(found.x, D(), x.data());
    hn::Store(found.y, D(), y.data());
    hn::Store(found.z, D(), z.data());
    const std::uint32_t known = bits_of(found.known);
    for (std::size_t i = 0; i < count; ++i)
      directions[first + i] = (known >> i & 1) != 0
                                  ? glm::dvec3(x[i], y[i], z[i])
                                  : direction_at(frame, view_m[first + i], true_direction);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace terrview
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace terrview {

HWY_EXPORT(turn_light);

void directions_at(const VerticalFrame& frame, std::span<const glm::dvec3> view_m,
                   const glm::dvec3& true_direction, std::span<glm::dvec3> directions) {
  if (frame.is_flat())
    std::fill_n(directions.begin(), view_m.size(), true_direction);
  else
    HWY_DYNAMIC_DISPATCH(turn_light)(frame, view_m, true_direction, directions);
}

}  // namespace terrview
#endif
