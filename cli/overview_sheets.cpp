#include "cli/overview_sheets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <set>
#include <system_error>

#include <glm/common.hpp>

#include "cli/batch/output_template.h"
#include "cli/input_files.h"
#include "cli/interrupt.h"
#include "cli/output_options.h"
#include "cli/plan.h"
#include "cli/view_command.h"
#include "cli/view_files.h"
#include "cli/view_messages.h"
#include "cli/view_setup.h"
#include "ingest/sheet_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr int kMostSheets = 100'000;
// Of a pixel: what borders of sheets lose on the way through coordinates.
constexpr double kRounding_px = 1e-6;

// Sheets of equal size, but for the last of a row and of a column.
std::vector<Sheet> regular(glm::ivec2 whole_px, glm::ivec2 count,
                           const std::function<glm::ivec2(glm::ivec2 tile)>& corner) {
  if (std::int64_t{count.x} * count.y > kMostSheets)
    throw InputError("--tiles, --tile-size: make more than " + std::to_string(kMostSheets) +
                     " sheets: give fewer, or larger ones");
  std::vector<Sheet> sheets;
  for (int row = 0; row < count.y; ++row) {
    for (int column = 0; column < count.x; ++column) {
      const glm::ivec2 first = glm::min(corner({column, row}), whole_px);
      const glm::ivec2 end = glm::min(corner({column + 1, row + 1}), whole_px);
      sheets.push_back({std::to_string(column) + "_" + std::to_string(row), {first, end - first}});
    }
  }
  return sheets;
}

std::vector<Sheet> tiles(glm::ivec2 whole_px, glm::ivec2 count) {
  if (count.x > whole_px.x || count.y > whole_px.y)
    throw InputError("--tiles: more sheets than pixels: the map has " + std::to_string(whole_px.x) +
                     "x" + std::to_string(whole_px.y));
  return regular(whole_px, count, [&](glm::ivec2 tile) {
    const glm::dvec2 share = glm::dvec2(tile) / glm::dvec2(count);
    return glm::ivec2(glm::round(share * glm::dvec2(whole_px)));
  });
}

// The pixels whose centres lie in [low, high) of the DEM's posts.
PixelRect pixels_between(const PlanLattice& whole, glm::dvec2 low_uv, glm::dvec2 high_uv) {
  const auto first_centre = [&](glm::dvec2 uv) {
    const glm::dvec2 centre = (uv - whole.corner_uv) / whole.step_uv - 0.5;
    return glm::ivec2(
        glm::clamp(glm::ceil(centre - kRounding_px), glm::dvec2(0), glm::dvec2(whole.size_px)));
  };
  const glm::ivec2 first = first_centre(low_uv);
  return {first, first_centre(high_uv) - first};
}

std::vector<Sheet> outlined(const OverviewOptions& options, const PlanLattice& whole,
                            const Dem& dem) {
  if (dem.placement.step[0].y != 0 || dem.placement.step[1].x != 0)
    throw InputError("--sheets: '" + dem.name +
                     "' is turned against its coordinates: give --tiles or --tile-size");
  std::vector<Sheet> sheets;
  for (const SheetOutline& outline : read_sheet_outlines(options.sheets, options.sheet_name, dem)) {
    const glm::dvec2 a = dem.placement.posts(outline.low);
    const glm::dvec2 b = dem.placement.posts(outline.high);
    const PixelRect pixels = pixels_between(whole, glm::min(a, b), glm::max(a, b));
    if (pixels.size_px.x > 0 && pixels.size_px.y > 0) sheets.push_back({outline.name, pixels});
  }
  if (sheets.empty())
    throw InputError("'" + options.sheets +
                     "': none of its outlines lies on the DEM: check its coordinate system");
  return sheets;
}

// A text as a template has it.
std::string without_holes(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += std::string(c == '{' || c == '}' ? 2 : 1, c);
  return escaped;
}

std::string pattern_of(const ViewOptions& options) {
  if (!options.output.empty()) return options.output;
  const std::string extension = options.format.empty() ? ".tif" : usual_extension(options.format);
  return without_holes(std::filesystem::path(options.dems.front()).stem().string()) + "_{name}" +
         extension;
}

