// The names of the summits that a view shows.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/view_options.h"
#include "ingest/view_frame.h"
#include "render/draw_labels.h"
#include "render/scene.h"

namespace terrview {

void add_label_options(CommandLine& app, LabelOptions& options);

// Throws InputError for options that need others.
void check_labels(const LabelOptions& options);

// One that is seen and has found room.
struct SummitLabel {
  LabelInk ink;
  glm::dvec2 anchor_px{0, 0};
  double azimuth_deg = 0;  // of its place in the file
  double distance_m = 0;   // straight, from the eye
  double elevation_m = 0;  // by the file, or the ground's
};

struct ViewLabels {
  std::shared_ptr<const Font> font;  // null without --peaks
  int font_px = 0;
  std::vector<SummitLabel> summits;   // most prominent first
  std::vector<std::string> messages;  // what became of the file's features, a line each
};

// Throws InputError.
[[nodiscard]] ViewLabels make_labels(const ViewOptions& options, const ViewFrame& frame,
                                     const Camera& camera, const Scene& scene);

void draw_labels(const ViewLabels& labels, Image& image);

// --labels-svg: docs/cli.md.
[[nodiscard]] std::string labels_svg(const ViewLabels& labels, const Camera& camera,
                                     const std::string& metadata);

}  // namespace terrview
