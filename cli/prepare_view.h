#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/batch/option_values.h"
#include "cli/view_options.h"

namespace terrview {

// Checks what can be checked before any file is read, and fills in --from-camera. Throws
// InputError.
void prepare(ViewOptions& options);

// Throws InputError for a --z-scale that no view has.
void check_z_scale(const ViewOptions& options);

// What `args` say to `program` of a view, as texts, unchecked but for each option by itself.
struct GivenView {
  OptionValues values;
  std::vector<std::string> dems;
  bool prints_scene = false;
};
[[nodiscard]] GivenView given_view(const std::vector<std::string>& args,
                                   const std::string& program);

// The options that `args` say to `program`, prepared; of a scene with those contents, which may do
// without a DEM. Throws what CommandLine and prepare() throw.
[[nodiscard]] ViewOptions parse_view(const std::vector<std::string>& args,
                                     const std::string& program,
                                     std::shared_ptr<const SceneContents> contents = nullptr);

}  // namespace terrview
