// A map in sheets.
#pragma once

#include <string>
#include <vector>

#include "cli/overview_options.h"
#include "ingest/dem.h"
#include "render/camera.h"
#include "render/plan.h"

namespace terrview {

struct Sheet {
  std::string name;
  PixelRect pixels;  // of the whole map
};

// The sheets of the options, those that lie beside the map left out, in rows from the north-west or
// in the file's order; `whole` is the lattice of the map of `dem`. Throws InputError.
[[nodiscard]] std::vector<Sheet> sheets_of(const OverviewOptions& options, const PlanLattice& whole,
                                           const Dem& dem);

// Where each sheet goes: `pattern` is a template (cli/batch/output_template.h) over {name}. Throws
// InputError for one without holes or with others, and for a name that could lead elsewhere.
[[nodiscard]] std::vector<std::string> sheet_paths(const std::string& pattern,
                                                   const std::vector<Sheet>& sheets);

// Writes one after the other. Returns the exit code; throws InputError.
int make_sheets(OverviewOptions options);

}  // namespace terrview
