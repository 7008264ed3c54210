#include "cli/batch/batch_options.h"

#include "cli/add_option.h"
#include "cli/command_line.h"
#include "terrain/error.h"

namespace terrview {
namespace {

void add_batch_options(CommandLine& app, BatchOptions& options) {
  app.add_option("JOBS", options.table,
                 "The table, a view a row: CSV, a JSON array of objects, or GeoJSON points; its "
                 "columns are named as the options of view");
  app.add_option("--dem", options.dems, "Elevation models, for all views")->type_name("DEM");
  app.add_flag("--resume", options.resume,
               "Do what is missing, has failed, or was made of other options or files");
  app.add_option("--manifest", options.manifest,
                 "What became of each job, as JSON lines (default: the table's name + .jsonl, "
                 "beside the outputs)")
      ->type_name("FILE");
  app.add_option("--shard", options.shard,
                 "Do every N-th job from the I-th, I from 0 (default: as a task of a Slurm array); "
                 "N alone: I from the environment")
      ->type_name("I/N|N");
  app.add_flag("--ignore-columns", options.ignore_columns,
               "Columns of the table that are no option are let be");
  app.add_flag("--shared-palette", options.shared_palette,
               "One palette of --palette N colours for all pictures, made of some of them first");
  app.add_option("--merge", options.merge, "Join these manifests into -o instead")
      ->type_name("MANIFEST");
}

void add_path_options(CommandLine& app, BatchOptions& options) {
  PathOptions& moving = options.moving;
  const auto above_zero = [](const std::string& name, const std::string& text) {
    const double value = parse_number(name, text);
    if (!(value > 0)) throw InputError(name + " " + text + ": give a number above 0");
    return value;
  };
  auto* path = app.add_option("--path", options.path,
                              "Frames of a film instead of JOBS: keyframes (a table with the "
                              "column time or frame), or a GPX track")
                   ->type_name("FILE");
  add_parsed(
      app, "--fps",
      [&, above_zero](const std::string& text) { moving.frames_per_s = above_zero("--fps", text); },
      "Frames a second (default 25)")
      ->needs(path);
  auto* duration = add_parsed(
                       app, "--duration",
                       [&, above_zero](const std::string& text) {
                         moving.duration_s = above_zero("--duration", text);
                       },
                       "Seconds of the film (default: the keyframes' own; 20 for a track)")
                       ->needs(path);
  add_parsed(
      app, "--speed",
      [&, above_zero](const std::string& text) {
        moving.speed_m_per_s = above_zero("--speed", text);
      },
      "Metres a second along a track, instead of its own times")
      ->excludes(duration)
      ->needs(path);
  add_parsed(
      app, "--lift", [&](const std::string& text) { moving.lift_m = parse_number("--lift", text); },
      "Metres of a track's eye over the ground (default 2)")
      ->needs(path);
}

void check(const BatchOptions& options) {
  const bool merges = !options.merge.empty();
  if (merges && (!options.source().empty() || !options.dems.empty()))
    throw InputError("--merge: renders nothing: leave out JOBS and --dem");
  if (options.view.output.empty())
    throw InputError(merges ? "-o: missing: name the joined manifest"
                            : "-o: missing: name the pictures, as -o '{name}.png'");
  if (merges) return;
  if (!options.table.empty() && !options.path.empty())
    throw InputError("--path: is instead of JOBS: leave out one of them");
  if (options.source().empty())
    throw InputError("JOBS: missing: name a table; terrview batch --help shows how");
  if (options.dems.empty()) throw InputError("--dem: missing: name the elevation models");
  if (options.shared_palette && !options.view.palette.colors)
    throw InputError("--shared-palette: of how many colours? Give --palette N too");
  if (!options.view.progressive.empty())
    throw InputError("--progressive: is for one view: leave it out");
}

}  // namespace

BatchOptions parse_batch(const std::vector<std::string>& args) {
  BatchOptions options;
  CommandLine app("Many pictures from a table", "terrview batch");
  add_view_options(app, options.view);
  app.remove_option(app.get_option("DEM"));
  add_batch_options(app, options);
  add_path_options(app, options);
  app.parse_args(args);
  options.values = ViewVocabulary().given(app);
  options.moving.aims = !options.view.heading_deg && !options.view.look_at;
  check(options);
  return options;
}

}  // namespace terrview
