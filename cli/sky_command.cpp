#include "cli/sky_command.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include <nlohmann/json.hpp>

#include "cli/color_table_file.h"
#include "cli/command_line.h"
#include "cli/field_arguments.h"
#include "cli/output_file.h"
#include "cli/output_options.h"
#include "cli/parse.h"
#include "cli/sky_view.h"
#include "render/image_file.h"
#include "render/write_file.h"
#include "sky/flat_sky.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr int kLargestSide_px = 1 << 16;

struct SkyCommand {
  FlatSkyOptions flat;
  SkyPicture view;
  bool is_flat = true;
  double clouds = 0.35;
  std::string ramp = "sky";
  std::optional<double> noise;
  std::string output;
  ImageFileOptions file;
  std::string ramp_output;
  bool overwrite = false;
  BarOptions bar;
  int threads = 0;
};

// Two numbers, or one for both.
glm::dvec2 parse_pair(const std::string& option, const std::string& text) {
  const auto numbers = parse_numbers(option, text, 1, 2);
  return {numbers.front(), numbers.back()};
}

void add_flat_options(CommandLine& app, SkyCommand& options) {
  app.add_option_function<std::string>(
         "--size", [&](const std::string& text) { options.flat.size_px = parse_size(text); },
         "Pixels (default 1280x720)")
      ->type_name("WxH");
  app.add_option_function<std::string>(
         "--cells",
         [&](const std::string& text) {
           options.flat.cells = parse_pair("--cells", text);
           if (!(options.flat.cells.x > 0 && options.flat.cells.y > 0))
             throw InputError("--cells " + text + ": give numbers above 0");
         },
         "Root cells across the picture (default 1)")
      ->type_name("X[,Y]");
  app.add_option_function<std::string>(
         "--origin",
         [&](const std::string& text) { options.flat.origin = parse_pair("--origin", text); },
         "Pictures east and north of the first, which this one continues")
      ->type_name("X,Y");
}

void add_color_options(CommandLine& app, SkyCommand& options) {
  app.add_option("--clouds", options.clouds, "0 blue to 1 grey (default 0.35)")->between(0.0, 1.0);
  app.add_option("--ramp", options.ramp, "The colour table: of that name, or a JSON file")
      ->type_name("sky|sunset|wood|marble|FILE");
  app.add_option_function<double>(
         "--noise", [&](double noise) { options.noise = noise; },
         "White noise: the standard deviation, in table addresses")
      ->between(0.0, 1.0);
  app.add_option("--write-ramp", options.ramp_output, "The table as JSON")->type_name("FILE");
}

void add_output_options(CommandLine& app, SkyCommand& options) {
  app.add_option("-o", options.output, "png, jpg, tif, exr, webp, ppm or pnm (sky.png)")
      ->type_name("FILE");
  add_format_options(app, options.file.format, options.file.creation,
                     "QUALITY, ZLEVEL or COMPRESS");
  app.add_flag("--overwrite", options.overwrite, "Replace existing outputs");
  app.add_option("--threads", options.threads, "Never changes the picture (default: all)")
      ->between(1, 4096);
  add_bar_options(app, options.bar.quiet, options.bar.progress);
}

SkyCommand parse_sky(const std::vector<std::string>& args) {
  SkyCommand options;
  options.flat.field.kind = FieldKind::smooth;
  options.flat.field.levels = {12, 12};
  options.flat.field.h = {0.6};
  CommandLine app("A random field as a sky, wood or marble", "terrview sky");
  add_field_options(app, options.flat.field);
  add_flat_options(app, options);
  add_color_options(app, options);
  add_sky_view_options(app, options.view, options.is_flat);
  add_output_options(app, options);
  app.parse_args(args);
  const glm::ivec2 size = options.flat.size_px;
  if (size.x < 1 || size.y < 1 || size.x > kLargestSide_px || size.y > kLargestSide_px)
    throw InputError("--size: give a width and height from 1 to " +
                     std::to_string(kLargestSide_px));
  if (options.output.empty()) options.output = "sky" + usual_extension(options.file.format);
  options.flat.table = find_color_table(options.ramp, options.clouds);
  if (options.noise) options.flat.table.noise = *options.noise;
  return options;
}

Image paint_in_perspective(SkyCommand options, ProgressBar& bar) {
  const FieldOptions& field = options.flat.field;
  if (field.levels.x != field.levels.y)
    throw InputError("--levels: in perspective both axes have the same: give one number");
  options.view.camera.size_px = options.flat.size_px;
  options.view.sky.clouds.emplace();
  options.view.sky.clouds->field = field;
  options.view.sky.clouds->table = options.flat.table;
  return paint_sky_view(options.view, options.threads, bar);
}

Image paint_flat(const SkyCommand& options, ProgressBar& bar) {
  Image image(options.flat.size_px.x, options.flat.size_px.y);
  const FlatSky sky(options.flat);
  const glm::ivec2 tiles = sky.tiles();
  parallel_for(tiles.x * tiles.y, options.threads, bar, [&](int index) {
    sky.paint({index % tiles.x, index / tiles.x}, image);
  });
  return image;
}

std::string sky_metadata(const SkyCommand& options) {
  nlohmann::ordered_json json;
  json["program"] = std::string("terrview ") + kVersion;
  json["field"] = field_json(options.flat.field);
  json["table"] = nlohmann::ordered_json::parse(color_table_json(options.flat.table));
  if (options.is_flat)
    json["flat"] = {{"cells", {options.flat.cells.x, options.flat.cells.y}},
                    {"origin", {options.flat.origin.x, options.flat.origin.y}}};
  else
    json["view"] = sky_view_json(options.view);
  return json.dump();
}

// Throws InputError for a name that is the table's that is read.
std::unique_ptr<OutputFile> claim(const std::string& path, const SkyCommand& options) {
  if (path.empty()) return nullptr;
  std::error_code not_both_exist;
  const bool from_file = options.ramp != "sky" && !named_table(options.ramp);
  if (from_file && std::filesystem::equivalent(path, options.ramp, not_both_exist))
    throw InputError("'" + path + "': is an input: write to another file");
  return std::make_unique<OutputFile>(path, options.overwrite);
}

Image paint(const SkyCommand& options) {
  ProgressBar bar("painting", options.bar.show());
  return options.is_flat ? paint_flat(options, bar) : paint_in_perspective(options, bar);
}

}  // namespace

int run_sky(const std::vector<std::string>& args) {
  const SkyCommand options = parse_sky(args);
  check_image_file(options.output, options.flat.size_px, options.file);
  if (same_place(options.output, options.ramp_output))
    throw InputError("'" + options.output +
                     "': named for two outputs: give each a name of its own");
  const auto picture = claim(options.output, options);
  const auto ramp = claim(options.ramp_output, options);
  const Image image = paint(options);
  ImageFileOptions to_file = options.file;
  to_file.metadata["terrview:sky"] = sky_metadata(options);
  picture->fill([&](const std::string& path) { write_image(path, image, to_file); });
  if (ramp) {
    ramp->fill([&](const std::string& path) {
      write_file(path, color_table_json(options.flat.table) + "\n");
    });
    ramp->commit();
  }
  picture->commit();
  if (!options.bar.quiet) std::fprintf(stderr, "wrote %s\n", picture->path().c_str());
  return 0;
}

}  // namespace terrview
