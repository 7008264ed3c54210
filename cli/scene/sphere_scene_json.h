// Scenes of spheres (ingest/sphere_scene.h) as scene files of this program.
#pragma once

#include "cli/scene/json_text.h"
#include "ingest/sphere_scene.h"

namespace terrview {

// x stays, z becomes the way south, and what points down the picture points down. The picture has a
// pixel for each unit of the window, and its colours are those that the document adds up.
[[nodiscard]] SceneJson sphere_scene_json(const SphereScene& scene);

}  // namespace terrview
