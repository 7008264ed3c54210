#include "cli/impact/impact_study.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <utility>

#include "cli/exact_text.h"
#include "cli/impact/picture_change.h"
#include "cli/interrupt.h"
#include "cli/prepare_view.h"
#include "cli/read_file.h"
#include "cli/scene/scene_json.h"
#include "cli/view_command.h"
#include "cli/view_metadata.h"
#include "cli/view_wireline.h"
#include "render/image_file.h"
#include "render/lines/wireline.h"
#include "render/write_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// LAT,LON, or X,Y: as the command line takes them.
std::string place_text(PlanPlace place, bool geographic) {
  return geographic ? exact_text(place.y) + "," + exact_text(place.x)
                    : exact_text(place.x) + "," + exact_text(place.y);
}

// The options of a viewpoint's views, as a row of a batch would have them.
JobRow row_of(const ImpactOptions& options, const Project& project, const Viewpoint& viewpoint) {
  JobRow row;
  for (const auto& [option, text] : viewpoint.options) row.cells[option] = {text};
  const std::string height =
      ",+" + exact_text(viewpoint.eye_height_m.value_or(options.eye_height_m));
  row.cells[project.geographic ? "eye" : "eye-xy"] = {
      place_text(viewpoint.place, project.geographic) + height};
  const bool has_aim =
      options.view.look_at || options.view.heading_deg || row.cells.contains("heading");
  if (!has_aim && !row.cells.contains("look-at"))
    row.cells[project.geographic ? "look-at" : "look-at-xy"] = {
        place_text(project.middle, project.geographic) + ",+" + exact_text(project.middle_m)};
  return row;
}

// A picture that is to be made, and how the command line would ask for it.
struct PictureOrder {
  ViewOptions options;
  std::string command;
  OptionValues values;
};

PictureOrder order(const OptionValues& values, const JobRow& row, const std::string& picture,
                   const ImpactOptions& options) {
  static const ViewVocabulary vocabulary;
  OptionValues all = vocabulary.with_row(values, row);
  all["o"] = {picture};
  const std::vector<std::string> args = vocabulary.arguments(all, options.view.dems);
  std::vector<std::string> words{"view"};
  words.insert(words.end(), args.begin(), args.end());
  PictureOrder result{parse_view(args, "terrview view"), shell_command(words), all};
  result.options.threads = options.view.threads;
  result.options.quiet = true;
  return result;
}

struct Rendered {
  View view;
  Frame frame;
};

Rendered render_order(const PictureOrder& order, const std::vector<Dem>& dems,
                      SharedInputs& inputs) {
  View view = make_view(order.options, dems, inputs);
  RenderOptions how = render_options(order.options);
  how.keep_samples = true;
  how.progress = [](double) { check_interrupt(); };
  Frame frame = render(view.scene, view.camera, how);
  return {std::move(view), std::move(frame)};
}

std::vector<std::string> warnings_of(const View& view) {
  const std::string mark = "warning: ";
  std::vector<std::string> warnings = view.frame.warnings();
  for (const std::string& message : view.objects.messages)
    if (message.starts_with(mark)) warnings.push_back(message.substr(mark.size()));
  return warnings;
}

StudyPoint study_point(const SeenPoint& point, const ViewFrame& frame) {
  const glm::dvec2 ground_m(point.view_m);
  const VerticalFrame& vertical = frame.terrain()->frame();
  return {.place = plan_place(frame, ground_m),
          .height_m = vertical.at(ground_m).scene_height_m(point.view_m.z) / vertical.z_scale,
          .distance_m = point.distance_m};
}

SightNumbers numbers_of(const BuildingSight& sight, const PictureChange& change,
                        const ViewFrame& frame) {
  SightNumbers numbers;
  const auto found = change.building_px.find(sight.id);
  if (found != change.building_px.end()) numbers.pixels = found->second;
  numbers.solid_angle_sr = sight.solid_angle_sr;
  numbers.facade = sight.facade;
  if (sight.nearest) numbers.nearest = study_point(*sight.nearest, frame);
  if (sight.farthest) numbers.farthest = study_point(*sight.farthest, frame);
  return numbers;
}

void add(const SightNumbers& more, SightNumbers& sum) {
  sum.pixels += more.pixels;
  sum.solid_angle_sr += more.solid_angle_sr;
  sum.facade += more.facade;
  if (!more.is_seen()) return;
  if (!sum.nearest || more.nearest->distance_m < sum.nearest->distance_m)
    sum.nearest = more.nearest;
  if (!sum.farthest || more.farthest->distance_m > sum.farthest->distance_m)
    sum.farthest = more.farthest;
}

void measure(const Rendered& after, const PictureChange& change, const Project& project,
             int threads, ViewpointStudy& study) {
  const std::vector<BuildingSight> sights =
      sights_of(after.view, project.before, {.threads = threads});
  for (const ProjectBuilding& building : project.buildings) {
    const auto sight = std::ranges::find(sights, building.id, &BuildingSight::id);
    study.buildings.push_back(sight == sights.end() ? SightNumbers{}
                                                    // too far away to stand in this view
                                                    : numbers_of(*sight, change, after.view.frame));
    add(study.buildings.back(), study.project);
  }
  study.changed_px = change.changed_px;
  if (change.horizon_columns > 0)
    study.horizon_changed =
        static_cast<double>(change.changed_columns) / static_cast<double>(change.horizon_columns);
}

