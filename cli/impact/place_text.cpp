#include "cli/impact/place_text.h"

#include <array>
#include <charconv>

namespace terrview {

std::string exact_text(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string place_text(PlanPlace place, bool geographic) {
  return geographic ? exact_text(place.y) + "," + exact_text(place.x)
                    : exact_text(place.x) + "," + exact_text(place.y);
}

}  // namespace terrview
