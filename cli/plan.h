// Maps: --projection plan.
#pragma once

#include <string>
#include <vector>

#include "cli/view_files.h"
#include "cli/view_options.h"
#include "cli/view_setup.h"
#include "ingest/dem.h"
#include "render/plan.h"

namespace terrview {

// Throws InputError for an option that a plan has no use for, or a plan's without one.
void check_plan(const ViewOptions& options);

// The eye of the options, or one over the middle of the first DEM, level with the highest ground.
[[nodiscard]] EyePlace eye_of_plan(const ViewOptions& options, const std::vector<Dem>& dems);

// Pixels that are posts of the DEM, or of the resolution asked for, from the same corner.
// Throws InputError for a resolution that makes no picture.
[[nodiscard]] PlanLattice plan_lattice(const ViewOptions& options, const Dem& dem);

// Fills in what a plan is to a camera. Throws InputError where the ground reaches too far for one
// view frame.
void resolve_plan(const ViewOptions& options, const ViewFrame& frame, const Dem& dem,
                  ResolvedView& view);

// Renders a plan, or the part of one that `lattice` is, with a bar of that `label`.
[[nodiscard]] PlanFrame draw_plan(const ViewOptions& options, const View& view,
                                  const PlanLattice& lattice, const std::string& label);

// `dem` is the first.
void write_plan(const ViewOptions& options, const View& view, const Dem& dem,
                const PlanLattice& lattice, const PlanFrame& frame, const ViewFiles& files);

}  // namespace terrview
