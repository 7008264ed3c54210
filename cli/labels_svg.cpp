#include <cstdio>

#include "cli/svg.h"
#include "cli/view_labels.h"

namespace terrview {
namespace {

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + xml_text(value) + "\"";
}

std::string group(const SummitLabel& summit, const Font& font) {
  const LabelBox& box = summit.ink.box;
  const std::string column = svg_number(summit.ink.foot_px.x + 0.5, 1);
  return "<g class=\"summit\"" + attribute("data-name", summit.ink.text) +
         attribute("data-azimuth", svg_number(summit.azimuth_deg, 5)) +
         attribute("data-distance-km", svg_number(summit.distance_m / 1000, 4)) +
         attribute("data-elevation-m", svg_number(summit.elevation_m, 1)) +
         attribute("data-x", svg_number(summit.anchor_px.x, 3)) +
         attribute("data-y", svg_number(summit.anchor_px.y, 3)) + "><path" +
         attribute("d", "M" + column + " " + std::to_string(box.high_px.y) + "V" +
                            svg_number(summit.anchor_px.y, 3)) +
         "/><text" + attribute("x", std::to_string(box.low_px.x)) +
         attribute("y", std::to_string(box.high_px.y - font.descent_px())) +
         attribute("textLength", std::to_string(box.high_px.x - box.low_px.x)) + ">" +
         xml_text(summit.ink.text) + "</text></g>\n";
}

}  // namespace

std::string labels_svg(const ViewLabels& labels, const Camera& camera,
                       const std::string& metadata) {
  std::string elements =
      "<style>.summit path{stroke:#191919;stroke-width:1}"
      ".summit text{fill:#191919;stroke:#fff;stroke-opacity:.6;stroke-width:4px;"
      "stroke-linejoin:round;paint-order:stroke}</style>\n"
      "<g font-family=\"DejaVu Sans, sans-serif\" font-size=\"" +
      std::to_string(labels.font_px) + "\">\n";
  for (const SummitLabel& summit : labels.summits) elements += group(summit, *labels.font);
  return svg_file(camera.options().size_px, metadata, elements + "</g>\n");
}

}  // namespace terrview
