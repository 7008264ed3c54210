#include "cli/view_command.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "cli/interrupt.h"
#include "cli/objects_csv.h"
#include "cli/palette_file.h"
#include "cli/palette_picture.h"
#include "cli/plan.h"
#include "cli/prepare_view.h"
#include "cli/scene/place_scene.h"
#include "cli/scene/scene_json.h"
#include "cli/view_files.h"
#include "cli/view_messages.h"
#include "cli/view_metadata.h"
#include "cli/view_options.h"
#include "cli/view_outputs.h"
#include "cli/view_setup.h"
#include "cli/view_window.h"
#include "cli/view_wireline.h"
#include "render/image_file.h"
#include "render/stopwatch.h"
#include "render/write_file.h"

namespace terrview {
namespace {

bool shows_display_colors(const ViewOptions& options) {
  return options.contents && options.contents->display_colors;
}

Frame render(const ViewOptions& options, const View& view, const ViewFiles& files) {
  ProgressBar bar("rendering", show_bar(options));
  RenderOptions how = render_options(options);
  how.keep_samples = files.layers != nullptr || files.objects_csv != nullptr;
  how.progress = [&](double share) {
    check_interrupt();
    bar.report(share);
  };
  if (files.progressive)
    how.improved = [&, to_file = image_options(options, view)](const Image& image) {
      Image labelled = image;
      if (shows_display_colors(options)) show_display_colors(labelled);
      draw_labels(view.labels, labelled);
      files.progressive->fill(
          [&](const std::string& path) { write_image(path, labelled, to_file); });
      files.progressive->commit();
    };
  try {
    Frame frame = terrview::render(view.scene, view.camera, how);
    if (shows_display_colors(options)) show_display_colors(frame.image);
    draw_labels(view.labels, frame.image);
    return frame;
  } catch (const Interrupted&) {
    if (files.progressive && files.progressive->exists())
      throw Interrupted{files.progressive->path()};
    throw;
  }
}

std::string wireline_text(const ViewOptions& options, const View& view) {
  ProgressBar bar("drawing lines", show_bar(options));
  const Wireline wireline = trace_wireline(view.scene, view.camera,
                                           {.step_posts = options.wireline.step_posts.value_or(0),
                                            .threads = options.threads,
                                            .progress = [&](double share) {
                                              check_interrupt();
                                              bar.report(share);
                                            }});
  return wireline_svg(wireline, view.camera.options().size_px,
                      view_metadata(options, view.resolved, view.sun));
}

void write(const ViewOptions& options, const View& view, const Frame& frame,
           const ViewFiles& files) {
  const std::string camera_text = camera_json(view.resolved).dump(2);
  const ImageFileOptions how = image_options(options, view);
  files.image->fill([&](const std::string& path) {
    if (!wants_palette(options.palette)) return write_image(path, frame.image, how);
    const Palette palette = write_palette_image(path, frame.image, options.palette,
                                                {how.format, how.creation, how.metadata});
    if (files.palette)
      files.palette->fill([&](const std::string& palette_path) {
        write_file(palette_path, palette_text(palette, options.palette.save_palette));
      });
  });
  if (files.layers)
    files.layers->fill([&](const std::string& path) {
      write_layers_file(path, frame, view.frame, options.threads, camera_text);
    });
  if (files.objects_csv)
    files.objects_csv->fill([&](const std::string& path) {
      write_file(path, objects_csv(view, frame, options.threads));
    });
  if (files.labels_svg)
    files.labels_svg->fill([&](const std::string& path) {
      write_file(path, labels_svg(view.labels, view.camera,
                                  view_metadata(options, view.resolved, view.sun)));
    });
  if (files.wireline)
    files.wireline->fill(
        [&](const std::string& path) { write_file(path, wireline_text(options, view)); });
  if (files.camera)
    files.camera->fill([&](const std::string& path) { write_file(path, camera_text + "\n"); });
}

// A plan's counts, as those of a frame.
Frame draw_plan(const ViewOptions& options, const View& view, const Dem& dem,
                const ViewFiles& files, WorkSeconds& seconds) {
  Stopwatch stopwatch;
  const PlanLattice lattice = plan_lattice(options, dem);
  const PlanFrame plan = terrview::draw_plan(options, view, lattice, "rendering");
  seconds.render = stopwatch.lap();
  write_plan(options, view, dem, lattice, plan, files);
  seconds.write = stopwatch.lap();
  Frame frame;
  frame.counts = plan.counts;
  return frame;
}

Frame draw(const ViewOptions& options, const View& view, const ViewFiles& files,
           WorkSeconds& seconds) {
  Stopwatch stopwatch;
  Frame frame = render(options, view, files);
  seconds.render = stopwatch.lap();
  write(options, view, frame, files);
  seconds.write = stopwatch.lap();
  return frame;
}

}  // namespace

RenderOptions render_options(const ViewOptions& options) {
  return {.threads = options.threads,
          .coherence = options.coherence,
          .samples = options.sampling.samples,
          .contrast = static_cast<float>(options.sampling.contrast),
          .preview = options.sampling.preview};
}

ShowBar show_bar(const ViewOptions& options) { return show_bar(options.quiet, options.progress); }

std::vector<Dem> read_with_bar(ViewOptions& options) {
  ProgressBar bar("reading", show_bar(options));
  options.dem.progress = [&](double share) {
    check_interrupt();
    bar.report(share);
  };
  if (options.dems.empty()) return {};
  limit_reading(options);
  return read_dems(options.dems, options.dem);
}

ImageFileOptions image_options(const ViewOptions& options, const View& view) {
  return {options.format,
          options.creation,
          {{"terrview:view", view_metadata(options, view.resolved, view.sun)}},
          options.dpi.value_or(0)};
}

void make_picture(const ViewOptions& options, const std::vector<Dem>& dems, SharedInputs& inputs,
                  ViewFiles& files, WorkSeconds seconds) {
  Stopwatch stopwatch;
  const View view = make_view(options, dems, inputs);
  seconds.build = stopwatch.lap();
  if (!options.quiet) say_what_is_seen(dems, view);
  const Frame frame = options.plan ? draw_plan(options, view, dems.front(), files, seconds)
                                   : draw(options, view, files, seconds);
  if (files.stats) {
    const auto stats = stats_json(frame, view.frame, view.camera, dems, seconds);
    files.stats->fill([&](const std::string& path) { write_file(path, stats.dump(2) + "\n"); });
  }
  files.commit();
}

Image make_image(const ViewOptions& options, const std::vector<Dem>& dems, SharedInputs& inputs) {
  const View view = make_view(options, dems, inputs);
  return render(options, view, ViewFiles(options, ViewFiles::NamesOnly{})).image;
}

int run_view(const std::vector<std::string>& args) {
  constexpr const char* kProgram = "terrview view";
  ViewOptions options = parse_view(args, kProgram);
  if (!options.prints_scene) return run_prepared_view(std::move(options));
  const GivenView given = given_view(args, kProgram);
  std::printf("%s", scene_text(scene_json(given.values, given.dems)).c_str());
  return 0;
}

int run_prepared_view(ViewOptions options) {
  ViewFiles files(options);
  SharedInputs inputs;
  Stopwatch stopwatch;
  const std::vector<Dem> dems = read_with_bar(options);
  make_picture(options, dems, inputs, files, {.read = stopwatch.lap()});
  if (!options.quiet) std::fprintf(stderr, "wrote %s\n", files.image->path().c_str());
  return 0;
}

}  // namespace terrview
