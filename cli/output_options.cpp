#include "cli/output_options.h"

#include <filesystem>
#include <vector>

#include "cli/command_line.h"
#include "cli/parse.h"

namespace terrview {

void add_format_options(CommandLine& app, std::string& format,
                        std::map<std::string, std::string>& creation, const std::string& keys) {
  app.add_option("--of", format, "Output format, if not by extension")->type_name("FORMAT");
  app.add_option_function<std::vector<std::string>>(
         "--co",
         [&creation](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) creation.insert(parse_creation_option(text));
         },
         "Creation option: " + keys)
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
}

bool same_place(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  return std::filesystem::absolute(a).lexically_normal() ==
         std::filesystem::absolute(b).lexically_normal();
}

std::string usual_extension(const std::string& format) {
  const std::string name = lower_case(format);
  if (name.empty()) return ".png";
  return name == "gtiff" || name == "cog" ? ".tif" : "." + name;
}

void add_bar_options(CommandLine& app, bool& quiet, bool& progress) {
  app.add_flag("-q,--quiet", quiet, "No messages but errors");
  app.add_flag("--progress", progress, "A progress bar even where there is no terminal");
}

}  // namespace terrview
