// Labels as ink on a picture.
#pragma once

#include <span>
#include <string>

#include <glm/vec2.hpp>

#include "render/image.h"
#include "render/label_layout.h"
#include "render/text.h"

namespace terrview {

struct LabelInk {
  std::string text;
  LabelBox box;        // its text stands on the line `descent` above the lower side
  glm::ivec2 foot_px;  // of the leader: the pixel of the anchor
};

// Dark letters and leaders in white halos of two pixels and of one.
void draw_labels(std::span<const LabelInk> labels, const Font& font, Image& image);

}  // namespace terrview
