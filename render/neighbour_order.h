// In which order the pixels of a view tell each other how far their rays are clear.
//
// Method: Coquillart 1984, chapter 2, 4. OE is the image of the vertical through the eye: the nadir
// where the camera looks down, the zenith where it looks up. Eight regions about it say which two
// neighbours, on one line or column, bracket a pixel's ray between their vertical planes and lie
// below it; where OE is far away, the roll says so alone. A pixel on OE's row, column or diagonals
// has one, in its own vertical plane. Those next to OE, and those whose neighbours lie outside the
// picture, have none.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "render/camera.h"

namespace terrview {

// The neighbours of a pixel whose rays are traced before its own.
struct Forerunners {
  int count = 0;  // 0 to 2
  glm::ivec2 first{};
  glm::ivec2 second{};
};

class NeighbourOrder {
 public:
  // Not for an orthographic camera, whose rays have no common eye.
  explicit NeighbourOrder(const Camera& camera);

  [[nodiscard]] Forerunners forerunners(glm::ivec2 pixel) const;

  // All pixels, ring by ring about OE: outward where the camera looks down, inward where it looks
  // up, line by line where it is level. The forerunners of a step's pixels are in steps before it.
  [[nodiscard]] std::vector<std::vector<glm::ivec2>> steps() const;

 private:
  enum class View { down, up, level };

  // Towards the zenith, in columns and rows, from the centre of a pixel: the way to or from OE, or
  // one way for all.
  [[nodiscard]] glm::dvec2 upward(glm::ivec2 pixel) const;
  [[nodiscard]] bool has(glm::ivec2 pixel) const;
  // Rises from a ring (or line) to the next.
  [[nodiscard]] int ring(glm::ivec2 pixel) const;

  glm::ivec2 size_px_;
  View view_;
  glm::dvec2 oe_px_{0, 0};
  glm::dvec2 upward_{0, -1};  // of a level view
};

}  // namespace terrview
