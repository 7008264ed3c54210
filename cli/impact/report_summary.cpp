#include <algorithm>
#include <cmath>

#include "cli/impact/html_text.h"
#include "cli/impact/report_numbers.h"
#include "cli/impact/report_sections.h"
#include "ingest/dem_info.h"

namespace terrview {
namespace {

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string lead(const ReportParts& parts) {
  const ImpactStudy& study = parts.study;
  const auto seeing = std::ranges::count_if(
      study.viewpoints, [](const ViewpointStudy& one) { return one.project.is_seen(); });
  const auto failed = std::ranges::count_if(
      study.viewpoints, [](const ViewpointStudy& one) { return !one.error.empty(); });
  double highest_m = 0;
  for (const ProjectBuilding& building : study.project.buildings)
    highest_m = std::max(highest_m, building.height_m);
  return "<p class=\"lead\">The project, " + counted(study.project.buildings.size(), "building") +
         " up to " + short_number(highest_m) + " m high, is seen from " + std::to_string(seeing) +
         " of " + counted(study.viewpoints.size() - static_cast<std::size_t>(failed), "viewpoint") +
         (failed > 0 ? "; " + std::to_string(failed) + (failed == 1 ? " has" : " have") + " no view"
                     : std::string()) +
         ".</p>\n";
}

// The share of the ground from which some roof point is seen, and its area.
std::string zone_words(const ReportParts& parts) {
  const Zone& zone = *parts.zone;
  const auto known = std::ranges::count_if(zone.counts, [](float n) { return n >= 0; });
  const auto seeing = std::ranges::count_if(zone.counts, [](float n) { return n > 0; });
  const glm::dvec2 spacing_m = describe_dem(parts.dems.front()).spacing_m;
  const double area_km2 = static_cast<double>(seeing) * spacing_m.x * spacing_m.y / 1e6;
  return "<p>At least one of " + counted(parts.study.project.roof_points.size(), "roof point") +
         " is in sight from " + percent(static_cast<double>(seeing) / static_cast<double>(known)) +
         " of the ground of the elevation model, about " + short_number(area_km2) +
         " km², for an eye " + short_number(parts.options.eye_height_m) +
         " m above it. <code>zone.tif</code> has, for each post, how many of them are seen and "
         "the angle they span.</p>\n";
}

std::string map_figure(const ReportParts& parts) {
  return "<figure>" + parts.map_svg +
         "<figcaption>The viewpoints and the project.<span class=\"key seeing\"></span>"
         "sees the project<span class=\"key\"></span>does not" +
         (parts.zone != nullptr ? "<span class=\"key zone\"></span>zone of theoretical visibility"
                                : std::string()) +
         "<span class=\"key project\"></span>the project</figcaption></figure>\n";
}

std::string row_of(const ViewpointStudy& one) {
  std::string row = "<tr>" + number_cell(std::to_string(one.viewpoint.number)) +
                    "<td class=\"name\"><a href=\"#viewpoint-" +
                    std::to_string(one.viewpoint.number) + "\">" + html_text(one.name) +
                    "</a></td>";
  if (!one.error.empty())
    return row + "<td colspan=\"6\">no view: " + html_text(one.error) + "</td></tr>\n";
  row += "<td>" + std::string(one.project.is_seen() ? "yes" : "no") + "</td>";
  for (const std::string& text :
       {distance_text(one.project.nearest), solid_angle_text(one.project.solid_angle_sr),
        percent(one.project.facade_share()), percent(one.horizon_changed),
        std::to_string(one.project.pixels)})
    row += number_cell(text);
  return row + "</tr>\n";
}

std::string viewpoint_table(const ImpactStudy& study) {
  std::string table =
      "<div class=\"wide\"><table><caption>What is seen of the project from each viewpoint; the "
      "terms are explained under Method.</caption><thead><tr>" +
      number_head("No.") + column_head("Viewpoint") + column_head("Seen") +
      number_head("Nearest point seen") + number_head("Solid angle, msr") +
      number_head("Facade seen") + number_head("Horizon changed") + number_head("Pixels") +
      "</tr></thead><tbody>\n";
  for (const ViewpointStudy& viewpoint : study.viewpoints) table += row_of(viewpoint);
  return table + "</tbody></table></div>\n";
}

std::string building_table(const ImpactStudy& study) {
  std::string table = "<table><caption>The buildings of the project.</caption><thead><tr>" +
                      number_head("No.") + column_head("Building") + number_head("Height, m") +
                      number_head("Seen from viewpoints") + "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < study.project.buildings.size(); ++i) {
    const ProjectBuilding& building = study.project.buildings[i];
    std::string seen_from;
    for (const ViewpointStudy& viewpoint : study.viewpoints)
      if (i < viewpoint.buildings.size() && viewpoint.buildings[i].is_seen())
        seen_from += (seen_from.empty() ? "" : ", ") + std::to_string(viewpoint.viewpoint.number);
    table += "<tr>" + number_cell(std::to_string(building.number)) +
             cell(building.name.empty() ? kNothing : building.name) +
             number_cell(short_number(building.height_m)) +
             number_cell(seen_from.empty() ? kNothing : seen_from) + "</tr>\n";
  }
  return table + "</tbody></table>\n";
}

}  // namespace

std::string summary_section(const ReportParts& parts) {
  return "<section class=\"follows\" id=\"summary\">\n<h2>Summary</h2>\n" + lead(parts) +
         (parts.zone != nullptr ? zone_words(parts) : "") + map_figure(parts) +
         viewpoint_table(parts.study) + building_table(parts.study) + "</section>\n";
}

}  // namespace terrview
