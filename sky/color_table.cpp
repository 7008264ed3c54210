#include "sky/color_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace terrview {
namespace {

double ramp_value(const std::vector<RampStop>& stops, double position) {
  if (stops.empty()) return 0;
  const auto after =
      std::upper_bound(stops.begin(), stops.end(), position,
                       [](double wanted, const RampStop& stop) { return wanted < stop.position; });
  if (after == stops.begin()) return stops.front().value;
  if (after == stops.end()) return stops.back().value;
  const RampStop& before = *(after - 1);
  const double share = (position - before.position) / (after->position - before.position);
  return before.value + share * (after->value - before.value);
}

struct Stop {
  double position;
  double red, green, blue;  // 0 to 255
};

ColorTable table_of(const std::vector<Stop>& stops) {
  ColorTable table;
  for (const Stop& stop : stops) {
    table.ramps[0].push_back({stop.position, stop.red / 255});
    table.ramps[1].push_back({stop.position, stop.green / 255});
    table.ramps[2].push_back({stop.position, stop.blue / 255});
  }
  return table;
}

// About `clouds` of the sky is more cloud than clear, but the ends are all blue and all grey. The
// logistic curve stands for the normal quantile.
TableWindow sky_window(double clouds) {
  const double share = std::clamp(clouds, 0.001, 0.999);
  const double width = 0.045 + 0.42 * share * (1 - share);
  const double quantile = std::log(share / (1 - share)) / 1.7;
  const double ends = 0.4 * std::pow(share, 4) - 0.38 * std::pow(1 - share, 12);
  return {std::clamp(0.53 + width * quantile + ends, 0.05, 0.93), width};
}

// Year rings: each begins light, darkens, and ends at a jump.
ColorTable wood_table() {
  constexpr int kRings = 12;
  std::vector<Stop> stops;
  for (int ring = 0; ring < kRings; ++ring) {
    const double start = static_cast<double>(ring) / kRings;
    const double tone = 10.0 * ((ring * 5) % 4);  // no two neighbours alike
    stops.push_back({start, 214 - tone, 160 - tone, 100 - tone});
    stops.push_back({start + 0.55 / kRings, 192 - tone, 134 - tone, 76 - tone});
    stops.push_back({start + 1.0 / kRings, 132 - tone, 82 - tone, 40 - tone});
  }
  ColorTable table = table_of(stops);
  table.window = {0.5, 0.16};
  table.noise = 0.004;
  return table;
}

}  // namespace

float linear_from_srgb(double srgb) {
  return static_cast<float>(srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4));
}

glm::vec3 ColorTable::at(double address) const {
  return {linear_from_srgb(ramp_value(ramps[0], address)),
          linear_from_srgb(ramp_value(ramps[1], address)),
          linear_from_srgb(ramp_value(ramps[2], address))};
}

double ColorTable::cover(double address) const {
  if (address <= clear_until) return 0;
  return address < cloud_from ? (address - clear_until) / (cloud_from - clear_until) : 1;
}

ColorTable sky_table(double clouds) {
  ColorTable table = table_of({{0, 52, 104, 180},
                               {0.25, 78, 132, 200},
                               {0.42, 104, 156, 214},
                               {0.62, 226, 234, 242},
                               {0.70, 250, 250, 250},
                               {0.80, 198, 202, 208},
                               {0.90, 146, 150, 158},
                               {1, 92, 96, 106}});
  table.window = sky_window(clouds);
  table.clear_until = 0.42;
  table.cloud_from = 0.64;
  return table;
}

std::optional<ColorTable> named_table(const std::string& name) {
  if (name == "sunset") {
    ColorTable table = table_of({{0, 46, 60, 112},
                                 {0.35, 128, 112, 150},
                                 {0.5, 236, 166, 122},
                                 {0.65, 255, 214, 150},
                                 {0.8, 196, 110, 96},
                                 {1, 84, 58, 82}});
    table.clear_until = 0.35;
    table.cloud_from = 0.6;
    return table;
  }
  if (name == "wood") return wood_table();
  if (name == "marble") {
    ColorTable table = table_of({{0, 206, 204, 198},
                                 {0.32, 238, 236, 232},
                                 {0.44, 222, 220, 216},
                                 {0.495, 96, 98, 104},
                                 {0.505, 96, 98, 104},
                                 {0.56, 226, 224, 220},
                                 {0.72, 246, 245, 242},
                                 {0.80, 190, 188, 186},
                                 {0.86, 240, 238, 236},
                                 {1, 250, 249, 247}});
    table.window = {0.5, 0.15};
    return table;
  }
  return std::nullopt;
}

BakedTable::BakedTable(const ColorTable& table) {
  colors_.reserve(kSteps);
  for (int i = 0; i < kSteps; ++i)
    colors_.push_back(table.at(static_cast<double>(i) / (kSteps - 1)));
}

}  // namespace terrview
