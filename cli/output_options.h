// Options of outputs that the commands share.
#pragma once

#include <map>
#include <string>

#include "cli/progress.h"

namespace terrview {

class CommandLine;

// --of and --co; `keys` says what --co knows.
void add_format_options(CommandLine& app, std::string& format,
                        std::map<std::string, std::string>& creation, const std::string& keys);

// Whether two paths, neither of them empty, name one file.
[[nodiscard]] bool same_place(const std::string& a, const std::string& b);

// Of a file in `format`, as --of has it, with the dot; empty: png.
[[nodiscard]] std::string usual_extension(const std::string& format);

struct BarOptions {
  bool quiet = false;
  bool progress = false;

  [[nodiscard]] ShowBar show() const { return show_bar(quiet, progress); }
};

// -q, --quiet and --progress.
void add_bar_options(CommandLine& app, bool& quiet, bool& progress);

}  // namespace terrview
