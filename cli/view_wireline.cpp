#include "cli/view_wireline.h"

#include <cmath>

#include "cli/add_option.h"
#include "cli/svg.h"
#include "terrain/error.h"

namespace terrview {
namespace {

struct Pen {
  const char* name;
  double near_px;
  double far_px;
};

Pen pen_of(LineKind kind) {
  switch (kind) {
    case LineKind::grid:
      return {"grid", 0.7, 0.3};
    case LineKind::silhouette:
      return {"silhouette", 1.6, 0.7};
    case LineKind::object:
      return {"object", 1.4, 0.6};
  }
  return {};
}

// Steps of a hundredth of a pixel from point to point, so that roundings do not add up.
std::string path_data(const ViewLine& line) {
  std::string data;
  glm::dvec2 pen{0, 0};
  for (std::size_t i = 0; i < line.points_px.size(); ++i) {
    const glm::dvec2 at(std::round(line.points_px[i].x * 100),
                        std::round(line.points_px[i].y * 100));
    const glm::dvec2 step = at - pen;
    const std::string y = svg_number(step.y / 100, 2);
    data += (i == 0       ? "M"
             : i == 1     ? "l"
             : step.x < 0 ? ""
                          : " ") +
            svg_number(step.x / 100, 2) + (y.front() == '-' ? "" : " ") + y;
    pen = at;
  }
  return data;
}

std::string group(const Wireline& wireline, LineKind kind, int depth) {
  std::string paths;
  for (const ViewLine& line : wireline.lines)
    if (line.kind == kind && line.depth == depth) paths += path_data(line) + "\n";
  if (paths.empty()) return "";
  const Pen pen = pen_of(kind);
  const double share = static_cast<double>(depth) / (Wireline::kDepths - 1);
  const int grey = static_cast<int>(std::lround(20 + share * 130));
  const auto limit = static_cast<std::size_t>(depth);
  return std::string("<path class=\"") + pen.name + "\" data-from-km=\"" +
         svg_number(wireline.limits_m[limit] / 1000, 3) + "\" data-to-km=\"" +
         svg_number(wireline.limits_m[limit + 1] / 1000, 3) + "\" stroke=\"rgb(" +
         std::to_string(grey) + "," + std::to_string(grey) + "," + std::to_string(grey) +
         ")\" stroke-width=\"" + svg_number(pen.near_px + share * (pen.far_px - pen.near_px), 2) +
         "\" d=\"" + paths + "\"/>\n";
}

}  // namespace

void add_wireline_options(CommandLine& app, WirelineOptions& options) {
  app.add_option("--wireline", options.file,
                 "The view as lines, as SVG: the grid and the outlines that are seen")
      ->type_name("FILE");
  app.add_option("--wireline-step", options.step_posts,
                 "Posts between its grid lines (default: a power of two, by distance)")
      ->between(1, 1000000)
      ->type_name("N");
}

void check_wireline(const WirelineOptions& options) {
  if (options.file.empty() && options.step_posts)
    throw InputError("--wireline-step: belongs to a wireline: give --wireline FILE.svg too");
}

std::string wireline_svg(const Wireline& wireline, glm::ivec2 size_px,
                         const std::string& metadata) {
  std::string elements = "<g fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
  for (int depth = Wireline::kDepths - 1; depth >= 0; --depth)
    for (const LineKind kind : {LineKind::grid, LineKind::silhouette, LineKind::object})
      elements += group(wireline, kind, depth);
  return svg_file(size_px, metadata, elements + "</g>\n");
}

}  // namespace terrview
