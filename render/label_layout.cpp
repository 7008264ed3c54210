#include "render/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace terrview {
namespace {

bool overlap(const LabelBox& a, const LabelBox& b) {
  return a.low_px.x < b.high_px.x && b.low_px.x < a.high_px.x && a.low_px.y < b.high_px.y &&
         b.low_px.y < a.high_px.y;
}

LabelBox grown(const LabelBox& box, glm::ivec2 by_px) {
  return {box.low_px - by_px, box.high_px + by_px};
}

struct Placed {
  LabelBox box;
  LabelBox leader;
};

class Layout {
 public:
  explicit Layout(const LabelLayoutOptions& options) : options_(options) {}

  std::optional<LabelBox> place(const LabelRequest& request) {
    for (const bool sky_alone : {true, false}) {
      const int highest = sky_alone ? lowest_top(request) - options_.size_px.y / 4 : 0;
      for (int top = lowest_top(request); top >= std::max(highest, options_.gap_px);
           top -= row_px()) {
        for (const int left : lefts(request)) {
          const Placed candidate = at({left, top}, request);
          if (!fits(candidate, sky_alone)) continue;
          placed_.push_back(candidate);
          return candidate.box;
        }
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] int row_px() const { return options_.line_px + options_.gap_px; }

  // Rows are the same all over the picture.
  [[nodiscard]] int lowest_top(const LabelRequest& request) const {
    const int room_px =
        static_cast<int>(std::floor(request.anchor_px.y)) - options_.line_px - options_.gap_px;
    const int rows = room_px < options_.gap_px ? -1 : (room_px - options_.gap_px) / row_px();
    return options_.gap_px + rows * row_px();
  }

  // The left ends to try: about the leader, within the picture, then from it and up to it.
  [[nodiscard]] std::array<int, 3> lefts(const LabelRequest& request) const {
    const int column = leader_column(request);
    const int last = options_.size_px.x - options_.gap_px - request.width_px;
    const int middle = column - request.width_px / 2;
    return {std::max(options_.gap_px, std::min(middle, last)), column,
            column + 1 - request.width_px};
  }

  [[nodiscard]] Placed at(glm::ivec2 low, const LabelRequest& request) const {
    const glm::ivec2 high = low + glm::ivec2(request.width_px, options_.line_px);
    const int column = leader_column(request);
    const int foot = std::max(high.y, static_cast<int>(std::floor(request.anchor_px.y)) + 1);
    return {{low, high}, {{column, high.y}, {column + 1, foot}}};
  }

  [[nodiscard]] bool fits(const Placed& candidate, bool sky_alone) const {
    const LabelBox& box = candidate.box;
    const LabelBox& leader = candidate.leader;
    if (box.low_px.x < 0 || box.high_px.x > options_.size_px.x) return false;
    if (leader.low_px.x < box.low_px.x || leader.low_px.x >= box.high_px.x) return false;
    if (sky_alone && !covers_sky_alone(box)) return false;
    const glm::ivec2 gap(options_.gap_px);
    const glm::ivec2 blank(options_.line_px / 2, options_.gap_px);
    return std::none_of(placed_.begin(), placed_.end(), [&](const Placed& other) {
      return overlap(grown(box, blank), other.box) || overlap(grown(box, gap), other.leader) ||
             overlap(grown(other.box, gap), leader) ||
             overlap(grown(leader, glm::ivec2(1)), other.leader);
    });
  }

  [[nodiscard]] bool covers_sky_alone(const LabelBox& box) const {
    const auto& skyline = options_.skyline_px;
    if (skyline.empty()) return true;
    return std::all_of(skyline.begin() + box.low_px.x, skyline.begin() + box.high_px.x,
                       [&](int row) { return box.high_px.y <= row; });
  }

  const LabelLayoutOptions& options_;
  std::vector<Placed> placed_;
};

}  // namespace

int leader_column(const LabelRequest& request) {
  return static_cast<int>(std::floor(request.anchor_px.x));
}

std::vector<std::optional<LabelBox>> place_labels(std::span<const LabelRequest> requests,
                                                  const LabelLayoutOptions& options) {
  Layout layout(options);
  std::vector<std::optional<LabelBox>> boxes;
  boxes.reserve(requests.size());
  for (const LabelRequest& request : requests) boxes.push_back(layout.place(request));
  return boxes;
}

}  // namespace terrview
