#include "cli/impact/impact_files.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
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
  return std::string(digits - text.size(), '0') + text;
}

std::vector<std::string> files_read(const ImpactOptions& options) {
  const ViewOptions& view = options.view;
  std::vector<std::string> files{options.viewpoints, view.objects.trees, view.drape,
                                 view.water.file, view.colors};
  for (const auto& more : {view.dems, options.existing, view.objects.buildings})
    files.insert(files.end(), more.begin(), more.end());
  return files;
}

// Whether a study may have a file of that name, and another one may not.
bool is_of_some_studies(std::string_view name) {
  static constexpr std::array<std::string_view, 5> kEnds{
      "_before.png", "_after.png", "_difference.png", "_wireline.svg", "_scene.json"};
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  const auto is_end = [&](std::string_view end) { return name.substr(digits) == end; };
  return name == "zone.tif" || (digits >= 2 && std::ranges::any_of(kEnds, is_end));
}

std::vector<fs::path> files_of_a_study(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder / "report.html")) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_of_some_studies(entry.path().filename().string()))
      files.push_back(entry.path());
  return files;
}

fs::path absolute_of(const fs::path& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

// The topmost of the folders on the way to `folder` that are not there; none: empty.
fs::path topmost_missing(const fs::path& folder) {
  fs::path missing;
  std::error_code error;
  for (fs::path at = absolute_of(folder); !fs::exists(at, error); at = at.parent_path()) {
    if (error || at == at.parent_path()) break;
    missing = at;
  }
  return missing;
}

}  // namespace

ImpactFiles::ImpactFiles(const ImpactOptions& options, int viewpoint_count)
    : folder_(options.folder) {
  std::error_code error;
  made_ = topmost_missing(folder_);
  fs::create_directories(folder_, error);
  if (error)
    throw InputError("-o " + options.folder + ": cannot be made (" + error.message() +
                     "): check the folder above it");
  const InputFiles inputs(files_read(options), "this study");
  const auto claim = [&](const std::string& name) {
    const std::string path = (folder_ / name).string();
    inputs.refuse(path, "name another folder");
    return std::make_unique<OutputFile>(path, options.view.overwrite);
  };
  if (options.view.overwrite) former_ = files_of_a_study(folder_);
  for (const fs::path& file : former_) inputs.refuse(file.string(), "name another folder");
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
  remove_made();
}

// From the study's folder up, as long as they are empty.
void ImpactFiles::remove_made() const {
  if (made_.empty()) return;
  std::error_code not_empty;
  for (fs::path at = absolute_of(folder_); fs::remove(at, not_empty); at = at.parent_path())
    if (at == made_) return;
}

void ImpactFiles::commit() {
  std::set<fs::path> written;
  const auto put = [&](OutputFile& file) {
    file.commit();
    written.insert(file.path());
  };
  for (const OfViewpoint& files : viewpoints) {
    if (!files.complete) continue;
    for (const auto* file :
         {&files.before, &files.after, &files.difference, &files.wireline, &files.scene})
      put(**file);
  }
  for (const auto* file : {&zone, &table, &features, &report})
    if (*file) put(**file);
  for (const fs::path& file : former_)
    if (!written.contains(file)) fs::remove(file);
}

}  // namespace terrview
