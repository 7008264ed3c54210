// The colour of a palette that is nearest to a colour.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "quantize/color.h"

namespace terrview {

enum class ColorDifference { rgb, oklab, ciede2000 };

// Promise, tested: find() agrees with a search through the whole palette; of equally near colours
// it takes the first.
class NearestColor {
 public:
  // Of at least one colour. Euclidean differences (rgb, oklab) are searched in a k-d tree,
  // CIEDE2000 by trying every colour.
  NearestColor(Palette palette, ColorDifference difference);

  [[nodiscard]] std::uint32_t find(Rgb8 color) const;

  // The same among the other colours; `address` itself if it is the only one.
  [[nodiscard]] std::uint32_t nearest_other(std::uint32_t address) const;

 private:
  struct Point {
    glm::dvec3 place;
    std::uint32_t address;
  };
  struct Search {
    glm::dvec3 target;
    std::uint32_t excluded;
    double nearest;  // squared for Euclidean differences
    std::uint32_t address;
  };

  [[nodiscard]] glm::dvec3 place_of(Rgb8 color) const;
  [[nodiscard]] std::uint32_t search_for(const glm::dvec3& target, std::uint32_t excluded) const;
  void build(std::size_t begin, std::size_t end, int axis);
  void search(std::size_t begin, std::size_t end, int axis, Search& state) const;
  void try_point(const Point& point, Search& state) const;

  Palette palette_;
  ColorDifference difference_;
  std::vector<Point> points_;  // each range's middle parts the range; below it are ranges again
};

}  // namespace terrview
