#pragma once

#include <string>
#include <vector>

#include "cli/progress.h"
#include "cli/shared_inputs.h"
#include "cli/view_files.h"
#include "cli/view_options.h"
#include "cli/view_outputs.h"
#include "cli/view_setup.h"
#include "ingest/dem.h"
#include "render/image.h"
#include "render/image_file.h"
#include "render/render.h"

namespace terrview {

// `terrview [view] DEM... --eye ...`: one picture. Returns the exit code; throws InputError.
int run_view(const std::vector<std::string>& args);

// The same for options that are prepared.
int run_prepared_view(ViewOptions options);

// The view of prepared `options` over DEMs that were read, into its claimed files, which are put in
// place. `seconds` say what the reading took. Throws InputError, std::runtime_error, Interrupted.
void make_picture(const ViewOptions& options, const std::vector<Dem>& dems, SharedInputs& inputs,
                  ViewFiles& files, WorkSeconds seconds);

// The same without any file.
[[nodiscard]] Image make_image(const ViewOptions& options, const std::vector<Dem>& dems,
                               SharedInputs& inputs);

// How a view of the options is rendered, its files aside.
[[nodiscard]] RenderOptions render_options(const ViewOptions& options);

[[nodiscard]] ShowBar show_bar(const ViewOptions& options);

// The DEMs of the options, or what of them the view needs.
[[nodiscard]] std::vector<Dem> read_with_bar(ViewOptions& options);

[[nodiscard]] ImageFileOptions image_options(const ViewOptions& options, const View& view);

}  // namespace terrview
