#include "bench/bench_options.h"

#include <algorithm>
#include <thread>

#include "cli/command_line.h"
#include "cli/parse.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// What a hurry leaves of it.
void make_quick(BenchOptions& options) {
  options.repetitions = 3;
  options.budget_s = 0.5;
  options.mountain_posts = 1024;
  options.city_posts = 512;
  options.size_px = {640, 360};
}

void check_names(const char* option, const std::vector<std::string>& given,
                 const std::vector<std::string>& known) {
  for (const std::string& name : given) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::string all;
    for (const std::string& each : known) all += (all.empty() ? "" : ", ") + each;
    throw InputError(std::string(option) + ": " + name + " is unknown: give some of " + all);
  }
}

std::vector<int> one_and_all_threads() {
  const int all = static_cast<int>(std::thread::hardware_concurrency());
  return all > 1 ? std::vector<int>{1, all} : std::vector<int>{1};
}

}  // namespace

std::optional<BenchOptions> parse_bench_options(const std::vector<std::string>& args) {
  BenchOptions options;
  CommandLine line("Speed and error of terrview and Embree on the same rays", "terrview-bench");
  bool quick = false;
  std::string size;
  int posts = 0;
  int repetitions = 0;
  line.add_option("--dem", options.dems, "DEM files, each a scene beside the synthetic ones");
  line.add_flag("--quick", quick, "small scenes and pictures");
  line.add_option("--json", options.json, "write the results");
  line.add_option("--svg", options.svg, "draw speed against error");
  line.add_option("--page", options.page, "put the tables into a Markdown page that is there");
  line.add_flag("--tremble", options.tremble,
                "instead: how the surface models differ, and how they move with the eye");
  line.add_flag("--light", options.light,
                "instead: what light and air cost, and the sky view beside Embree");
  line.add_option("--from", options.from, "show results that --json wrote instead of measuring");
  line.add_option("--scenes", options.scenes, "only these: synthetic, city, thesis, dem")
      ->delimiter(',');
  line.add_option("--views", options.views, "only these: horizon, gridline, ...")->delimiter(',');
  line.add_option("--rays", options.rays, "only these: primary, shadow, file-to-png")
      ->delimiter(',');
  line.add_option("--contenders", options.contenders,
                  "only these names; * at the end stands for the rest")
      ->delimiter(',');
  line.add_option("--threads", options.threads, "numbers of threads (1 and all)")
      ->delimiter(',')
      ->between(1, 1024);
  line.add_option("--repetitions", repetitions, "medians are of so many")->between(1, 1000);
  line.add_option("--posts", posts, "a side of the synthetic grid; the city's is half of it")
      ->between(16, 16384);
  line.add_option("--size", size, "WxH of the picture");
  try {
    line.parse_args(args);
  } catch (const NothingToDo&) {
    return std::nullopt;
  }
  if (quick) make_quick(options);
  if (repetitions > 0) options.repetitions = repetitions;
  if (posts > 0) {
    options.mountain_posts = posts;
    options.city_posts = posts / 2;
  }
  if (!size.empty()) options.size_px = parse_size(size);
  if (options.threads.empty()) options.threads = one_and_all_threads();
  check_names("--scenes", options.scenes, {"synthetic", "city", "thesis", "dem"});
  check_names("--views", options.views, {"horizon", "gridline", "valley", "oblique", "down", "up"});
  check_names("--rays", options.rays, {"primary", "shadow", "file-to-png"});
  return options;
}

}  // namespace terrview
