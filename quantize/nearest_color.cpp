#include "quantize/nearest_color.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "quantize/color_difference.h"

namespace terrview {
namespace {

constexpr std::uint32_t kNoAddress = 0xFFFFFFFF;
constexpr std::size_t kSmallRange = 4;  // tried one by one

}  // namespace

NearestColor::NearestColor(Palette palette, ColorDifference difference)
    : palette_(std::move(palette)), difference_(difference) {
  assert(!palette_.empty());
  points_.reserve(palette_.size());
  for (const Rgb8 color : palette_)
    points_.push_back({place_of(color), static_cast<std::uint32_t>(points_.size())});
  if (difference_ != ColorDifference::ciede2000) build(0, points_.size(), 0);
}

glm::dvec3 NearestColor::place_of(Rgb8 color) const {
  switch (difference_) {
    case ColorDifference::rgb:
      break;
    case ColorDifference::oklab:
      return oklab(color);
    case ColorDifference::ciede2000:
      return cielab(color);
  }
  return glm::dvec3(color);
}

void NearestColor::build(std::size_t begin, std::size_t end, int axis) {
  if (end - begin <= kSmallRange) return;
  const std::size_t middle = (begin + end) / 2;
  const auto at = [this](std::size_t i) {
    return points_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::nth_element(at(begin), at(middle), at(end), [axis](const Point& a, const Point& b) {
    return a.place[axis] < b.place[axis];
  });
  build(begin, middle, (axis + 1) % 3);
  build(middle + 1, end, (axis + 1) % 3);
}

void NearestColor::try_point(const Point& point, Search& state) const {
  if (point.address == state.excluded) return;
  const glm::dvec3 step = point.place - state.target;
  const double difference = difference_ == ColorDifference::ciede2000
                                ? ciede2000(point.place, state.target)
                                : glm::dot(step, step);
  if (difference > state.nearest) return;
  if (difference == state.nearest && point.address > state.address) return;
  state.nearest = difference;
  state.address = point.address;
}

void NearestColor::search(std::size_t begin, std::size_t end, int axis, Search& state) const {
  if (end - begin <= kSmallRange) {
    for (std::size_t i = begin; i < end; ++i) try_point(points_[i], state);
    return;
  }
  const std::size_t middle = (begin + end) / 2;
  const double beyond = state.target[axis] - points_[middle].place[axis];
  const int next = (axis + 1) % 3;
  try_point(points_[middle], state);
  if (beyond < 0)
    search(begin, middle, next, state);
  else
    search(middle + 1, end, next, state);
  if (beyond * beyond > state.nearest) return;
  if (beyond < 0)
    search(middle + 1, end, next, state);
  else
    search(begin, middle, next, state);
}

std::uint32_t NearestColor::search_for(const glm::dvec3& target, std::uint32_t excluded) const {
  Search state{target, excluded, std::numeric_limits<double>::infinity(), kNoAddress};
  if (difference_ == ColorDifference::ciede2000)
    for (const Point& point : points_) try_point(point, state);
  else
    search(0, points_.size(), 0, state);
  return state.address == kNoAddress ? excluded : state.address;
}

std::uint32_t NearestColor::find(Rgb8 color) const {
  return search_for(place_of(color), kNoAddress);
}

std::uint32_t NearestColor::nearest_other(std::uint32_t address) const {
  return search_for(place_of(palette_[address]), address);
}

}  // namespace terrview
