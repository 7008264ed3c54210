// What stands on the ground of a view.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/shared_inputs.h"
#include "cli/view_options.h"
#include "ingest/buildings.h"
#include "ingest/view_frame.h"

namespace terrview {

void add_object_options(CommandLine& app, ObjectOptions& options);

// Throws InputError for options that need others. `has_solids`: those of a scene file.
void check_objects(const ObjectOptions& options, bool has_solids);

[[nodiscard]] const char* name_of(BuildingBase base);

struct ViewObjects {
  PlacedObjects placed;
  std::shared_ptr<const SceneObjects> scene;  // null if there is none
  std::vector<std::string> messages;          // what became of the files' features, a line each
};

// Throws InputError.
[[nodiscard]] ViewObjects read_objects(const ViewOptions& options, const ViewFrame& frame,
                                       SharedInputs& inputs);

}  // namespace terrview
