#include "bench/quantize/quantize_bench.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "bench/machine.h"
#include "bench/quantize/quantize_contender.h"
#include "cli/command_line.h"
#include "ingest/picture_source.h"
#include "render/write_file.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> pictures;
  std::vector<int> colors{16, 64, 256, 4096};
  int repetitions = 5;
  std::string json;
};

Options parse_options(const std::vector<std::string>& args) {
  Options options;
  CommandLine line("Speed against error of quantisers of colours", "terrview-bench-quantize");
  line.add_option("PICTURE", options.pictures, "pictures that GDAL reads")->required();
  line.add_option("--colors", options.colors, "numbers of colours")
      ->delimiter(',')
      ->between(2, kMaxPaletteColors);
  line.add_option("--repetitions", options.repetitions, "medians are of so many")->between(1, 1000);
  line.add_option("--json", options.json, "write the results");
  line.parse_args(args);
  return options;
}

Picture read_picture(const std::string& path) {
  const PictureSource source(path);
  Picture picture{
      std::filesystem::path(path).stem().string(), source.size_px().x, source.size_px().y, {}};
  std::vector<std::uint8_t> valid;
  source.read(0, picture.height_px, picture.pixels, valid);
  return picture;
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// All contenders for one picture and number of colours, run in turns.
std::vector<QuantizeResult> measure(const Picture& picture, int colors, int repetitions,
                                    const std::vector<QuantizeContender>& contenders) {
  std::vector<QuantizeResult> results;
  std::vector<std::unique_ptr<QuantizeJob>> jobs;
  for (const QuantizeContender& contender : contenders) {
    if (colors > contender.max_colors) continue;
    results.push_back({picture.name, contender.name, colors, 0, 0, {}});
    jobs.push_back(contender.prepare(picture, colors));
  }
  std::vector<std::vector<double>> seconds(jobs.size());
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const double start_s = thread_seconds();
      jobs[i]->run();
      seconds[i].push_back(thread_seconds() - start_s);
    }
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::sort(seconds[i].begin(), seconds[i].end());
    const Rewritten rewritten = jobs[i]->result();
    results[i].palette = rewritten.palette.size();
    results[i].mpixels_per_s =
        static_cast<double>(picture.pixels.size()) / seconds[i][seconds[i].size() / 2] / 1e6;
    results[i].errors = picture_errors(picture, rewritten);
  }
  return results;
}

Json to_json(const QuantizeResult& result) {
  return {{"picture", result.picture},
          {"contender", result.contender},
          {"colors", result.colors},
          {"palette", result.palette},
          {"mpixels_per_s", result.mpixels_per_s},
          {"mean_component", result.errors.mean_component},
          {"max_component", result.errors.max_component},
          {"mean_ciede2000", result.errors.mean_ciede2000},
          {"max_ciede2000", result.errors.max_ciede2000},
          {"banding", result.errors.banding}};
}

}  // namespace

int run_quantize_bench(const std::vector<std::string>& args) {
  const Options options = parse_options(args);
  std::vector<QuantizeContender> contenders = terrview_quantizers();
  for (const auto& more : {gdal_quantizers(), imagequant_quantizers()})
    contenders.insert(contenders.end(), more.begin(), more.end());
  std::vector<QuantizeResult> results;
  for (const std::string& path : options.pictures) {
    const Picture picture = read_picture(path);
    for (const int colors : options.colors) {
      const auto more = measure(picture, colors, options.repetitions, contenders);
      results.insert(results.end(), more.begin(), more.end());
    }
  }
  print_means(std::cout, results);
  print_comparison(std::cout, results);
  if (options.json.empty()) return 0;
  Json json{{"machine", describe_machine()}, {"date", utc_date()}, {"results", Json::array()}};
  for (const QuantizeResult& result : results) json["results"].push_back(to_json(result));
  write_file(options.json, json.dump(2) + "\n");
  return 0;
}

}  // namespace terrview
