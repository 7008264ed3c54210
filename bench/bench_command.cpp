#include "bench/bench_command.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "bench/bench_dem.h"
#include "bench/bench_options.h"
#include "bench/bench_result.h"
#include "bench/bench_view.h"
#include "bench/contender.h"
#include "bench/file_to_png.h"
#include "bench/light_study.h"
#include "bench/machine.h"
#include "bench/measure.h"
#include "bench/report.h"
#include "bench/surface_study.h"
#include "cli/output_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// Made when its turn comes, so that one DEM at a time is in memory.
struct Case {
  std::string scene;
  std::string path;  // of the DEM; empty = there is no file
  std::function<BenchDem()> dem;
  std::function<std::vector<BenchView>(const BenchDem&)> views;
};

BenchDem with_heights_times(float factor, const BenchDem& dem) {
  HeightGrid grid = *dem.grid;
  for (float& height_m : grid.heights_m) height_m *= factor;
  return make_bench_dem(dem.name, std::move(grid), dem.step_m);
}

// Coquillart 1984, 2.4: the heights of photo 2 are doubled, those of photo 3 tripled.
void add_thesis(std::vector<Case>& cases, const std::function<BenchDem()>& dem) {
  cases.push_back({"thesis", "", [dem] { return with_heights_times(2, dem()); },
                   [](const BenchDem& made) { return std::vector{thesis_valley(made)}; }});
  cases.push_back({"thesis", "", [dem] { return with_heights_times(3, dem()); },
                   [](const BenchDem& made) { return std::vector{thesis_top(made)}; }});
}

bool is_thesis_grid(const BenchDem& dem) {
  return dem.grid->columns == 256 && dem.grid->rows == 256;
}

std::vector<Case> make_cases(const BenchOptions& options) {
  const auto views = [size = options.size_px](const BenchDem& dem) { return six_views(dem, size); };
  std::vector<Case> cases{
      {"synthetic", "", [n = options.mountain_posts] { return synthetic_mountains(n); }, views},
      {"city", "", [n = options.city_posts] { return synthetic_city(n); }, views}};
  std::function<BenchDem()> thesis = thesis_mountains;
  for (const std::string& path : options.dems) {
    const BenchDem dem = read_bench_dem(path);  // a bad file is known before the measuring
    cases.push_back({"dem", path, [path] { return read_bench_dem(path); }, views});
    if (is_thesis_grid(dem))
      thesis = [path] {
        BenchDem found = read_bench_dem(path);
        found.name = "thesis-" + found.name;
        return found;
      };
  }
  add_thesis(cases, thesis);
  return cases;
}

bool is_chosen(const std::vector<std::string>& chosen, const std::string& name) {
  return chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end();
}

// Whether `name` is `wanted`, or begins with what stands before its final '*'.
bool matches(const std::string& wanted, const std::string& name) {
  if (!wanted.ends_with('*')) return name == wanted;
  return name.starts_with(wanted.substr(0, wanted.size() - 1));
}

std::vector<Contender> make_contenders(const BenchOptions& options, const BenchDem& dem) {
  const auto is_wanted = [&](const std::string& contender) {
    const auto names_it = [&](const std::string& name) { return matches(name, contender); };
    return options.contenders.empty() ||
           std::any_of(options.contenders.begin(), options.contenders.end(), names_it);
  };
  std::vector<Contender> contenders = terrview_contenders(dem, is_wanted);
  for (Contender& contender : embree_contenders(dem, is_wanted))
    contenders.push_back(std::move(contender));
  return contenders;
}

constexpr const char* kToPng = "file-to-png";

// The whole pictures are made of both.
std::vector<std::string> rays_to_trace(const BenchOptions& options) {
  return is_chosen(options.rays, kToPng) ? std::vector<std::string>{} : options.rays;
}

bool is_pictured(const BenchView& view) {
  return view.name == "horizon" || view.name == "valley" || view.name == "oblique";
}

int most_threads(const BenchOptions& options) {
  return *std::max_element(options.threads.begin(), options.threads.end());
}

// The file of a case, written for the time being where the mountains have none.
class DemFile {
 public:
  DemFile(const Case& which, const BenchDem& dem, bool is_wanted) {
    if (!is_wanted) return;
    path_ = which.path;
    if (which.scene != "synthetic") return;
    folder_ = std::filesystem::temp_directory_path() /
              ("terrview_bench_dem_" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder_);
    path_ = write_dem_file(dem, folder_);
  }
  ~DemFile() {
    std::error_code gone_already;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, gone_already);
  }
  DemFile(const DemFile&) = delete;
  DemFile& operator=(const DemFile&) = delete;

  explicit operator bool() const { return !path_.empty(); }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::filesystem::path folder_;
};