// Throws InputError unless all sheets can be written, as far as names tell.
void check_files(const std::vector<std::string>& paths, const OverviewOptions& options) {
  const InputFiles inputs({options.sheets}, "this map");
  ViewOptions of_sheet = options.view;
  std::set<std::string> used;
  for (const std::string& path : paths) {
    of_sheet.output = path;
    const ViewFiles files(of_sheet, ViewFiles::NamesOnly{});
    for (const std::string& file : files.paths()) {
      if (!used.insert(file).second)
        throw InputError("'" + file + "': named by two sheets: give them names of their own");
      inputs.refuse(file);
      std::error_code error;
      if (std::filesystem::exists(file, error) && !of_sheet.overwrite)
        throw InputError("'" + file + "': exists already: give --overwrite to replace it");
      if (error)
        throw InputError("'" + file + "': cannot be written (" + error.message() +
                         "): choose another name");
    }
  }
}

void make_sheet(ViewOptions options, const View& view, const Dem& dem, const PlanLattice& lattice,
                const std::string& label) {
  make_folder_of(options.output);
  ViewFiles files(options);
  const PlanFrame frame = draw_plan(options, view, lattice, label);
  write_plan(options, view, dem, lattice, frame, files);
  files.commit();
  if (!options.quiet) std::fprintf(stderr, "wrote %s\n", files.image->path().c_str());
}

}  // namespace

std::vector<Sheet> sheets_of(const OverviewOptions& options, const PlanLattice& whole,
                             const Dem& dem) {
  if (options.tiles) return tiles(whole.size_px, *options.tiles);
  if (!options.tile_size_px) return outlined(options, whole, dem);
  const glm::ivec2 size = *options.tile_size_px;
  const glm::ivec2 count = (whole.size_px - 1) / size + 1;
  return regular(whole.size_px, count, [size](glm::ivec2 tile) { return tile * size; });
}

std::vector<std::string> sheet_paths(const std::string& pattern, const std::vector<Sheet>& sheets) {
  const OutputTemplate names("-o", pattern);
  if (!names.has_holes())
    throw InputError("-o '" + pattern + "': names one file for all sheets: put {name} into it");
  for (const std::string& column : names.columns())
    if (column != "name")
      throw InputError("-o '" + pattern + "': {" + column + "}: sheets have a {name}, an {index}");
  std::vector<std::string> paths;
  for (const Sheet& sheet : sheets) {
    const int index = static_cast<int>(paths.size()) + 1;
    JobRow row;
    row.cells["name"] = {sheet.name};
    try {
      paths.push_back(names.fill(row, index));
    } catch (const InputError& error) {
      throw InputError("sheet " + std::to_string(index) + ": " + error.what());
    }
  }
  return paths;
}

int make_sheets(OverviewOptions options) {
  ViewOptions& of_view = options.view;
  const std::string pattern = pattern_of(of_view);
  static_cast<void>(sheet_paths(pattern, {}));  // throws before the work begins
  const std::vector<Dem> dems = read_with_bar(of_view);
  const Dem& dem = dems.front();
  const PlanLattice whole = plan_lattice(of_view, dem);
  const std::vector<Sheet> sheets = sheets_of(options, whole, dem);
  const std::vector<std::string> paths = sheet_paths(pattern, sheets);
  check_files(paths, options);
  const View view = make_view(of_view, dems);
  if (!of_view.quiet) say_what_is_seen(dems, view);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    PlanLattice part = whole;
    part.first_px = sheets[i].pixels.first_px;
    part.size_px = sheets[i].pixels.size_px;
    ViewOptions of_sheet = of_view;
    of_sheet.output = paths[i];
    try {
      make_sheet(std::move(of_sheet), view, dem, part, sheets[i].name);
    } catch (const Interrupted&) {
      throw Interrupted{i > 0 ? paths[i - 1] : std::string()};
    }
  }
  return 0;
}

}  // namespace terrview
