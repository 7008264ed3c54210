#include "cli/impact/impact_files.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <system_error>

#include "cli/input_files.h"
#include "terrain/error.h"

namespace terrview {
namespace {

namespace fs = std::filesystem;

// 01, 02, ...: as many digits as the last one needs.
std::string number_text(int number, int count) {
  const std::size_t digits = std::max<std::size_t>(2, std::to_string(count).size());
  const std::string text = std::to_string(number);
  return std::string(digits - std::min(digits, text.size()), '0') + text;
}

std::vector<std::string> files_read(const ImpactOptions& options) {
  const ViewOptions& view = options.view;
  std::vector<std::string> files{options.viewpoints, view.objects.trees, view.drape,
                                 view.water.file, view.colors};
  for (const auto& more : {view.dems, options.existing, view.objects.buildings})
    files.insert(files.end(), more.begin(), more.end());
  return files;
}

}  // namespace

ImpactFiles::ImpactFiles(const ImpactOptions& options, int viewpoint_count)
    : folder_(options.folder) {
  std::error_code error;
  made_folder_ = fs::create_directories(folder_, error);
  if (error)
    throw InputError("-o " + options.folder + ": cannot be made (" + error.message() +
                     "): check the folder above it");
  const InputFiles inputs(files_read(options), "this study");
  const auto claim = [&](const std::string& name) {
    const std::string path = (folder_ / name).string();
    inputs.refuse(path, "name another folder");
    return std::make_unique<OutputFile>(path, options.view.overwrite);
  };
  report = claim("report.html");
  table = claim("impact.csv");
  features = claim("impact.gpkg");
  if (options.zone) zone = claim("zone.tif");
  for (int i = 1; i <= viewpoint_count; ++i) {
    const std::string number = number_text(i, viewpoint_count);
    viewpoints.push_back({claim(number + "_before.png"), claim(number + "_after.png"),
                          claim(number + "_difference.png"), claim(number + "_wireline.svg"),
                          claim(number + "_scene.json")});
  }
}

ImpactFiles::~ImpactFiles() {
  viewpoints.clear();
  for (auto* file : {&zone, &table, &features, &report}) file->reset();
  std::error_code not_empty;
  if (made_folder_) fs::remove(folder_, not_empty);
}

void ImpactFiles::commit() {
  for (const OfViewpoint& files : viewpoints) {
    if (!files.complete) continue;
    for (const auto* file :
         {&files.before, &files.after, &files.difference, &files.wireline, &files.scene})
      (*file)->commit();
  }
  for (const auto* file : {&zone, &table, &features, &report})
    if (*file) (*file)->commit();
}

}  // namespace terrview
