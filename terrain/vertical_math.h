// The coefficients of VerticalFrame's series, shared by its scalar and its vector form.
#pragma once

#include <array>

namespace terrview {

// Below this gamma^2 (about 640 km) the truncated series are right to 1e-15.
inline constexpr double kSeriesLimit = 0.01;

// tan(gamma / 2) / gamma in powers of gamma^2.
inline constexpr std::array kHalfTangent{1.0 / 2,      1.0 / 24,      1.0 / 240,
                                         17.0 / 40320, 31.0 / 725760, 691.0 / 159667200};

// gamma / sin(gamma) in powers of gamma^2.
inline constexpr std::array kInverseSinc{1.0,          1.0 / 6,        7.0 / 360,
                                         31.0 / 15120, 127.0 / 604800, 73.0 / 3421440};

}  // namespace terrview
