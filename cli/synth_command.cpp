#include "cli/synth_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/field_arguments.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/output_options.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "ingest/height_file.h"
#include "sky/erosion.h"
#include "sky/field_part.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr int kLargestSide = 1 << 16;

enum class Relief { plain, ridged, eroded };

const std::map<std::string, Relief> kReliefs{
    {"plain", Relief::plain}, {"ridged", Relief::ridged}, {"eroded", Relief::eroded}};

struct SynthCommand {
  FieldOptions field;
  glm::ivec2 size{1025, 1025};
  glm::i64vec2 first{0, 0};
  HeightFileOptions file;
  std::string relief = "plain";
  double height_m = 300;
  double base_m = 800;
  std::string output = "synth.tif";
  bool overwrite = false;
  BarOptions bar;
  int threads = 0;
};

void add_grid_options(CommandLine& app, SynthCommand& options) {
  app.add_option_function<std::string>(
         "--size", [&](const std::string& text) { options.size = parse_size(text); },
         "Posts (default 1025x1025)")
      ->type_name("COLUMNSxROWS");
  app.add_option_function<std::string>(
         "--first",
         [&](const std::string& text) {
           const auto first = parse_numbers("--first", text, 2, 2);
           for (const double number : first) {
             if (number != std::floor(number) || std::abs(number) > 1e12)
               throw InputError("--first " + text + ": give whole numbers of posts");
           }
           options.first = {static_cast<std::int64_t>(first[0]),
                            static_cast<std::int64_t>(first[1])};
         },
         "The south-west post's place in the endless field, so that grids continue each other")
      ->type_name("COLUMN,ROW");
  app.add_option_function<std::string>(
         "--spacing",
         [&](const std::string& text) {
           const auto steps = parse_numbers("--spacing", text, 1, 2);
           options.file.spacing = {steps.front(), steps.back()};
           if (!(steps.front() > 0 && steps.back() > 0))
             throw InputError("--spacing " + text + ": give numbers above 0");
         },
         "Between posts, in the units of the CRS (default 30)")
      ->type_name("DX[,DY]");
  app.add_option_function<std::string>(
         "--south-west",
         [&](const std::string& text) {
           const auto place = parse_numbers("--south-west", text, 2, 2);
           options.file.south_west = {place[0], place[1]};
         },
         "The south-west post's coordinates (default 0,0)")
      ->type_name("X,Y");
  app.add_option("--a-srs", options.file.crs, "The coordinate system (default none: flat)")
      ->type_name("CRS");
}

void add_relief_options(CommandLine& app, SynthCommand& options) {
  app.add_option_function<std::string>(
         "--relief", [&](const std::string& text) { options.relief = text; },
         "The field itself (default), with crests where it is 0, or cut by rivers")
      ->one_of(kReliefs)
      ->type_name("plain|ridged|eroded");
  app.add_option("--height", options.height_m, "The field's standard deviation, metres (300)")
      ->between(0.0, 20000.0);
  app.add_option("--base", options.base_m, "The height of the field's mean, metres (800)")
      ->between(-20000.0, 20000.0);
}

SynthCommand parse_synth(const std::vector<std::string>& args) {
  SynthCommand options;
  options.field.kind = FieldKind::smooth;
  options.field.levels = {8, 8};
  options.field.h = {0.9};
  CommandLine app("A random field as a height grid (GeoTIFF)", "terrview synth");
  add_field_options(app, options.field);
  add_grid_options(app, options);
  add_relief_options(app, options);
  app.add_option("-o", options.output, "A GeoTIFF (default synth.tif)")->type_name("FILE");
  add_format_options(app, options.file.format, options.file.creation, heights_creation_keys());
  app.add_flag("--overwrite", options.overwrite, "Replace an existing output");
  app.add_option("--threads", options.threads, "Never changes the grid (default: all)")
      ->between(1, 4096);
  add_bar_options(app, options.bar.quiet, options.bar.progress);
  app.parse_args(args);
  if (std::min(options.size.x, options.size.y) < 2 ||
      std::max(options.size.x, options.size.y) > kLargestSide)
    throw InputError("--size: give 2 to " + std::to_string(kLargestSide) + " posts a side");
  check_heights_file(options.output, options.file);
  return options;
}

