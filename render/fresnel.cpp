#include "render/fresnel.h"

#include <algorithm>
#include <cmath>

namespace terrview {

double fresnel_reflectance(double cosine, double index) {
  const double c = std::clamp(cosine, 0.0, 1.0);
  const double squared = index * index - 1 + c * c;
  if (c == 0 || squared <= 0) return 1;
  // The index times the cosine of the refracted ray, by Snell's law.
  const double refracted = std::sqrt(squared);
  const double across = (c - refracted) / (c + refracted);
  const double along = (index * index * c - refracted) / (index * index * c + refracted);
  return (across * across + along * along) / 2;
}

}  // namespace terrview
