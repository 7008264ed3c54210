// Names of files in a scene file, which are relative to its folder. Absolute names, URLs and GDAL's
// names with a colon before any slash are the same everywhere.
#pragma once

#include <string>

#include "cli/batch/option_values.h"

namespace terrview {

// `name`, relative to `folder`, as seen from the current folder.
[[nodiscard]] std::string from_folder(const std::string& name, const std::string& folder);

// `name`, relative to the current folder, as seen from `folder`.
[[nodiscard]] std::string to_folder(const std::string& name, const std::string& folder);

// The same for the names of files among values of options.
[[nodiscard]] OptionValues from_folder(OptionValues values, const std::string& folder);
[[nodiscard]] OptionValues to_folder(OptionValues values, const std::string& folder);

}  // namespace terrview
