// How far down is the ground from 100 m above it? To 1e-4, the view frame's scale there.
#include <cmath>

#include "ingest/view_frame.h"

int main(int, char** argv) {
  const terrview::EyePlace eye{
      .geographic = terrview::GeoPoint{48.012, 7.005}, .height_m = 100, .above_ground = true};
  const terrview::ViewFrame frame(terrview::read_dems({argv[1]}), eye, {});
  const auto hit = frame.terrain()->first_hit({.direction = {0, 0, -1}});
  return hit && std::abs(hit->distance_m - 100) < 0.01 ? 0 : 1;
}
