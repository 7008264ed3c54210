#include "cli/view_command.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <system_error>

#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/view_metadata.h"
#include "cli/view_options.h"
#include "cli/view_outputs.h"
#include "cli/view_setup.h"
#include "cli/view_window.h"
#include "render/image_file.h"
#include "render/render.h"
#include "render/write_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

class Stopwatch {
 public:
  // Seconds since the last call, or since the start.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// The name without its folder, in the format's usual extension.
std::string default_name(const ViewOptions& options) {
  const std::string format = options.format.empty() ? "png" : lower_case(options.format);
  return std::filesystem::path(options.dems.front()).stem().string() + "." +
         (format == "gtiff" ? "tif" : format);
}

// The files a view will write, claimed before the work begins.
class Outputs {
 public:
  explicit Outputs(const ViewOptions& options) {
    const std::string picture = options.output.empty() ? default_name(options) : options.output;
    check_image_file(picture, options.size_px.value_or(ResolvedView{}.size_px),
                     {options.format, options.creation, {}});
    check_layers_name(options.layers);
    image = claim(picture, options);
    layers = claim(options.layers, options);
    stats = claim(options.stats, options);
    camera = claim(options.camera, options);
  }

  void commit() {
    for (const auto* file : {&image, &layers, &stats, &camera}) {
      if (*file) (*file)->commit();
    }
  }

  std::unique_ptr<OutputFile> image;
  std::unique_ptr<OutputFile> layers;
  std::unique_ptr<OutputFile> stats;
  std::unique_ptr<OutputFile> camera;

 private:
  std::unique_ptr<OutputFile> claim(const std::string& path, const ViewOptions& options) {
    if (path.empty()) return nullptr;
    if (!claimed_.insert(std::filesystem::absolute(path).lexically_normal()).second)
      throw InputError("'" + path + "': named for two outputs: give each a name of its own");
    for (const std::string& dem : options.dems) {
      std::error_code not_both_exist;
      if (std::filesystem::equivalent(path, dem, not_both_exist))
        throw InputError("'" + path + "': is a DEM of this view: write to another file");
    }
    return std::make_unique<OutputFile>(path, options.overwrite);
  }

  std::set<std::filesystem::path> claimed_;
};

void say_what_was_read(const std::vector<Dem>& dems, const ViewFrame& frame) {
  for (const Dem& dem : dems) {
    std::fprintf(stderr, "%s: %d x %d posts", dem.name.c_str(), dem.grid->columns, dem.grid->rows);
    if (dem.voids_filled > 0) std::fprintf(stderr, ", %zu void posts filled", dem.voids_filled);
    if (dem.voids_open > 0) std::fprintf(stderr, ", %zu void posts open", dem.voids_open);
    std::fputc('\n', stderr);
    for (const std::string& warning : dem.warnings)
      std::fprintf(stderr, "warning: %s\n", warning.c_str());
  }
  for (const CrsOperation& operation : frame.operations()) {
    std::fprintf(stderr, "%s: %s, accuracy ", operation.dem.c_str(), operation.name.c_str());
    if (operation.accuracy_m)
      std::fprintf(stderr, "%g m\n", *operation.accuracy_m);
    else
      std::fprintf(stderr, "unknown\n");
  }
}

void say_where_the_eye_is(const ViewFrame& frame, const ResolvedView& view) {
  const ViewFrame::Eye& eye = frame.eye();
  if (eye.geographic)
    std::fprintf(stderr, "eye: %.6f, %.6f", eye.geographic->latitude_deg,
                 eye.geographic->longitude_deg);
  else
    std::fprintf(stderr, "eye: x %.2f, y %.2f", eye.projected.x, eye.projected.y);
  std::fprintf(stderr, ", %.2f m", eye.height_m);
  if (eye.ground_m)
    std::fprintf(stderr, " (ground %.2f m)\n", *eye.ground_m);
  else
    std::fprintf(stderr, " (no ground below)\n");
  std::fprintf(stderr, "heading %.3f, pitch %.3f degrees; ", view.heading_deg, view.pitch_deg);
  if (frame.terrain()->frame().east_curvature_per_m == 0)
    std::fprintf(stderr, "flat Earth\n");
  else
    std::fprintf(stderr, "curved Earth, refraction k %g (multiplier 1-k = %g)\n", view.refraction,
                 1 - view.refraction);
}

void write_outputs(const ViewOptions& options, const Outputs& outputs, const Frame& frame,
                   const ViewFrame& view_frame, const ResolvedView& view, const SunPosition& sun) {
  const std::string camera_text = camera_json(view).dump(2);
  outputs.image->fill([&](const std::string& path) {
    write_image(
        path, frame.image,
        {options.format, options.creation, {{"terrview:view", view_metadata(options, view, sun)}}});
  });
  if (outputs.layers)
    outputs.layers->fill([&](const std::string& path) {
      write_layers_file(path, frame, view_frame, options.threads, camera_text);
    });
  if (outputs.camera)
    outputs.camera->fill([&](const std::string& path) { write_file(path, camera_text + "\n"); });
}

ViewOptions parse_view(const std::vector<std::string>& args) {
  ViewOptions options;
  CommandLine app("What can be seen of the ground from a point on the Earth", "terrview view");
  add_view_options(app, options);
  app.parse_args(args);
  prepare(options);
  return options;
}

}  // namespace

int run_view(const std::vector<std::string>& args) {
  ViewOptions options = parse_view(args);
  Outputs outputs(options);
  const bool bar_shown = !options.quiet && (options.progress || stderr_is_terminal());
  WorkSeconds seconds;
  Stopwatch stopwatch;

  std::vector<Dem> dems;
  {
    ProgressBar bar("reading", bar_shown);
    options.dem.progress = [&](double share) {
      check_interrupt();
      bar.report(share);
    };
    limit_reading(options);
    dems = read_dems(options.dems, options.dem);
  }
  seconds.read = stopwatch.lap();

  const ViewFrame view_frame(dems, *options.eye, frame_options(options));
  const ResolvedView view = resolve_view(options, view_frame, dems);
  const Camera camera = make_camera(view);
  const SunPosition sun = resolve_sun(options, view_frame);
  const Scene scene = make_scene(options, view_frame, sun);
  seconds.build = stopwatch.lap();
  if (!options.quiet) {
    say_what_was_read(dems, view_frame);
    say_where_the_eye_is(view_frame, view);
  }

  Frame frame;
  {
    ProgressBar bar("rendering", bar_shown);
    frame = render(scene, camera,
                   {.threads = options.threads,
                    .coherence = options.coherence,
                    .keep_samples = outputs.layers != nullptr,
                    .progress = [&](double share) {
                      check_interrupt();
                      bar.report(share);
                    }});
  }
  seconds.render = stopwatch.lap();

  write_outputs(options, outputs, frame, view_frame, view, sun);
  seconds.write = stopwatch.lap();
  if (outputs.stats) {
    const Json stats = stats_json(frame, view_frame, camera, dems, seconds);
    outputs.stats->fill([&](const std::string& path) { write_file(path, stats.dump(2) + "\n"); });
  }
  outputs.commit();
  if (!options.quiet) std::fprintf(stderr, "wrote %s\n", outputs.image->path().c_str());
  return 0;
}

}  // namespace terrview
