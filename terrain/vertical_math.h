// The series of the vertical frame and of view_transform.h, shared by their scalar and vector
// forms.
#pragma once

#include <array>
#include <cstddef>

namespace terrview {

// Below this gamma^2 (about 640 km) the truncated series are right to 1e-15.
inline constexpr double kSeriesLimit = 0.01;

// tan(gamma / 2) / gamma in powers of gamma^2.
inline constexpr std::array kHalfTangent{1.0 / 2,      1.0 / 24,      1.0 / 240,
                                         17.0 / 40320, 31.0 / 725760, 691.0 / 159667200};

// gamma / sin(gamma) in powers of gamma^2.
inline constexpr std::array kInverseSinc{1.0,          1.0 / 6,        7.0 / 360,
                                         31.0 / 15120, 127.0 / 604800, 73.0 / 3421440};

// sin(gamma) / gamma in powers of gamma^2.
inline constexpr std::array kSinc{1.0,         -1.0 / 6,     1.0 / 120,
                                  -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800};

// cos(gamma) in powers of gamma^2.
inline constexpr std::array kCosine{1.0,        -1.0 / 2,    1.0 / 24,
                                    -1.0 / 720, 1.0 / 40320, -1.0 / 3628800};

// Horner's rule, the order of operations that every form of the series shares.
inline double series(const std::array<double, 6>& coefficients, double x) {
  double sum = coefficients[5];
  for (std::size_t i = 5; i-- > 0;) sum = coefficients[i] + x * sum;
  return sum;
}

}  // namespace terrview
