#include "cli/view_labels.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "cli/add_option.h"
#include "ingest/feature_places.h"
#include "ingest/peaks.h"
#include "render/parallel.h"
#include "render/skyline.h"
#include "render/summit_sight.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

enum class Fate { seen, without_ground, under_the_eye, hidden, in_the_air, outside };

struct Summit {
  Fate fate = Fate::hidden;
  SummitLabel label;
  double prominence_m = 0;
};

class SummitFinder {
 public:
  SummitFinder(const ViewFrame& frame, const Camera& camera, const Scene& scene)
      : frame_(frame), camera_(camera), scene_(scene) {}

  [[nodiscard]] Summit find(const Peak& peak, glm::dvec2 ground_m) const {
    Summit summit;
    summit.fate = locate(peak, ground_m, summit);
    return summit;
  }

 private:
  [[nodiscard]] Fate locate(const Peak& peak, glm::dvec2 ground_m, Summit& summit) const {
    const Terrain& terrain = *scene_.terrain;
    // Places that are nowhere are NaN.
    if (!(glm::length(ground_m) <= terrain.reach_m())) return Fate::without_ground;
    const auto ground = terrain.ground_at(ground_m);
    if (!ground) return Fate::without_ground;
    const double reach_m = summit_reach_m(terrain, *ground, ground_m);
    if (glm::length(ground_m) <= reach_m) return Fate::under_the_eye;
    const auto top_m = seen_summit(scene_, camera_, ground_m, reach_m);
    if (!top_m) return Fate::hidden;
    SummitLabel& label = summit.label;
    label.distance_m = glm::length(frame_.to_true_enu(*top_m));
    if (scene_.air.extinction_per_m * label.distance_m > kExtinctionTimesVisibility)
      return Fate::in_the_air;
    const auto anchor_px = camera_.project(*top_m);
    const glm::dvec2 size(camera_.options().size_px);
    if (!anchor_px ||
        !(anchor_px->x >= 0 && anchor_px->y >= 0 && anchor_px->x < size.x && anchor_px->y < size.y))
      return Fate::outside;
    label.anchor_px = *anchor_px;
    label.ink.text = peak.name;
    const double azimuth_deg = std::atan2(ground_m.x, ground_m.y) * kDegrees;
    label.azimuth_deg = azimuth_deg < 0 ? azimuth_deg + 360 : azimuth_deg;
    label.elevation_m = peak.elevation_m.value_or(ground->scene_height_m / terrain.frame().z_scale);
    summit.prominence_m = peak.prominence_m.value_or(
        height_above_surroundings_m(terrain, ground_m) / terrain.frame().z_scale);
    return Fate::seen;
  }

  const ViewFrame& frame_;
  const Camera& camera_;
  const Scene& scene_;
};

std::vector<Summit> find_summits(const PeakFile& file, const SummitFinder& finder,
                                 const ViewFrame& frame, int threads) {
  std::vector<glm::dvec2> places;
  for (const Peak& peak : file.peaks) places.push_back(peak.place);
  to_ground(file.file, frame, places);
  std::vector<Summit> summits(places.size());
  parallel_for(static_cast<int>(places.size()), threads, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    summits[i] = finder.find(file.peaks[i], places[i]);
  });
  return summits;
}

// Those that are seen, most prominent first.
std::vector<SummitLabel> seen_in_order(std::vector<Summit> summits) {
  std::stable_sort(summits.begin(), summits.end(), [](const Summit& a, const Summit& b) {
    return a.prominence_m > b.prominence_m;
  });
  std::vector<SummitLabel> labels;
  for (Summit& summit : summits)
    if (summit.fate == Fate::seen) labels.push_back(std::move(summit.label));
  return labels;
}