// Fills `file`, and returns the bytes that `write` makes.
std::string fill(OutputFile& file, const std::function<void(const std::string&)>& write) {
  std::string bytes;
  file.fill([&](const std::string& path) {
    write(path);
    bytes = read_file(path);
  });
  return bytes;
}

// Into `file`, and as a JPEG for the report.
std::string write_picture(const PictureOrder& order, const Rendered& rendered, OutputFile& file) {
  file.fill([&](const std::string& path) {
    write_image(path, rendered.frame.image, image_options(order.options, rendered.view));
  });
  constexpr int kQuality = 88;
  return encode_jpeg(rendered.frame.image, kQuality);
}

std::string scene_after(OptionValues values, const ImpactOptions& options) {
  values.erase("wireline");
  return scene_text(scene_json(values, options.view.dems, options.folder));
}

std::string wireline_text(const PictureOrder& order, const View& view) {
  const Wireline wireline =
      trace_wireline(view.scene, view.camera,
                     {.step_posts = order.options.wireline.step_posts.value_or(0),
                      .threads = order.options.threads,
                      .progress = [](double) { check_interrupt(); }});
  return wireline_svg(wireline, view.camera.options().size_px,
                      view_metadata(order.options, view.resolved, view.sun));
}

class ViewpointWork {
 public:
  ViewpointWork(const StudyGround& ground, const Viewpoint& viewpoint,
                ImpactFiles::OfViewpoint& files)
      : ground_(ground), files_(files) {
    study_.viewpoint = viewpoint;
    study_.name =
        viewpoint.name.empty() ? "Viewpoint " + std::to_string(viewpoint.number) : viewpoint.name;
  }

  ViewpointStudy work() {
    try {
      look();
      files_.complete = true;
    } catch (const std::bad_alloc&) {
      fail("out of memory: use a --window of the DEM or a smaller --size");
    } catch (const std::exception& error) {
      fail(error.what());
    }
    return std::move(study_);
  }

 private:
  // Whatever was found before.
  void fail(const std::string& why) {
    ViewpointStudy failed;
    failed.viewpoint = std::move(study_.viewpoint);
    failed.name = std::move(study_.name);
    failed.error = why;
    study_ = std::move(failed);
  }

  void look() {
    const ImpactOptions& options = ground_.options;
    const JobRow row = row_of(options, ground_.project, study_.viewpoint);
    OptionValues with_lines = options.values_after();
    with_lines["wireline"] = {files_.wireline->path()};
    OptionValues without_lines = options.values_before();
    without_lines.erase("wireline-step");
    const PictureOrder before = order(without_lines, row, files_.before->path(), options);
    const PictureOrder after = order(with_lines, row, files_.after->path(), options);
    study_.before_command = before.command;
    study_.after_command = after.command;
    const Rendered without = render_order(before, ground_.dems, ground_.inputs);
    const Rendered with = render_order(after, ground_.dems, ground_.inputs);
    study_.camera = with.view.resolved;
    study_.ground_m = with.view.frame.eye().ground_m;
    study_.sun = with.view.sun;
    study_.warnings = warnings_of(with.view);
    const PictureChange change =
        picture_change(without.frame, with.frame, ground_.project.before, ground_.project.last);
    measure(with, change, ground_.project, options.view.threads, study_);
    study_.pictures.before_jpg = write_picture(before, without, *files_.before);
    study_.pictures.after_jpg = write_picture(after, with, *files_.after);
    write_others(after, with, change);
  }

  void write_others(const PictureOrder& after, const Rendered& with, const PictureChange& change) {
    study_.pictures.difference_png = fill(
        *files_.difference, [&](const std::string& path) { write_image(path, change.mask, {}); });
    study_.scene = fill(*files_.scene, [&](const std::string& path) {
      write_file(path, scene_after(after.values, ground_.options));
    });
    study_.scene_name = std::filesystem::path(files_.scene->path()).filename().string();
    study_.pictures.wireline_svg = fill(*files_.wireline, [&](const std::string& path) {
      write_file(path, wireline_text(after, with.view));
    });
  }

  const StudyGround& ground_;
  ImpactFiles::OfViewpoint& files_;
  ViewpointStudy study_;
};

}  // namespace

std::optional<double> SightNumbers::facade_share() const {
  if (!(facade.facing_m2 > 0)) return std::nullopt;
  return facade.seen_m2 / facade.facing_m2;
}

ViewpointStudy study_viewpoint(const StudyGround& ground, const Viewpoint& viewpoint,
                               ImpactFiles::OfViewpoint& files) {
  return ViewpointWork(ground, viewpoint, files).work();
}

}  // namespace terrview
