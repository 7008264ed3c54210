// How much light a smooth surface mirrors.
#pragma once

namespace terrview {

// The share of unpolarised light that is mirrored where it comes upon matter of the relative
// refractive index `index`, at an angle of the cosine given to the normal: the mean of Fresnel's
// two polarisations, exactly. 1 at a grazing angle, and beyond total reflection (index < 1).
[[nodiscard]] double fresnel_reflectance(double cosine, double index);

}  // namespace terrview
