#include "cli/preset.h"

#include <array>
#include <cmath>
#include <string>

#include "cli/add_option.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kMillimetresPerInch = 25.4;
constexpr double kDpi = 300;

// Landscape Institute, Technical Guidance Note 06/19; Scottish Natural Heritage, Visual
// Representation of Wind Farms, 2.2 (2017).
struct Preset {
  const char* name;
  Projection projection;
  double fov_deg;
  double width_mm;
  double height_mm;
};

constexpr std::array<Preset, 3> kPresets{{{"a1-planar", Projection::perspective, 53.5, 820, 260},
                                          {"a3-50mm", Projection::perspective, 39.6, 390, 260},
                                          {"baseline-90", Projection::cylindrical, 90, 820, 130}}};

int pixels(double length_mm, double dpi) {
  return static_cast<int>(std::lround(length_mm / kMillimetresPerInch * dpi));
}

void check_alone(const ViewOptions& options) {
  const char* other = options.fov_deg      ? "--fov"
                      : options.size_px    ? "--size"
                      : options.projection ? "--projection"
                                           : nullptr;
  if (other != nullptr)
    throw InputError("--preset " + options.preset + ": says " + other +
                     " itself: leave out one of them");
}

}  // namespace

void add_preset_options(CommandLine& app, ViewOptions& options) {
  std::vector<std::string> names;
  for (const Preset& preset : kPresets) names.emplace_back(preset.name);
  app.add_option("--preset", options.preset,
                 "A picture on paper: its projection, field of view and size")
      ->one_of(names)
      ->type_name("a1-planar|a3-50mm|baseline-90");
  add_number(app, "--dpi", options.dpi, "Pixels per inch, of a preset (default 300) and in files");
}

void apply_preset(ViewOptions& options) {
  constexpr double kMostDpi = 10'000;
  if (options.dpi && !(*options.dpi >= 1 && *options.dpi <= kMostDpi))
    throw InputError("--dpi: give pixels per inch from 1 to 10000, as 300");
  for (const Preset& preset : kPresets) {
    if (options.preset != preset.name) continue;
    check_alone(options);
    options.projection = preset.projection;
    options.fov_deg = preset.fov_deg;
    if (!options.dpi) options.dpi = kDpi;
    options.size_px =
        glm::ivec2(pixels(preset.width_mm, *options.dpi), pixels(preset.height_mm, *options.dpi));
  }
}

}  // namespace terrview
