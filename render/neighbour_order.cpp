#include "render/neighbour_order.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>

namespace terrview {
namespace {

// An OE so far away is at infinity: over a picture its direction does not turn.
constexpr double kInfinity_px = 1e8;

// A pixel that far from OE's row, column or diagonals, in pixels, is on them: above the rounding
// of OE.
constexpr double kOnLine_px = 1e-7;

int sign(double x) { return x > kOnLine_px ? 1 : x < -kOnLine_px ? -1 : 0; }

}  // namespace

NeighbourOrder::NeighbourOrder(const Camera& camera)
    : size_px_(camera.options().size_px), view_(View::level) {
  assert(camera.options().projection != Projection::orthographic);
  if (camera.options().projection == Projection::cylindrical) return;
  // The vertical in the camera's axes, image rows downwards.
  const glm::dvec2 across(camera.right().z, -camera.up().z);
  const double ahead = camera.forward().z;
  upward_ = across;
  const glm::dvec2 from_middle = across / (ahead * camera.per_px());
  const double away_px = std::max(std::abs(from_middle.x), std::abs(from_middle.y));
  if (!(away_px < kInfinity_px)) return;
  view_ = ahead < 0 ? View::down : View::up;
  oe_px_ = camera.middle_px() + from_middle;
}

glm::dvec2 NeighbourOrder::upward(glm::ivec2 pixel) const {
  if (view_ == View::level) return upward_;
  const glm::dvec2 from_oe = glm::dvec2(pixel) + 0.5 - oe_px_;
  return view_ == View::down ? from_oe : -from_oe;
}

bool NeighbourOrder::has(glm::ivec2 pixel) const {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x < size_px_.x && pixel.y < size_px_.y;
}

Forerunners NeighbourOrder::forerunners(glm::ivec2 pixel) const {
  const glm::dvec2 up = upward(pixel);
  const glm::dvec2 size = glm::abs(up);
  const glm::ivec2 towards(sign(up.x), sign(up.y));
  // Beside OE a step down would go past it.
  if (towards == glm::ivec2(0)) return {};
  if (view_ == View::down && std::max(size.x, size.y) <= 1 + kOnLine_px) return {};
  const glm::ivec2 diagonal = pixel - towards;
  const bool one_plane =
      towards.x == 0 || towards.y == 0 || std::abs(size.x - size.y) <= kOnLine_px;
  if (one_plane) return has(diagonal) ? Forerunners{1, diagonal, {}} : Forerunners{};
  const glm::ivec2 straight =
      pixel - (size.x > size.y ? glm::ivec2(towards.x, 0) : glm::ivec2(0, towards.y));
  if (!has(straight) || !has(diagonal)) return {};
  return {2, straight, diagonal};
}

int NeighbourOrder::ring(glm::ivec2 pixel) const {
  if (view_ == View::level) {
    const bool by_columns = std::abs(upward_.x) > std::abs(upward_.y);
    return by_columns ? sign(upward_.x) * pixel.x : sign(upward_.y) * pixel.y;
  }
  const glm::dvec2 size = glm::abs(upward(pixel));
  const int away = static_cast<int>(std::floor(std::max(size.x, size.y)));
  return view_ == View::down ? away : -away;
}

std::vector<std::vector<glm::ivec2>> NeighbourOrder::steps() const {
  std::map<int, std::vector<glm::ivec2>> by_key;
  for (int row = 0; row < size_px_.y; ++row)
    for (int column = 0; column < size_px_.x; ++column) {
      const glm::ivec2 pixel(column, row);
      const int here = ring(pixel);
      const Forerunners before = forerunners(pixel);
      // Near a diagonal the straight one lies in the same ring; its own do not.
      const bool waits = before.count == 2 && ring(before.first) == here;
      by_key[2 * here + (waits ? 1 : 0)].push_back(pixel);
    }
  std::vector<std::vector<glm::ivec2>> steps;
  for (auto& [key, pixels] : by_key) steps.push_back(std::move(pixels));
  return steps;
}

}  // namespace terrview
