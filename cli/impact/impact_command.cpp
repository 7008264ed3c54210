#include "cli/impact/impact_command.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "cli/impact/impact_files.h"
#include "cli/impact/impact_map.h"
#include "cli/impact/impact_options.h"
#include "cli/impact/impact_report.h"
#include "cli/impact/impact_study.h"
#include "cli/impact/impact_table.h"
#include "cli/impact/project.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/view_command.h"
#include "cli/view_messages.h"
#include "ingest/shared_tables.h"
#include "ingest/viewpoint_file.h"
#include "ingest/zone_file.h"
#include "render/write_file.h"

namespace terrview {
namespace {

std::vector<Dem> read_ground(const ImpactOptions& options) {
  DemOptions how = options.view.dem;
  ProgressBar bar("reading", show_bar(options.view));
  how.progress = [&](double share) {
    check_interrupt();
    bar.report(share);
  };
  std::vector<Dem> dems = read_dems(options.view.dems, how);
  make_shared_tables(dems, options.view.threads);
  return dems;
}

// Footprints that views read again and again.
std::vector<std::shared_ptr<const FootprintFile>> keep_footprints(const ImpactOptions& options,
                                                                  SharedInputs& inputs) {
  std::vector<std::shared_ptr<const FootprintFile>> kept;
  for (const auto& paths : {options.existing, options.view.objects.buildings})
    for (const std::string& path : paths)
      kept.push_back(inputs.footprints(path, options.view.objects.reading));
  return kept;
}

// The view options of the whole study, with all buildings.
ViewOptions with_all_buildings(const ImpactOptions& options) {
  ViewOptions view = options.view;
  view.objects.buildings.insert(view.objects.buildings.begin(), options.existing.begin(),
                                options.existing.end());
  return view;
}

std::vector<ViewpointStudy> study_viewpoints(const StudyGround& ground,
                                             const std::vector<Viewpoint>& viewpoints,
                                             ImpactFiles& files) {
  ProgressBar bar("viewpoints", show_bar(ground.options.view));
  std::vector<ViewpointStudy> studies;
  for (std::size_t i = 0; i < viewpoints.size(); ++i) {
    check_interrupt();
    studies.push_back(study_viewpoint(ground, viewpoints[i], files.viewpoints[i]));
    bar.report(static_cast<double>(i + 1) / static_cast<double>(viewpoints.size()));
  }
  return studies;
}

void write_tables(const ImpactStudy& study, const ImpactFiles& files) {
  files.table->fill(
      [&](const std::string& path) { write_file(path, csv_text(sights_layer(study))); });
  files.features->fill([&](const std::string& path) {
    write_geopackage(path, {viewpoints_layer(study), buildings_layer(study), sights_layer(study)});
  });
}

std::string label_of(const ViewpointStudy& study) {
  return "viewpoint " + std::to_string(study.viewpoint.number) + " (" + study.name + ")";
}

// A line for each text, with the first viewpoint that has it.
void say_once(const char* prefix, const std::vector<ViewpointStudy>& studies,
              const std::function<std::vector<std::string>(const ViewpointStudy&)>& texts_of) {
  std::map<std::string, int> counts;
  for (const ViewpointStudy& study : studies)
    for (const std::string& text : texts_of(study)) ++counts[text];
  for (const ViewpointStudy& study : studies) {
    for (const std::string& text : texts_of(study)) {
      const auto found = counts.find(text);
      if (found == counts.end()) continue;
      const std::string alike =
          found->second > 1 ? " and " + std::to_string(found->second - 1) + " more" : "";
      std::fprintf(stderr, "%s: %s%s: %s\n", prefix, label_of(study).c_str(), alike.c_str(),
                   text.c_str());
      counts.erase(found);
    }
  }
}

int say_what_was_done(const ImpactOptions& options, const std::vector<ViewpointStudy>& studies,
                      const ImpactFiles& files) {
  const auto failed = std::ranges::count_if(
      studies, [](const ViewpointStudy& study) { return !study.error.empty(); });
  const auto seeing = std::ranges::count_if(
      studies, [](const ViewpointStudy& study) { return study.project.is_seen(); });
  say_once("terrview", studies, [](const ViewpointStudy& study) {
    return study.error.empty() ? std::vector<std::string>() : std::vector{study.error};
  });
  if (!options.view.quiet) {
    say_once("warning", studies, [](const ViewpointStudy& study) { return study.warnings; });
    std::fprintf(stderr, "%zu viewpoints, %td failed; the project is seen from %td: %s\n",
                 studies.size(), failed, seeing, files.report->path().c_str());
  }
  constexpr int kSomeFailed = 3;
  return failed == 0 ? 0 : kSomeFailed;
}

}  // namespace

int run_impact(const std::vector<std::string>& args) {
  const ImpactOptions options = parse_impact(args);
  SharedInputs inputs;
  const auto kept = keep_footprints(options, inputs);
  const std::vector<Dem> dems = read_ground(options);
  if (!options.view.quiet) say_what_was_read(dems);
  const ViewpointFile viewpoints = read_viewpoints(options.viewpoints, dems.front());
  const Project project = read_project(with_all_buildings(options),
                                       options.view.objects.buildings.size(), dems, inputs);
  ImpactFiles files(options, static_cast<int>(viewpoints.viewpoints.size()));
  ImpactStudy study{project, {}, project.geographic ? "EPSG:4326" : ""};
  const StudyGround ground{options, project, dems, inputs};
  study.viewpoints = study_viewpoints(ground, viewpoints.viewpoints, files);
  write_tables(study, files);
  std::optional<Zone> zone;
  if (options.zone) {
    zone = zone_of(ground);
    files.zone->fill([&](const std::string& path) { write_zone(path, *zone); });
  }
  const Zone* const known_zone = zone ? &*zone : nullptr;
  files.report->fill([&](const std::string& path) {
    write_file(path,
               report_html({study, options, dems, known_zone, map_svg(study, ground, known_zone)}));
  });
  files.commit();
  return say_what_was_done(options, study.viewpoints, files);
}

}  // namespace terrview
