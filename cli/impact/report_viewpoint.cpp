#include <numbers>

#include <nlohmann/json.hpp>

#include "cli/camera_json.h"
#include "cli/impact/html_text.h"
#include "cli/impact/report_numbers.h"
#include "cli/impact/report_sections.h"

namespace terrview {
namespace {

std::string side(const std::string& name, const std::string& label, const std::string& alt,
                 const std::string& jpg) {
  return "<figure class=\"side " + name + "\"><img src=\"" + data_uri("image/jpeg", jpg) +
         "\" alt=\"" + html_text(alt) + "\"><figcaption>" + label + "</figcaption></figure>\n";
}

std::string slider(const ViewpointStudy& viewpoint) {
  const std::string id = "slide-" + std::to_string(viewpoint.viewpoint.number);
  return "<div class=\"compare\"><div class=\"frame\">\n" +
         side("before", "Before", viewpoint.name + ", without the project",
              viewpoint.pictures.before_jpg) +
         side("after", "After", viewpoint.name + ", with the project",
              viewpoint.pictures.after_jpg) +
         "<div class=\"split\"></div></div>\n<div class=\"slide\"><label for=\"" + id +
         "\">Before or after</label><input id=\"" + id +
         "\" type=\"range\" min=\"0\" max=\"100\" value=\"50\"></div></div>\n";
}

std::string row_of(const std::string& name, const SightNumbers& numbers, bool is_total) {
  std::string row = is_total ? "<tr class=\"total\">" : "<tr>";
  row += cell(name);
  for (const std::string& text :
       {std::to_string(numbers.pixels), solid_angle_text(numbers.solid_angle_sr),
        percent(numbers.facade_share()),
        fixed_number(numbers.facade.seen_m2, 0) + " of " +
            fixed_number(numbers.facade.facing_m2, 0),
        distance_text(numbers.nearest), distance_text(numbers.farthest)})
    row += number_cell(text);
  return row + "</tr>\n";
}

std::string numbers_table(const Project& project, const ViewpointStudy& viewpoint) {
  std::string table =
      "<div class=\"wide\"><table><caption>What is seen, by building.</caption><thead><tr>" +
      column_head("Building") + number_head("Pixels") + number_head("Solid angle, msr") +
      number_head("Facade seen") + number_head("Facade, m²") + number_head("Nearest point") +
      number_head("Farthest point") + "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < project.buildings.size(); ++i) {
    const ProjectBuilding& building = project.buildings[i];
    table += row_of(
        building.name.empty() ? "Building " + std::to_string(building.number) : building.name,
        viewpoint.buildings[i], /*is_total=*/false);
  }
  return table + row_of("The whole project", viewpoint.project, /*is_total=*/true) +
         "</tbody></table></div>\n";
}

std::string point_words(const std::optional<StudyPoint>& point, bool geographic) {
  if (!point) return kNothing;
  return place_words(point->place, geographic) + ", height " + fixed_number(point->height_m, 1) +
         " m";
}

std::string eye_words(const ViewpointStudy& viewpoint, bool geographic) {
  const double height_m = viewpoint.camera.eye.height_m;
  std::string words = place_words(viewpoint.viewpoint.place, geographic) + ", height " +
                      fixed_number(height_m, 1) + " m";
  if (viewpoint.ground_m)
    words += ", " + fixed_number(height_m - *viewpoint.ground_m, 2) + " m above the ground";
  return words;
}

std::string camera_words(const ResolvedView& camera) {
  return std::string(camera.projection == Projection::cylindrical ? "cylindrical" : "perspective") +
         ", heading " + fixed_number(camera.heading_deg, 2) + "°, pitch " +
         fixed_number(camera.pitch_deg, 2) + "°, roll " + fixed_number(camera.roll_deg, 2) +
         "°, horizontal field of view " + short_number(camera.fov_deg) + "°, " +
         std::to_string(camera.size_px.x) + " × " + std::to_string(camera.size_px.y) + " pixels";
}

std::string sun_words(const SunPosition& sun) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  return "azimuth " + fixed_number(sun.azimuth_rad * kDegrees, 1) + "°, elevation " +
         fixed_number(sun.elevation_rad * kDegrees, 1) + "°";
}

std::string facts(const Project& project, const ViewpointStudy& viewpoint) {
  const double pixels = static_cast<double>(viewpoint.camera.size_px.x) *
                        static_cast<double>(viewpoint.camera.size_px.y);
  return "<dl class=\"pairs\">\n" + pair("Eye", eye_words(viewpoint, project.geographic)) +
         pair("Camera", camera_words(viewpoint.camera)) + pair("Sun", sun_words(viewpoint.sun)) +
         pair("Nearest point seen", point_words(viewpoint.project.nearest, project.geographic)) +
         pair("Farthest point seen", point_words(viewpoint.project.farthest, project.geographic)) +
         pair("Horizon changed",
              percent(viewpoint.horizon_changed) +
                  (viewpoint.horizon_changed ? " of the picture's horizon" : "")) +
         pair("Picture changed", percent(static_cast<double>(viewpoint.changed_px) / pixels) +
                                     " of its pixels, shadows and reflections included") +
         "</dl>\n";
}

std::string other_pictures(const StudyPictures& pictures) {
  return "<div class=\"two\"><figure><img src=\"" + data_uri("image/png", pictures.difference_png) +
         "\" alt=\"The pixels that change\"><figcaption>What changes: white the project, grey its "
         "shadow, reflection or edge</figcaption></figure>\n<figure><img src=\"" +
         data_uri("image/svg+xml", pictures.wireline_svg) +
         "\" alt=\"The view as lines\"><figcaption>Wireline, with the "
         "project</figcaption></figure></div>\n";
}

std::string reproduction(const ViewpointStudy& viewpoint) {
  return "<h3>The pictures again</h3>\n<pre>" + html_text(viewpoint.before_command) + "\n" +
         html_text(viewpoint.after_command) + "</pre>\n<p>The scene file is <code>" +
         html_text(viewpoint.scene_name) +
         "</code>, beside this report. The camera, exactly:</p>\n<pre>" +
         html_text(camera_json(viewpoint.camera).dump()) +
         "</pre>\n<details><summary>Scene file</summary><pre>" + html_text(viewpoint.scene) +
         "</pre></details>\n";
}

}  // namespace

std::string viewpoint_section(const ReportParts& parts, const ViewpointStudy& viewpoint) {
  const std::string number = std::to_string(viewpoint.viewpoint.number);
  const bool is_seen = viewpoint.project.is_seen();
  const std::string head = "<section class=\"viewpoint\" id=\"viewpoint-" + number +
                           "\">\n<h2><span class=\"number" + (is_seen ? "" : " blind") + "\">" +
                           number + "</span>" + html_text(viewpoint.name) + "</h2>\n";
  if (!viewpoint.error.empty())
    return head + "<p>There is no view from here: " + html_text(viewpoint.error) +
           "</p>\n</section>\n";
  std::string notes = is_seen ? "" : "<p>Nothing of the project is seen from here.</p>\n";
  for (const std::string& warning : viewpoint.warnings)
    notes += "<p class=\"note\">Warning: " + html_text(warning) + "</p>\n";
  return head + notes + slider(viewpoint) + numbers_table(parts.study.project, viewpoint) +
         facts(parts.study.project, viewpoint) + other_pictures(viewpoint.pictures) +
         reproduction(viewpoint) + "</section>\n";
}

}  // namespace terrview
