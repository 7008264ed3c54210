#pragma once

#include <string>
#include <vector>

#include "cli/view_options.h"
#include "cli/view_setup.h"
#include "ingest/dem.h"
#include "render/image_file.h"

namespace terrview {

// `terrview [view] DEM... --eye ...`: one picture. Returns the exit code; throws InputError.
int run_view(const std::vector<std::string>& args);

// The same for options that are prepared.
int make_picture(ViewOptions options);

[[nodiscard]] bool shows_bar(const ViewOptions& options);

// The DEMs of the options, or what of them the view needs.
[[nodiscard]] std::vector<Dem> read_with_bar(ViewOptions& options);

[[nodiscard]] ImageFileOptions image_options(const ViewOptions& options, const View& view);

}  // namespace terrview
