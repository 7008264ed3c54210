#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "ingest/color_ramp_file.h"
#include "terrain/error.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const terrview::ColorRamp& ramp) {
  require(!ramp.stops.empty());
  for (std::size_t i = 1; i < ramp.stops.size(); ++i) {
    require(ramp.stops[i - 1].height_m <= ramp.stops[i].height_m);
  }
  for (const double height_m : {-500.0, 0.0, 450.0, ramp.stops[0].height_m, 9000.0}) {
    const glm::vec3 color = ramp.at(height_m);
    for (int i = 0; i < 3; ++i) require(color[i] >= 0 && color[i] <= 1);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    check(terrview::parse_color_ramp(text, "ramp.txt", {200, 1200, false}));
  } catch (const terrview::InputError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
