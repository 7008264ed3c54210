// From a field's values to colours: the thesis's conversion table (Coquillart 1984, chapter
// 4, 3.2).
//
// Three independent ramps, one for each of red, green and blue, are linear between stops; two stops
// at one position make a jump. An address is a place in the table: 0 its beginning, 1 its end.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace terrview {

// sRGB 0-1 to a linear component.
[[nodiscard]] float linear_from_srgb(double srgb);

struct RampStop {
  double position;  // 0 to 1
  double value;     // sRGB, 0 to 1
};

// Where in the table the field's values fall.
struct TableWindow {
  double middle = 0.5;  // the address of the value 0
  double width = 0.18;  // addresses that one standard deviation spans
};

struct ColorTable {
  std::array<std::vector<RampStop>, 3> ramps;  // red, green, blue; stops by rising position
  TableWindow window = {};
  // Up to here the table shows the clear sky, where the sun and its halo act; from `cloud_from` on
  // nothing but cloud.
  double clear_until = 0;
  double cloud_from = 0;
  double noise = 0;  // white noise added to addresses: its standard deviation

  // Linear Rec. 709. Below the first stop and above the last their colours; at a jump the second.
  [[nodiscard]] glm::vec3 at(double address) const;
  // The share of the clear sky that an address hides, 0 to 1.
  [[nodiscard]] double cover(double address) const;
};

// The standard sky: from blue through whitish to grey. `clouds` 0 shows its blue end, 1 its grey.
[[nodiscard]] ColorTable sky_table(double clouds);

// A table by name: sunset, wood, marble; nullopt for an unknown one.
[[nodiscard]] std::optional<ColorTable> named_table(const std::string& name);

// A table's colours by equal steps of address, for inner loops. Off by half a step at a jump, and
// elsewhere by what a straight line misses within one.
class BakedTable {
 public:
  explicit BakedTable(const ColorTable& table);
  [[nodiscard]] const glm::vec3& at(float address) const {
    const float step = address * (kSteps - 1) + 0.5F;
    if (!(step > 0)) return colors_.front();
    return step < kSteps ? colors_[static_cast<std::size_t>(step)] : colors_.back();
  }

 private:
  static constexpr int kSteps = 8192;
  std::vector<glm::vec3> colors_;
};

}  // namespace terrview
