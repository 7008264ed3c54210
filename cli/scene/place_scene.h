// What a scene file has, put into a view.
#pragma once

#include "cli/scene/scene_contents.h"
#include "ingest/buildings.h"
#include "ingest/view_frame.h"
#include "render/image.h"
#include "render/scene.h"

namespace terrview {

// Adds the solids, upright on the curved Earth where they stand, each a feature of the kind solid.
// Throws InputError for a place that the frame has not, or without ground where a height is above
// it.
void place_solids(const SceneContents& contents, const ViewFrame& frame, PlacedObjects& objects);

// Adds the lamps, and sets the light that the file says. Throws InputError as above.
void place_light(const SceneContents& contents, const ViewFrame& frame, Scene& scene);

// From colours added up in the numbers of the picture to the linear light that is shown so.
void show_display_colors(Image& image);

}  // namespace terrview
