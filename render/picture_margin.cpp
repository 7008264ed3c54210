#include "render/picture_margin.h"

#include <algorithm>
#include <cmath>

namespace terrview {
namespace {

// Pixels from `first` to before `end`.
struct Span {
  int first;
  int end;
};

// Of a division downwards: from 0 to before `divisor`.
int remainder(int number, int divisor) {
  const int rest = number % divisor;
  return rest < 0 ? rest + divisor : rest;
}

int block_below(int pixel, int block_px) { return pixel - remainder(pixel, block_px); }

Span widened(const Span& span, int reach_px, int block_px) {
  return {block_below(span.first - reach_px, block_px),
          block_below(span.end + reach_px + block_px - 1, block_px) + 1};
}

Span within(const Span& span, int end) {
  return {std::max(0, span.first), std::min(end, span.end)};
}

// The image's first column in its picture, counted from the first of its circle where it has one.
int first_column(const Camera& camera) {
  if (camera.circle_px() == 0) return camera.first_px().x;
  const int east_px = static_cast<int>(std::floor(camera.east_px()));
  // Parts of a picture count on beyond the circle's end.
  return camera.first_px().x + remainder(east_px - camera.first_px().x, camera.circle_px());
}

}  // namespace

PixelRect with_margin(const Camera& camera, int reach_px, int block_px) {
  const glm::ivec2 size = camera.options().size_px;
  const bool round = camera.circle_px() > 0;
  const glm::ivec2 first(first_column(camera), camera.first_px().y);
  Span across = widened({first.x, first.x + size.x}, reach_px, block_px);
  if (!round) across = within(across, camera.whole_px().x);
  const Span down =
      within(widened({first.y, first.y + size.y}, reach_px, block_px), camera.whole_px().y);
  return {glm::ivec2(across.first, down.first) - first,
          {across.end - across.first, down.end - down.first}};
}

}  // namespace terrview
