// The texts of attributes as heights, colours and directions.
#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace terrview {

// Metres: a finite number, alone or with m, ft or '. nullopt for anything else.
[[nodiscard]] std::optional<double> length_of(const std::string& text);

// #rgb, #rrggbb, r,g,b from 0 to 255, or one of the sixteen names of HTML; the result is linear.
[[nodiscard]] std::optional<glm::vec3> color_of(const std::string& text);

// Degrees clockwise from north: a number, or a point of the compass as N or WSW.
[[nodiscard]] std::optional<double> azimuth_deg_of(const std::string& text);

}  // namespace terrview