// A standard field's value to a height over the base, in its standard deviations: folded at 0 for
// ridges, where the mean of |x| is taken off and what is left stretched to the same deviation.
double shaped(Relief relief, double value) {
  constexpr double kMeanOfFolded = 0.7978845608028654;       // sqrt(2 / pi)
  constexpr double kDeviationOfFolded = 0.6028102749890869;  // sqrt(1 - 2 / pi)
  if (relief != Relief::ridged) return value;
  return (kMeanOfFolded - std::abs(value)) / kDeviationOfFolded;
}

HeightGrid make_heights(const SynthCommand& options) {
  ProgressBar bar("making", options.bar.show());
  const Relief relief = kReliefs.at(options.relief);
  constexpr int kStripRows = 64;
  const RandomField field(options.field);
  const double per_unit = 1 / field.expected_deviation();
  HeightGrid grid{options.size.x, options.size.y, {}};
  grid.heights_m.resize(static_cast<std::size_t>(grid.columns) *
                        static_cast<std::size_t>(grid.rows));
  const int strips = (grid.rows + kStripRows - 1) / kStripRows;
  parallel_for(strips, options.threads, bar, [&](int strip) {
    const int first_row = strip * kStripRows;
    const int rows = std::min(kStripRows, grid.rows - first_row);
    // The field's rows run north, the grid's south.
    const std::int64_t south = options.first.y + grid.rows - first_row - rows;
    const std::vector<float> values =
        field_part(field, {options.first.x, south, grid.columns, rows});
    const auto columns = static_cast<std::size_t>(grid.columns);
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
      const std::size_t from = (static_cast<std::size_t>(rows) - 1 - row) * columns;
      const std::size_t to = (static_cast<std::size_t>(first_row) + row) * columns;
      for (std::size_t i = 0; i < columns; ++i)
        grid.heights_m[to + i] = static_cast<float>(
            options.base_m +
            options.height_m * shaped(relief, per_unit * static_cast<double>(values[from + i])));
    }
  });
  return grid;
}

void let_rivers_cut(HeightGrid& grid, ShowBar show) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  HeightRows heights(static_cast<std::size_t>(grid.rows));
  for (std::size_t row = 0; row < heights.size(); ++row)
    heights[row].assign(grid.heights_m.begin() + static_cast<std::ptrdiff_t>(row * columns),
                        grid.heights_m.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns));
  ProgressBar bar("eroding", show);
  ErosionOptions how;
  how.progress = [&](double share) {
    check_interrupt();
    bar.report(share);
  };
  erode(heights, how);
  for (std::size_t row = 0; row < heights.size(); ++row)
    for (std::size_t i = 0; i < columns; ++i)
      grid.heights_m[row * columns + i] = static_cast<float>(heights[row][i]);
}

std::string synth_metadata(const SynthCommand& options) {
  nlohmann::ordered_json json;
  json["program"] = std::string("terrview ") + kVersion;
  json["field"] = field_json(options.field);
  json["first"] = {options.first.x, options.first.y};
  json["relief"] = options.relief;
  json["height_m"] = options.height_m;
  json["base_m"] = options.base_m;
  return json.dump();
}

}  // namespace

int run_synth(const std::vector<std::string>& args) {
  const SynthCommand options = parse_synth(args);
  OutputFile file(options.output, options.overwrite);
  HeightGrid grid = make_heights(options);
  if (kReliefs.at(options.relief) == Relief::eroded) let_rivers_cut(grid, options.bar.show());
  HeightFileOptions to_file = options.file;
  to_file.description = synth_metadata(options);
  file.fill([&](const std::string& path) { write_heights(path, grid, to_file); });
  file.commit();
  if (!options.bar.quiet) std::fprintf(stderr, "wrote %s\n", file.path().c_str());
  return 0;
}

}  // namespace terrview
