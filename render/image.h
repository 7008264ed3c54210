// A rectangle of pixels, row 0 at the top.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace terrview {

template <class Pixel>
class Raster {
 public:
  Raster() = default;
  Raster(int width_px, int height_px, const Pixel& fill = {})
      : width_px_(width_px),
        height_px_(height_px),
        pixels_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), fill) {}

  [[nodiscard]] int width_px() const { return width_px_; }
  [[nodiscard]] int height_px() const { return height_px_; }
  [[nodiscard]] bool empty() const { return pixels_.empty(); }
  [[nodiscard]] Pixel& at(int column, int row) { return pixels_[index(column, row)]; }
  [[nodiscard]] const Pixel& at(int column, int row) const { return pixels_[index(column, row)]; }
  [[nodiscard]] const std::vector<Pixel>& pixels() const { return pixels_; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    assert(column >= 0 && column < width_px_ && row >= 0 && row < height_px_);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px_) +
           static_cast<std::size_t>(column);
  }

  int width_px_ = 0;
  int height_px_ = 0;
  std::vector<Pixel> pixels_;
};

// Linear Rec. 709 colours; 1 is the white of an 8-bit file.
using Image = Raster<glm::vec3>;

}  // namespace terrview
