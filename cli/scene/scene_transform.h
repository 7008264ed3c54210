// How a part of a scene file is moved, and where it stands.
#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cli/parse.h"
#include "cli/scene/scene_node.h"

namespace terrview {

inline constexpr double kFarthest_m = 1e6;

// Metres above 0.
[[nodiscard]] double read_length_m(const SceneNode& node);

// The keys that read_transform() knows.
[[nodiscard]] const std::vector<std::string>& transform_keys();

// From `matrix` (three or four rows of four numbers), or first `scale` (a number or three), then
// `rotate` (degrees about x, then y, then z, each anticlockwise as seen from its end), then `move`
// (metres). What is not there changes nothing.
[[nodiscard]] glm::dmat4 read_transform(const SceneNode& node);

// `at`, [LAT, LON] or [LAT, LON, HEIGHT], or `at_xy` in the first DEM's own coordinates: a height
// is a number, or a text "+H" above the ground there; none is the ground. One of the two must be
// there.
[[nodiscard]] Target read_place(const SceneNode& node, const std::string& at,
                                const std::string& at_xy);

}  // namespace terrview
