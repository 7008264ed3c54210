#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>

#include "bench/contender.h"
#include "bench/report.h"
#include "bench/study_text.h"

namespace terrview {
namespace {

using Results = std::vector<BenchResult>;

constexpr std::string_view kBegin = "<!-- terrview-bench --page: begin -->\n";
constexpr std::string_view kEnd = "<!-- terrview-bench --page: end -->\n";

template <class Value>
std::string cell(const char* pattern, const std::optional<Value>& value) {
  return value ? format(pattern, *value) : "";
}

double ns_per_ray(const BenchResult& result) { return 1e3 / result.mrays_per_s; }

// The fastest there of those whose names begin with `family`.
const BenchResult* best(const Results& results, const BenchResult& frame, std::string_view family) {
  const BenchResult* fastest = nullptr;
  for (const BenchResult& other : results)
    if (is_same_frame(other, frame) && other.contender.starts_with(family) &&
        (!fastest || other.mrays_per_s > fastest->mrays_per_s))
      fastest = &other;
  return fastest;
}

// The results of terrview's default way, which every table is about.
std::vector<const BenchResult*> of_terrview(const Results& results, std::string_view rays) {
  std::vector<const BenchResult*> ours;
  for (const BenchResult& result : results)
    if (result.contender == kDefaultWay && result.rays == rays) ours.push_back(&result);
  return ours;
}

// Of the best Embree, the speed of another way of terrview's.
std::string speed_of(const Results& results, const BenchResult& ours, const char* way) {
  const BenchResult* other = beside(results, ours, way);
  const BenchResult* theirs = best(results, ours, "embree");
  if (!other || !theirs) return " |";
  return format(" %.1f, ", ns_per_ray(*other)) +
         format("%.2fx |", other->mrays_per_s / theirs->mrays_per_s);
}

void write_speeds(std::ostream& out, const Results& results, const std::string& rays) {
  const bool shadows = rays == "shadow";
  out << "\n### " << (shadows ? "Shadow rays" : "Primary rays") << "\n\n| DEM, view | rays that "
      << (shadows ? "are stopped" : "hit")
      << " | threads | terrview, ns/ray | tests + nodes | best Embree | its ns/ray | terrview is | "
         "flips, max error | Embree's flips, other cells, p99, max error |"
      << (shadows ? " the map made for the frame: ns/ray, terrview is | no map |" : "")
      << "\n|---|---|---|---|---|---|---|---|---|---|" << (shadows ? "---|---|" : "") << '\n';
  for (const BenchResult* ours : of_terrview(results, rays)) {
    out << "| " << ours->dem << ", " << ours->view << " | "
        << (ours->hit_share ? format("%.1f %%", 100 * *ours->hit_share) : "") << " | "
        << ours->threads << format(" | %.1f | ", ns_per_ray(*ours))
        << cell("%.2f", ours->tests_per_ray) << cell(" + %.2f", ours->nodes_per_ray) << " | ";
    if (const BenchResult* theirs = best(results, *ours, "embree"))
      out << theirs->contender.substr(7) << format(" | %.1f", ns_per_ray(*theirs))
          << format(" | %.2fx | ", ours->mrays_per_s / theirs->mrays_per_s)
          << cell("%ld", ours->hit_flips) << cell(", %.2g", ours->max_rel_error) << " | "
          << cell("%ld", theirs->hit_flips) << cell(", %.2g", theirs->cells_differ)
          << cell(", %.2g", theirs->p99_rel_error) << cell(", %.2g", theirs->max_rel_error);
    else
      out << " | | | " << cell("%ld", ours->hit_flips) << cell(", %.2g", ours->max_rel_error)
          << " | ";
    out << " |";
    if (shadows)
      out << speed_of(results, *ours, kMapMadeWay) << speed_of(results, *ours, kNoMapWay);
    out << '\n';
  }
}

void write_builds(std::ostream& out, const Results& results) {
  out << "\n### Build and memory\n\n| DEM | structure | build, s | over terrview | MiB beyond the "
         "heights | over terrview |\n|---|---|---|---|---|---|\n";
  std::string last;
  for (const BenchResult* ours : of_terrview(results, "primary")) {
    if (ours->dem == last || !ours->build_s) continue;
    last = ours->dem;
    out << "| " << last << " | terrview " << format("| %.4f | ", *ours->build_s)
        << format("| %.2f | |\n", ours->memory_mib.value_or(0));
    for (const char* family : {"embree-tri", "embree-compact", "embree-grid"})
      if (const BenchResult* theirs = best(results, *ours, family))
        out << "| | " << family << format(" | %.3f", theirs->build_s.value_or(0))
            << format(" | %.0fx", theirs->build_s.value_or(0) / *ours->build_s)
            << format(" | %.1f", theirs->memory_mib.value_or(0))
            << format(" | %.0fx |\n",
                      theirs->memory_mib.value_or(0) / ours->memory_mib.value_or(1));
  }
}

void write_earths(std::ostream& out, const Results& results) {
  out << "\n### Curved Earth and bent tracks over flat ground\n\n| DEM, view | rays | threads | "
         "straight tracks | bent tracks | tests + nodes: flat, curved, bent |\n"
         "|---|---|---|---|---|---|\n";
  const auto work = [](const BenchResult& result) {
    return format("%.2f", result.tests_per_ray.value_or(0) + result.nodes_per_ray.value_or(0));
  };
  for (const char* rays : {"primary", "shadow"})
    for (const BenchResult* flat : of_terrview(results, rays)) {
      const BenchResult* curved = beside(results, *flat, kCurvedWay);
      const BenchResult* bent = beside(results, *flat, kBentWay);
      if (!curved || !bent) continue;
      out << "| " << flat->dem << ", " << flat->view << " | " << rays << " | " << flat->threads
          << format(" | %.2fx", flat->mrays_per_s / curved->mrays_per_s)
          << format(" | %.2fx | ", flat->mrays_per_s / bent->mrays_per_s) << work(*flat) << ", "
          << work(*curved) << ", " << work(*bent) << " |\n";
    }
}

void write_pictures(std::ostream& out, const Results& results) {
  out << "\n### From file to PNG, with shadows\n\n| DEM, view | threads | terrview, s | Embree, "
         "s: reading, building, rays | terrview is |\n|---|---|---|---|---|\n";
  for (const BenchResult* ours : of_terrview(results, "file-to-png"))
    for (const char* family : {"embree-tri", "embree-grid"})
      if (const BenchResult* theirs = best(results, *ours, family))
        out << "| " << ours->dem << ", " << ours->view << " | " << ours->threads
            << format(" | %.3f | ", *ours->seconds) << theirs->contender.substr(7)
            << format(": %.3f", *theirs->seconds)
            << format(" | %.2fx sooner |\n", *theirs->seconds / *ours->seconds);
}

void write_thesis(std::ostream& out, const Results& results) {
  std::ostringstream table;
  print_thesis(table, results);
  if (!table.str().empty())
    out << "\n### The thesis's own experiment\n\n```" << table.str() << "```\n";
}

// The machine as the run describes it, but for what it does not know.
std::string machine_of(const BenchRun& run) {
  std::string words;
  for (const auto& [key, value] : run.machine.items())
    if (!value.is_null())
      words += (words.empty() ? "" : ", ") + key + ' ' +
               (value.is_string() ? value.get<std::string>() : value.dump());
  return words;
}

std::string tables(const BenchRun& run) {
  std::ostringstream out;
  out << "Measured on " << run.date.substr(0, 10) << " (" << machine_of(run) << ") by\n\n```\n"
      << run.command << "\n```\n";
  for (const char* rays : {"primary", "shadow"}) write_speeds(out, run.results, rays);
  write_builds(out, run.results);
  write_earths(out, run.results);
  write_pictures(out, run.results);
  write_thesis(out, run.results);
  return out.str();
}

}  // namespace

std::string page_with_tables(const std::string& page, const BenchRun& run) {
  const std::size_t begin = page.find(kBegin);
  const std::size_t end = page.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
  return page.substr(0, begin + kBegin.size()) + '\n' + tables(run) + '\n' + page.substr(end);
}

}  // namespace terrview
