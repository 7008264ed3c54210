#include "cli/view_files.h"

#include <vector>

#include "cli/camera_json.h"
#include "cli/output_options.h"
#include "cli/scene/scene_contents.h"
#include "cli/view_outputs.h"
#include "ingest/indexed_file.h"
#include "ingest/plan_file.h"
#include "render/image_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// The name without its folder, in the format's usual extension.
std::string default_name(const ViewOptions& options) {
  return std::filesystem::path(options.dems.front()).stem().string() +
         (options.plan && options.format.empty() ? ".tif" : usual_extension(options.format));
}

IndexedFileOptions indexed_options(const ViewOptions& options) {
  return {options.format, options.creation, {}};
}

glm::ivec2 image_size(const ViewOptions& options) {
  if (options.crop) return options.crop->size_px;
  return options.size_px.value_or(ResolvedView{}.size_px);
}

std::vector<std::string> files_read(const ViewOptions& options) {
  std::vector<std::string> files = options.dems;
  files.insert(files.end(), options.objects.buildings.begin(), options.objects.buildings.end());
  files.insert(files.end(), {options.objects.trees, options.drape, options.water.file,
                             options.labels.peaks, options.labels.font, options.colors,
                             options.palette.use_palette, options.from_camera});
  if (options.contents) {
    files.push_back(options.contents->path);
    files.insert(files.end(), options.contents->pictures.begin(), options.contents->pictures.end());
  }
  return files;
}

}  // namespace

ViewFiles::ViewFiles(const ViewOptions& options) : inputs_(files_read(options), "this view") {
  claim_all(options);
}

ViewFiles::ViewFiles(const ViewOptions& options, NamesOnly /*names_only*/)
    : names_only_(true), inputs_(files_read(options), "this view") {
  claim_all(options);
}

void ViewFiles::claim_all(const ViewOptions& options) {
  const std::string picture = options.output.empty() ? default_name(options) : options.output;
  check(picture, options);
  image = claim(picture, options);
  layers = claim(options.layers, options);
  stats = claim(options.stats, options);
  camera = claim(options.camera, options);
  palette = claim(options.palette.save_palette, options);
  objects_csv = claim(options.objects.csv, options);
  labels_svg = claim(options.labels.svg, options);
  wireline = claim(options.wireline.file, options);
  progressive = claim(options.progressive, options);
  if (options.plan && needs_side_files(picture, {options.format, options.creation, {}})) {
    world = claim(world_file_name(picture), options);
    side = claim(picture + ".aux.xml", options);
  }
}

void ViewFiles::check(const std::string& picture, const ViewOptions& options) const {
  check_layers_name(options.layers);
  if (options.plan) return check_plan_file(picture, {options.format, options.creation, {}});
  if (wants_palette(options.palette)) check_indexed_file(picture, indexed_options(options));
  for (const std::string& path : {picture, options.progressive}) {
    if (!path.empty() && !wants_palette(options.palette))
      check_image_file(path, image_size(options), {options.format, options.creation, {}});
  }
}

void ViewFiles::commit() {
  for (const auto* file : {&world, &side, &image, &layers, &stats, &camera, &palette, &objects_csv,
                           &labels_svg, &wireline}) {
    if (*file) (*file)->commit();
  }
}

std::unique_ptr<OutputFile> ViewFiles::claim(const std::string& path, const ViewOptions& options) {
  if (path.empty()) return nullptr;
  if (!claimed_.insert(std::filesystem::absolute(path).lexically_normal()).second)
    throw InputError("'" + path + "': named for two outputs: give each a name of its own");
  inputs_.refuse(path);
  paths_.push_back(path);
  return names_only_ ? nullptr : std::make_unique<OutputFile>(path, options.overwrite);
}

}  // namespace terrview
