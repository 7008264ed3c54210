// Whether neighbours in a picture differ enough to be seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/image.h"
#include "render/sampling.h"

namespace terrview {

// A sample's colour as the eye tells colours apart: in sRGB, 0 to 1, to within 4e-6.
[[nodiscard]] glm::vec3 seen_color(const glm::vec3& linear);

// The largest difference of a component.
[[nodiscard]] float contrast_between(const glm::vec3& seen_a, const glm::vec3& seen_b);

// Whether two rays meet things at very different distances: a quarter of the nearer, or one of them
// nothing. An outline lies between them, whatever their colours.
[[nodiscard]] bool depth_steps(const Sample& a, const Sample& b);

// Some rows of a picture's samples and those beside them, component by component, so that whole
// rows are compared at once.
class SeenRows {
 public:
  // Rows `first` to `first + count - 1`.
  SeenRows(const Raster<Sample>& samples, int first, int count);

  // Of each pixel of one of those rows, where it is traced: the largest contrast_between() it and
  // the traced ones of its eight neighbours, but none within the sky, which is smooth; and whether
  // depth_steps() from it to one of them, as 1 or 0.
  void compare(int row, std::span<float> contrasts, std::span<std::int32_t> steps) const;

 private:
  struct Row {
    const float *distance_m, *red, *green, *blue;
  };
  // Of the pixels so many to the right of a row's.
  [[nodiscard]] Row row_at(int row, int right) const;
  static void compare(const Row& a, const Row& b, std::span<float> contrasts,
                      std::span<std::int32_t> steps);

  int first_;
  std::size_t stride_;
  // With a border of samples that are not traced.
  std::vector<float> distances_m_, reds_, greens_, blues_;
};

}  // namespace terrview
