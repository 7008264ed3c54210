#include <filesystem>

#include "cli/command_line.h"
#include "cli/impact/html_text.h"
#include "cli/impact/report_numbers.h"
#include "cli/impact/report_sections.h"
#include "cli/view_light.h"
#include "ingest/dem_info.h"

namespace terrview {
namespace {

std::string or_unknown(const std::string& text) { return text.empty() ? "not said" : text; }

std::string crs_words(const DemInfo& info) {
  if (info.crs_name.empty()) return "none: level ground in the file's own coordinates";
  return info.crs_name + (info.crs_code.empty() ? "" : " (" + info.crs_code + ")");
}

std::string operation_words(const DemInfo& info) {
  if (!info.operation) return kNothing;
  return info.operation->name + ", accuracy " +
         (info.operation->accuracy_m ? short_number(*info.operation->accuracy_m) + " m"
                                     : "not known");
}

std::string dem_facts(const Dem& dem) {
  const DemInfo info = describe_dem(dem);
  return "<dl class=\"pairs\">\n" + pair("Elevation model", dem.name) +
         pair("Posts", std::to_string(dem.grid->columns) + " × " + std::to_string(dem.grid->rows) +
                           ", " + short_number(info.spacing_m.x) + " m × " +
                           short_number(info.spacing_m.y) + " m apart in the middle") +
         pair("Coordinate reference system", crs_words(info)) +
         pair("Operation to WGS 84", operation_words(info)) +
         pair("Vertical datum", or_unknown(dem.vertical_datum)) +
         pair("Heights", fixed_number(info.range.lowest_m, 1) + " to " +
                             fixed_number(info.range.highest_m, 1) +
                             " m; unit in the file: " + or_unknown(dem.height_unit)) +
         pair("Voids", std::to_string(dem.voids_filled) + " posts filled, " +
                           std::to_string(dem.voids_open) + " left open") +
         "</dl>\n";
}

std::string joined(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& path : paths) text += (text.empty() ? "" : ", ") + path;
  return text.empty() ? "none" : text;
}

std::string earth_words(const ReportParts& parts) {
  const ViewOptions& view = parts.options.view;
  const ResolvedView usual;
  const bool flat = view.earth == EarthModel::flat || !parts.study.project.geographic;
  if (flat) return "flat: no curvature, no refraction";
  const double k = view.refraction.value_or(usual.refraction);
  return "curved (WGS 84); terrestrial refraction k = " + short_number(k) +
         ", which leaves 1 − k = " + short_number(1 - k) + " of the curvature's drop";
}

std::string air_words(const AirOptions& air) {
  if (air.extinction_per_km)
    return "extinction " + short_number(*air.extinction_per_km) + " per km";
  const double visibility_km = air.visibility_km.value_or(kUsualVisibility_km);
  if (visibility_km > 1e6) return "none";
  return "visibility " + short_number(visibility_km) + " km";
}

std::string study_facts(const ReportParts& parts) {
  const ImpactOptions& options = parts.options;
  return "<dl class=\"pairs\">\n" + pair("Project", joined(options.view.objects.buildings)) +
         pair("Buildings that stand", joined(options.existing)) +
         pair("Viewpoints", options.viewpoints) +
         pair("Eye height", short_number(options.eye_height_m) +
                                " m above the ground, where a viewpoint does not say") +
         pair("Earth", earth_words(parts)) +
         pair("Ground between posts", name_of(options.view.surface)) +
         pair("Air", air_words(options.view.air)) +
         pair("Sun", "as said for each viewpoint; the same before and after, as are air and sky") +
         pair("Software", std::string("terrview ") + kVersion) + "</dl>\n<pre>" +
         html_text(options.command) + "</pre>\n";
}

// docs/impact.md says the same at length.
constexpr const char* kDefinitions = R"html(
<h3>What the numbers mean</h3>
<dl class="pairs">
<dt>Seen</dt><dd>Some ray from the eye meets the project first. Each building is sampled by 512 × 512
rays of its own and by some 4000 rectangles of its walls, whatever picture is made; what is smaller than
their share of it can be missed.</dd>
<dt>Pixels</dt><dd>Of the picture after, those whose middle shows the building. They depend on the
picture's size and on what it shows; the other numbers do not.</dd>
<dt>Solid angle</dt><dd>How much of the field of view the visible part takes up, in millisteradians
(msr), within 1 % of the building's own. The full moon has 0.064 msr.</dd>
<dt>Facade seen</dt><dd>Of the area of the walls above ground whose outer sides are turned to the eye,
the share that neither ground nor buildings hide, within 1 % of that area. Roofs do not count.</dd>
<dt>Nearest, farthest point</dt><dd>Of what these rays and rectangles show of the project, in a straight
line from the eye: of walls to within a fiftieth of the building's size.</dd>
<dt>Horizon changed</dt><dd>Of the picture's columns that show where the sky begins, the share where it
begins at another row than before. It is off by up to two columns for each stretch that changes, and
does not tell of changes under a pixel.</dd>
)html";

constexpr const char* kZoneDefinition =
    R"html(<dt>Zone of theoretical visibility</dt><dd>The posts of the elevation model from which the straight line
to a corner or the middle of a roof of the project is free. The project itself hides nothing.</dd>
)html";

constexpr const char* kLimits = R"html(</dl>
<h3>What is not modelled</h3>
<p>Trees, walls and buildings that are in none of the files, unless they are part of the elevation
model; relief finer than its posts; windows, materials and lighting of the project beyond the colours of
its file; weather beyond the air named above; changes of refraction by the hour. A number is no
judgement: how much a change matters is for people to say.</p>
)html";

}  // namespace

std::string method_section(const ReportParts& parts) {
  std::string section = "<section id=\"method\">\n<h2>Method</h2>\n<h3>Data</h3>\n";
  for (const Dem& dem : parts.dems) section += dem_facts(dem);
  return section + "<h3>Study</h3>\n" + study_facts(parts) + kDefinitions +
         (parts.zone != nullptr ? kZoneDefinition : "") + kLimits + "</section>\n";
}

}  // namespace terrview
