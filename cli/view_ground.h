// The colours of the ground of a view.
#pragma once

#include <vector>

#include "cli/shared_inputs.h"
#include "cli/view_options.h"
#include "render/scene.h"

namespace terrview {

void add_ground_color_options(CommandLine& app, ViewOptions& options);

// Throws InputError for options that need others.
void check_ground_colors(const ViewOptions& options);

// Whether --colors names a file.
[[nodiscard]] bool has_ramp_file(const ViewOptions& options);

// The colours by slope and altitude that are asked for; none: a ramp's.
[[nodiscard]] std::optional<NaturalGround> natural_ground(const ViewOptions& options);

// Gives `scene`, whose terrain is that of `dems`, its tints, drape and lines. Throws InputError.
void set_ground_colors(const ViewOptions& options, const std::vector<Dem>& dems,
                       SharedInputs& inputs, Scene& scene);

}  // namespace terrview
