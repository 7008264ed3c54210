#include "cli/impact/impact_options.h"

#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "cli/add_option.h"
#include "cli/command_line.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// Options of a view that each viewpoint has from its feature, whose files a study names itself, or
// by which two pictures of one place could differ beside the project.
constexpr std::array<const char*, 24> kNotOfAStudy{
    "--eye",    "--eye-xy",      "--from-camera", "--width",       "--resolution",
    "--crop",   "--objects-csv", "--peaks",       "--labels-svg",  "--label-size",
    "--font",   "--wireline",    "--preview",     "--progressive", "-o",
    "--of",     "--co",          "--palette",     "--use-palette", "--save-palette",
    "--dither", "--layers",      "--stats",       "--camera"};

void add_study_options(CommandLine& app, ImpactOptions& options) {
  app.add_option("--existing", options.existing,
                 "Footprints of buildings that stand already; may be given several times")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--viewpoints", options.viewpoints,
                 "Points to look from: any vector file that OGR opens")
      ->type_name("FILE");
  app.add_option("-o", options.folder, "Folder of the report and its files")->type_name("DIR");
  add_parsed(
      app, "--eye-height",
      [&](const std::string& text) { options.eye_height_m = parse_number("--eye-height", text); },
      "Metres above the ground, of viewpoints that do not say, and of the zone (default 1.6)")
      ->type_name("M");
  app.add_option_function<std::string>(
         "--zone", [&](const std::string& text) { options.zone = text == "on"; },
         "From where on the DEM the project can be seen (default on)")
      ->one_of({"on", "off"})
      ->type_name("on|off");
  app.add_option("--title", options.title, "Of the report (default: the project's file)")
      ->type_name("TEXT");
}

void check(const ImpactOptions& options) {
  if (options.view.objects.buildings.empty())
    throw InputError("--buildings: missing: name the footprints of the project");
  if (options.viewpoints.empty())
    throw InputError("--viewpoints: missing: name a file of points to look from");
  if (options.folder.empty()) throw InputError("-o: missing: name a folder for the report");
  std::error_code ignored;
  if (std::filesystem::exists(options.folder, ignored) &&
      !std::filesystem::is_directory(options.folder, ignored))
    throw InputError("-o " + options.folder + ": is no folder: name one");
  if (!(options.eye_height_m >= 0 && options.eye_height_m <= 10000))
    throw InputError("--eye-height: give metres from 0 to 10000");
  if (options.view.plan || options.view.projection == Projection::orthographic)
    throw InputError(
        "--projection: a viewpoint has an eye: give perspective or cylindrical, or leave it out");
  if (options.view.coherence == Coherence::neighbours)
    throw InputError("--coherence neighbours: may miss what a study measures: leave it out");
}

// A word of a shell's command line.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./,:=+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace

OptionValues ImpactOptions::values_before() const {
  OptionValues before = values;
  before["buildings"] = existing;
  if (!existing.empty()) return before;
  for (const char* of_buildings :
       {"buildings", "height", "default-height", "base", "building-color"})
    before.erase(of_buildings);
  return before;
}

OptionValues ImpactOptions::values_after() const {
  OptionValues after = values;
  std::vector<std::string>& all = after["buildings"];
  all = existing;
  all.insert(all.end(), view.objects.buildings.begin(), view.objects.buildings.end());
  return after;
}

ImpactOptions parse_impact(const std::vector<std::string>& args) {
  ImpactOptions options;
  CommandLine app("What a project changes in the views of a landscape", "terrview impact");
  add_view_options(app, options.view);
  for (const char* name : kNotOfAStudy) app.remove_option(app.get_option(name));
  app.get_option("--buildings")
      ->description("Footprints of the project, which are raised; may be given several times");
  add_study_options(app, options);
  app.parse_args(args);
  options.values = ViewVocabulary().given(app);
  for (const char* of_the_study : {"o", "overwrite", "quiet", "progress", "threads"})
    options.values.erase(of_the_study);
  check(options);
  std::vector<std::string> all{"impact"};
  all.insert(all.end(), args.begin(), args.end());
  options.command = shell_command(all);
  return options;
}

std::string shell_command(const std::vector<std::string>& args) {
  std::string text = "terrview";
  for (const std::string& arg : args) text += " " + shell_word(arg);
  return text;
}

}  // namespace terrview
