#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <ostream>
#include <utility>

#include "bench/quantize/quantize_bench.h"

namespace terrview {
namespace {

struct Sum {
  int pictures = 0;
  double seconds_per_mpixel = 0;
  PictureErrors errors;

  void add(const QuantizeResult& result) {
    ++pictures;
    seconds_per_mpixel += 1 / result.mpixels_per_s;
    errors.mean_component += result.errors.mean_component;
    errors.max_component = std::max(errors.max_component, result.errors.max_component);
    errors.mean_ciede2000 += result.errors.mean_ciede2000;
    errors.max_ciede2000 = std::max(errors.max_ciede2000, result.errors.max_ciede2000);
    errors.banding += result.errors.banding;
  }
  [[nodiscard]] double mpixels_per_s() const { return pictures / seconds_per_mpixel; }
  [[nodiscard]] double mean_ciede2000() const { return errors.mean_ciede2000 / pictures; }
};

// In the order in which they come.
std::vector<std::pair<std::string, Sum>> sums_of(const std::vector<QuantizeResult>& results,
                                                 int colors) {
  std::vector<std::pair<std::string, Sum>> sums;
  for (const QuantizeResult& result : results) {
    if (result.colors != colors) continue;
    const auto known = std::find_if(sums.begin(), sums.end(),
                                    [&](const auto& sum) { return sum.first == result.contender; });
    Sum& sum =
        known == sums.end() ? sums.emplace_back(result.contender, Sum{}).second : known->second;
    sum.add(result);
  }
  return sums;
}

std::optional<Sum> find(const std::vector<QuantizeResult>& results, int colors,
                        const std::string& contender) {
  for (const auto& [name, sum] : sums_of(results, colors))
    if (name == contender) return sum;
  return std::nullopt;
}

}  // namespace

void print_means(std::ostream& out, const std::vector<QuantizeResult>& results) {
  std::map<int, bool> numbers;
  for (const QuantizeResult& result : results) numbers[result.colors] = true;
  for (const auto& [colors, unused] : numbers) {
    char line[160];
    std::snprintf(line, sizeof line, "\n%-18s %9s | %14s | %16s | %9s\n",
                  (std::to_string(colors) + " colours").c_str(), "Mpixel/s", "component",
                  "CIEDE2000", "banding");
    out << line;
    std::snprintf(line, sizeof line, "%-18s %9s | %7s %6s | %8s %7s | %9s\n", "", "", "mean", "max",
                  "mean", "max", "%");
    out << line;
    for (const auto& [name, sum] : sums_of(results, colors)) {
      std::snprintf(line, sizeof line, "%-18s %9.1f | %7.2f %6d | %8.3f %7.1f | %9.3f\n",
                    name.c_str(), sum.mpixels_per_s(), sum.errors.mean_component / sum.pictures,
                    sum.errors.max_component, sum.mean_ciede2000(), sum.errors.max_ciede2000,
                    100 * sum.errors.banding / sum.pictures);
      out << line;
    }
  }
}

void print_comparison(std::ostream& out, const std::vector<QuantizeResult>& results) {
  const auto ours = find(results, 256, "tree");
  const auto ours_fine = find(results, 4096, "tree");
  const auto thesis_fine = find(results, 4096, "thesis");
  const auto gdal = find(results, 256, "gdal-median-cut");
  char line[160];
  if (ours && gdal) {
    std::snprintf(
        line, sizeof line,
        "\nmean CIEDE2000 at 256 colours: tree %.3f, gdal-median-cut %.3f: %.0f %% less\n",
        ours->mean_ciede2000(), gdal->mean_ciede2000(),
        100 * (1 - ours->mean_ciede2000() / gdal->mean_ciede2000()));
    out << line;
  }
  if (!ours_fine || !thesis_fine) return;
  for (const char* name :
       {"gdal-median-cut", "gdal-palette", "libimagequant", "libimagequant-10"}) {
    const auto rival = find(results, 256, name);
    if (!rival) continue;
    std::snprintf(line, sizeof line,
                  "speed at 4096 colours beside %s at 256: tree %.1fx, thesis %.1fx\n", name,
                  ours_fine->mpixels_per_s() / rival->mpixels_per_s(),
                  thesis_fine->mpixels_per_s() / rival->mpixels_per_s());
    out << line;
  }
}

}  // namespace terrview
