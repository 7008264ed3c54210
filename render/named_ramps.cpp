#include "render/named_ramps.h"

namespace terrview {
namespace {

ColorRamp alpine() {
  return {.stops = {{0, from_srgb8(86, 124, 72)},
                    {600, from_srgb8(112, 146, 78)},
                    {1200, from_srgb8(88, 122, 66)},
                    {1800, from_srgb8(124, 144, 84)},
                    {2200, from_srgb8(152, 150, 108)},
                    {2600, from_srgb8(140, 132, 120)},
                    {3000, from_srgb8(166, 160, 154)},
                    {3300, from_srgb8(232, 235, 240)},
                    {4800, from_srgb8(250, 251, 252)}}};
}

ColorRamp arid() {
  return {.stops = {{-100, from_srgb8(214, 200, 164)},
                    {300, from_srgb8(222, 198, 146)},
                    {800, from_srgb8(212, 172, 112)},
                    {1400, from_srgb8(192, 132, 82)},
                    {2000, from_srgb8(164, 98, 66)},
                    {2800, from_srgb8(136, 90, 72)},
                    {4000, from_srgb8(172, 150, 136)},
                    {6000, from_srgb8(226, 218, 210)}}};
}

ColorRamp polar() {
  return {.stops = {{0, from_srgb8(104, 104, 96)},
                    {80, from_srgb8(124, 120, 104)},
                    {250, from_srgb8(138, 138, 136)},
                    {450, from_srgb8(206, 216, 224)},
                    {900, from_srgb8(228, 236, 244)},
                    {2500, from_srgb8(246, 249, 252)}}};
}

ColorRamp grey() {
  return {.stops = {{0, from_srgb8(96, 96, 96)}, {4500, from_srgb8(240, 240, 240)}}};
}

}  // namespace

const std::vector<NamedRamp>& named_ramps() {
  static const std::vector<NamedRamp> ramps{
      {"alpine", alpine()}, {"arid", arid()}, {"polar", polar()}, {"grey", grey()}};
  return ramps;
}

const ColorRamp* find_named_ramp(std::string_view name) {
  for (const NamedRamp& named : named_ramps())
    if (named.name == name) return &named.ramp;
  return nullptr;
}

}  // namespace terrview
