#include "render/draw_labels.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace terrview {
namespace {

constexpr int kLetterHalo_px = 2;
constexpr int kLeaderHalo_px = 1;
constexpr float kHalo = 0.6F;
const glm::vec3 kInk(0.01F);
const glm::vec3 kPaper(1);

// The share of every pixel of a rectangle of the picture that ink takes.
class Ink {
 public:
  Ink(const LabelBox& area, int halo_px)
      : low_px_(area.low_px),
        halo_px_(halo_px),
        share_(area.high_px.x - area.low_px.x, area.high_px.y - area.low_px.y) {}

  void put(glm::ivec2 pixel, float share) {
    const glm::ivec2 at = pixel - low_px_;
    if (at.x < 0 || at.y < 0 || at.x >= share_.width_px() || at.y >= share_.height_px()) return;
    share_.at(at.x, at.y) = std::max(share_.at(at.x, at.y), share);
  }

  void paint(Image& image) const {
    for (int row = 0; row < share_.height_px(); ++row) {
      for (int column = 0; column < share_.width_px(); ++column) {
        const glm::ivec2 pixel = low_px_ + glm::ivec2(column, row);
        if (pixel.x < 0 || pixel.y < 0 || pixel.x >= image.width_px() ||
            pixel.y >= image.height_px())
          continue;
        glm::vec3& color = image.at(pixel.x, pixel.y);
        color = glm::mix(color, kPaper, kHalo * near(column, row));
        color = glm::mix(color, kInk, share_.at(column, row));
      }
    }
  }

 private:
  // The most ink within the halo.
  [[nodiscard]] float near(int column, int row) const {
    float most = 0;
    for (int y = std::max(0, row - halo_px_); y <= std::min(share_.height_px() - 1, row + halo_px_);
         ++y)
      for (int x = std::max(0, column - halo_px_);
           x <= std::min(share_.width_px() - 1, column + halo_px_); ++x)
        most = std::max(most, share_.at(x, y));
    return most;
  }

  glm::ivec2 low_px_;
  int halo_px_;
  Raster<float> share_;
};

}  // namespace

void draw_labels(std::span<const LabelInk> labels, const Font& font, Image& image) {
  for (const LabelInk& label : labels) {
    const glm::ivec2 margin(kLetterHalo_px + 1);
    Ink letters({label.box.low_px - margin, label.box.high_px + margin}, kLetterHalo_px);
    const glm::ivec2 start(label.box.low_px.x, label.box.high_px.y - font.descent_px());
    font.draw(label.text,
              [&](glm::ivec2 offset, float share) { letters.put(start + offset, share); });
    const glm::ivec2 head(label.foot_px.x, label.box.high_px.y);
    Ink leader({head - glm::ivec2(kLeaderHalo_px, 0), label.foot_px + kLeaderHalo_px + 1},
               kLeaderHalo_px);
    for (int row = head.y; row <= label.foot_px.y; ++row) leader.put({head.x, row}, 1);
    leader.paint(image);
    letters.paint(image);
  }
}

}  // namespace terrview
