#include "bench/report.h"

#include <algorithm>
#include <array>
#include <optional>
#include <ostream>

#include "bench/contender.h"
#include "bench/study_text.h"

namespace terrview {
namespace {

std::string threads_of(const BenchResult& result) {
  return std::to_string(result.threads) + (result.threads == 1 ? " thread" : " threads");
}

bool is_embree(const BenchResult& result) { return result.contender.starts_with("embree"); }

template <class Value>
std::string cell(const char* pattern, const std::optional<Value>& value) {
  return value ? format(pattern, *value) : "-";
}

std::string pad(const std::string& text, std::size_t width, bool left) {
  const std::string space(width > text.size() ? width - text.size() : 0, ' ');
  return left ? text + space : space + text;
}

constexpr std::array<std::size_t, 13> kWidths{24, 11, 9, 9, 9, 8, 8, 8, 8, 10, 7, 9, 9};

void print_row(std::ostream& out, const std::array<std::string, kWidths.size()>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) out << ' ' << pad(cells[i], kWidths[i], i < 2);
  out << '\n';
}

void print_group(std::ostream& out, std::vector<BenchResult> group) {
  const BenchResult& head = group[0];
  out << '\n'
      << head.dem << ", " << head.view << ", " << head.rays << " rays, " << threads_of(head);
  const auto with_share = std::find_if(group.begin(), group.end(), [](const BenchResult& result) {
    return result.hit_share.has_value();
  });
  if (with_share != group.end())
    out << format(", %.1f %% meet ground", 100 * *with_share->hit_share);
  out << '\n';
  print_row(out, {"contender", "surface", "Mray/s", "ns/ray", "x Embree", "tests", "nodes",
                  "build s", "MiB", "cells diff", "flips", "p99 error", "max error"});
  double best_embree = 0;
  for (const BenchResult& result : group)
    if (is_embree(result)) best_embree = std::max(best_embree, result.mrays_per_s);
  std::stable_sort(group.begin(), group.end(), [](const BenchResult& a, const BenchResult& b) {
    return a.mrays_per_s > b.mrays_per_s;
  });
  for (const BenchResult& result : group)
    print_row(out, {result.contender, result.surface.value_or("-"),
                    format("%.2f", result.mrays_per_s), format("%.1f", 1e3 / result.mrays_per_s),
                    best_embree > 0 ? format("%.2f", result.mrays_per_s / best_embree) : "-",
                    cell("%.2f", result.tests_per_ray), cell("%.2f", result.nodes_per_ray),
                    cell("%.3f", result.build_s), cell("%.4g", result.memory_mib),
                    cell("%.2g", result.cells_differ), cell("%ld", result.hit_flips),
                    cell("%.2g", result.p99_rel_error), cell("%.2g", result.max_rel_error)});
}

struct ThesisFigure {
  const char* view;
  const char* photo;
  double plain;
  double coherent;
};
constexpr std::array<ThesisFigure, 2> kThesisFigures{
    {{"valley", "photo 2, valley", 44, 1.49}, {"oblique", "photo 3, from above", 85, 1.45}}};

}  // namespace

void print_view(std::ostream& out, const std::vector<BenchResult>& results) {
  for (auto first = results.begin(); first != results.end();) {
    const auto last = std::find_if(first, results.end(), [&](const BenchResult& result) {
      return !is_same_frame(result, *first);
    });
    if (!first->seconds) print_group(out, {first, last});
    first = last;
  }
}

void print_thesis(std::ostream& out, const std::vector<BenchResult>& results) {
  bool first = true;
  for (const BenchResult& result : results) {
    if (!result.dem.starts_with("thesis") || result.rays != "primary" || !result.tests_per_ray)
      continue;
    for (const ThesisFigure& figure : kThesisFigures) {
      if (result.view != figure.view || result.threads != results[0].threads) continue;
      if (first) out << "\nTests per primary ray, and those of Coquillart 1984\n";
      first = false;
      out << "  " << pad(figure.photo, 21, true) << pad(result.contender, 20, true)
          << pad(result.surface.value_or("-"), 12, true)
          << pad(format("%.2f", *result.tests_per_ray), 8, false) << "   thesis " << figure.plain
          << ", with coherence " << figure.coherent << '\n';
    }
  }
}

void print_to_png(std::ostream& out, const std::vector<BenchResult>& results) {
  bool first = true;
  for (const BenchResult& result : results) {
    if (!result.seconds) continue;
    if (first)
      out << "\nFrom file to PNG with shadows; of Embree reading, building and the rays alone\n";
    first = false;
    const BenchResult* ours = beside(results, result, kDefaultWay);
    out << "  " << pad(result.dem, 18, true) << pad(result.view, 10, true)
        << pad(threads_of(result), 12, true) << pad(result.contender, 26, true)
        << pad(format("%.3f s", *result.seconds), 10, false);
    if (ours) out << pad(format("%.2f x terrview", *result.seconds / *ours->seconds), 18, false);
    out << '\n';
  }
}

void print_earth(std::ostream& out, const std::vector<BenchResult>& results) {
  bool first = true;
  for (const BenchResult& flat : results) {
    if (flat.contender != kDefaultWay) continue;
    const BenchResult* curved = beside(results, flat, kCurvedWay);
    const BenchResult* bent = beside(results, flat, kBentWay);
    if (!curved && !bent) continue;
    if (first) out << "\nTime on the curved Earth over that on a flat one: straight tracks, bent\n";
    first = false;
    const auto ratio = [&](const BenchResult* other) {
      return other ? format("%.2f", flat.mrays_per_s / other->mrays_per_s) : "-";
    };
    out << "  " << pad(flat.dem, 18, true) << pad(flat.view, 10, true) << pad(flat.rays, 9, true)
        << pad(threads_of(flat), 12, true) << pad(ratio(curved), 8, false)
        << pad(ratio(bent), 8, false) << '\n';
  }
}

}  // namespace terrview