void measure_case(const Case& which, const BenchOptions& options, BenchRun& run) {
  const BenchDem dem = which.dem();
  std::vector<BenchView> views = which.views(dem);
  std::erase_if(views, [&](const BenchView& view) { return !is_chosen(options.views, view.name); });
  if (views.empty()) return;
  const std::vector<Contender> contenders = make_contenders(options, dem);
  const MeasureOptions how{rays_to_trace(options), options.threads, options.repetitions,
                           options.budget_s};
  const DemFile file(which, dem, is_chosen(options.rays, kToPng));
  for (const BenchView& view : views) {
    std::vector<BenchResult> results = measure(dem, view, contenders, how);
    if (file && is_pictured(view))
      for (BenchResult& result :
           file_to_png({file.path(), dem, view, most_threads(options), options.repetitions},
                       contenders, results))
        results.push_back(std::move(result));
    print_view(std::cout, results);
    std::cout.flush();
    run.results.insert(run.results.end(), results.begin(), results.end());
  }
}

void print_summaries(const std::vector<BenchResult>& results) {
  print_earth(std::cout, results);
  print_to_png(std::cout, results);
  print_thesis(std::cout, results);
}

BenchRun measure_all(const BenchOptions& options, const std::vector<std::string>& args) {
  BenchRun run{describe_machine(), "terrview-bench", utc_date(), {}};
  for (const std::string& arg : args) run.command += " " + arg;
  std::cout << run.machine.dump() << '\n';
  for (const Case& each : make_cases(options))
    if (is_chosen(options.scenes, each.scene)) measure_case(each, options, run);
  print_summaries(run.results);
  return run;
}

void study_surfaces(const BenchOptions& options) {
  std::cout << describe_machine().dump() << '\n';
  for (const Case& each : make_cases(options))
    if (is_chosen(options.scenes, each.scene) && each.scene != "thesis")
      print_surface_study(std::cout, each.dem(), options.size_px);
}

void study_light(const BenchOptions& options) {
  std::cout << describe_machine().dump() << '\n';
  for (const Case& each : make_cases(options)) {
    if (!is_chosen(options.scenes, each.scene) || each.scene == "thesis") continue;
    const BenchDem dem = each.dem();
    print_effect_costs(std::cout, dem, options.size_px, options.repetitions);
    print_sky_view_study(std::cout, dem);
  }
}

BenchRun read_run(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError("--from: " + path + ": cannot be opened: check its name");
  try {
    return run_from_json(nlohmann::ordered_json::parse(file));
  } catch (const nlohmann::json::exception& error) {
    throw InputError("--from: " + path + ": not what --json writes (" + error.what() +
                     "): measure again");
  }
}

// A page that cannot take the tables is known before the measuring.
std::string read_page(const std::string& path) {
  if (path.empty()) return {};
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  if (page_with_tables(text.str(), {}).empty())
    throw InputError("--page: " + path +
                     ": has no place for tables: give a page with the comments 'terrview-bench "
                     "--page: begin' and 'terrview-bench --page: end'");
  return text.str();
}

std::optional<OutputFile> claim(const std::string& path) {
  if (path.empty()) return std::nullopt;
  return std::optional<OutputFile>(std::in_place, path, /*overwrite=*/true);
}

void finish(std::optional<OutputFile>& file, const std::string& text) {
  if (!file) return;
  file->fill([&](const std::string& path) {
    std::ofstream stream(path);
    if (!(stream << text).flush()) throw std::runtime_error("cannot be written: is the disk full?");
  });
  file->commit();
}

}  // namespace

int run_bench(const std::vector<std::string>& args) {
  const std::optional<BenchOptions> options = parse_bench_options(args);
  if (!options) return 0;
  if (options->tremble) {
    study_surfaces(*options);
    return 0;
  }
  if (options->light) {
    study_light(*options);
    return 0;
  }
  std::optional<OutputFile> json = claim(options->json);
  std::optional<OutputFile> svg = claim(options->svg);
  const std::string old_page = read_page(options->page);
  std::optional<OutputFile> page = claim(options->page);
  BenchRun run;
  if (options->from.empty()) {
    run = measure_all(*options, args);
  } else {
    run = read_run(options->from);
    print_view(std::cout, run.results);
    print_summaries(run.results);
  }
  finish(json, to_json(run).dump(1) + '\n');
  finish(svg, figure_svg(run));
  finish(page, page_with_tables(old_page, run));
  return 0;
}

}  // namespace terrview