void find_room(const Camera& camera, const Scene& scene, int threads, ViewLabels& labels) {
  const Font& font = *labels.font;
  std::vector<LabelRequest> requests;
  for (const SummitLabel& summit : labels.summits)
    requests.push_back({summit.anchor_px, font.width_px(summit.ink.text)});
  const auto boxes = place_labels(requests, {.size_px = camera.options().size_px,
                                             .line_px = font.ascent_px() + font.descent_px(),
                                             .skyline_px = skyline_rows(scene, camera, threads)});
  std::vector<SummitLabel> placed;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i]) continue;
    SummitLabel& summit = labels.summits[i];
    summit.ink.box = *boxes[i];
    summit.ink.foot_px = {leader_column(requests[i]), static_cast<int>(summit.anchor_px.y)};
    placed.push_back(std::move(summit));
  }
  labels.summits = std::move(placed);
}

std::string counted(std::ptrdiff_t count, const std::string& what) {
  return count > 0 ? ", " + std::to_string(count) + " " + what : "";
}

std::string summary(const PeakFile& file, const std::vector<Summit>& summits,
                    std::size_t labelled) {
  const auto count = [&](Fate fate) {
    return std::count_if(summits.begin(), summits.end(),
                         [&](const Summit& summit) { return summit.fate == fate; });
  };
  const auto seen = count(Fate::seen);
  return file.file.name + ": " + std::to_string(file.file.features) + " features, " +
         std::to_string(seen) + " summits seen" +
         counted(seen - static_cast<std::ptrdiff_t>(labelled), "of them without room for a label") +
         counted(count(Fate::hidden), "hidden") +
         counted(count(Fate::under_the_eye), "under the eye") +
         counted(count(Fate::in_the_air), "further than the visibility") +
         counted(count(Fate::outside), "outside the picture") +
         counted(count(Fate::without_ground), "beside the ground") +
         counted(file.without_name, "without a name") +
         counted(file.without_point, "that are no points");
}

int font_size(const LabelOptions& options, const Camera& camera) {
  constexpr int kLeast_px = 13;
  constexpr int kLines = 45;
  return options.size_px.value_or(std::max(kLeast_px, camera.options().size_px.y / kLines));
}

}  // namespace

void add_label_options(CommandLine& app, LabelOptions& options) {
  app.add_option("--peaks", options.peaks,
                 "Summits whose names to write where they are seen: GeoJSON, CSV or whatever OGR "
                 "opens")
      ->type_name("FILE");
  app.add_option("--labels-svg", options.svg, "The names as SVG, to lay over the picture")
      ->type_name("FILE");
  app.add_option("--label-size", options.size_px,
                 "Pixels, of the letters (default: a 45th of the picture's height, 13 at least)")
      ->between(6, 500)
      ->type_name("PX");
  app.add_option("--font", options.font, "TrueType or OpenType file (default: DejaVu Sans)")
      ->type_name("FILE");
}

void check_labels(const LabelOptions& options) {
  if (options.peaks.empty() && (!options.svg.empty() || options.size_px || !options.font.empty()))
    throw InputError("--labels-svg, --label-size, --font: belong to summits: give --peaks too");
}

ViewLabels make_labels(const ViewOptions& options, const ViewFrame& frame, const Camera& camera,
                       const Scene& scene) {
  ViewLabels labels;
  const LabelOptions& wanted = options.labels;
  if (wanted.peaks.empty()) return labels;
  labels.font_px = font_size(wanted, camera);
  labels.font = std::make_shared<const Font>(wanted.font.empty() ? usual_font() : wanted.font,
                                             labels.font_px);
  const PeakFile file = read_peaks(wanted.peaks);
  const std::vector<Summit> summits =
      find_summits(file, SummitFinder(frame, camera, scene), frame, options.threads);
  labels.summits = seen_in_order(summits);
  find_room(camera, scene, options.threads, labels);
  labels.messages.push_back(summary(file, summits, labels.summits.size()));
  for (const std::string& warning : file.file.warnings)
    labels.messages.push_back("warning: " + warning);
  return labels;
}

void draw_labels(const ViewLabels& labels, Image& image) {
  if (!labels.font) return;
  std::vector<LabelInk> ink;
  for (const SummitLabel& summit : labels.summits) ink.push_back(summit.ink);
  draw_labels(ink, *labels.font, image);
}

}  // namespace terrview
