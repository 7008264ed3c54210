// How far a rewritten picture is from the picture.
#pragma once

#include "bench/quantize/picture.h"

namespace terrview {

struct PictureErrors {
  double mean_component = 0;  // of the largest of a pixel's three differences
  int max_component = 0;
  double mean_ciede2000 = 0;
  double max_ciede2000 = 0;
  // Of the pairs of neighbours that are not seen apart in the picture (CIEDE2000 under 0.5), the
  // share that is once rewritten (1 or more): steps of the palette in smooth places.
  double banding = 0;
};

[[nodiscard]] PictureErrors picture_errors(const Picture& picture, const Rewritten& rewritten);

}  // namespace terrview
