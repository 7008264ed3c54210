#include "cli/impact/impact_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/common.hpp>

#include "cli/impact/html_text.h"
#include "cli/interrupt.h"
#include "cli/overview_ticks.h"
#include "cli/plan.h"
#include "cli/progress.h"
#include "cli/svg.h"
#include "cli/view_command.h"
#include "ingest/crs_transform.h"
#include "ingest/dem_info.h"
#include "render/color_ramp.h"
#include "render/image_file.h"
#include "render/plan.h"

namespace terrview {
namespace {

constexpr double kLongestSide_px = 1400;
constexpr double kMargin = 0.08;  // around the places, of the longer side

// From places to the map.
class MapLattice {
 public:
  MapLattice(const Dem& dem, const ImpactStudy& study) : dem_(dem) {
    spacing_m_ = describe_dem(dem).spacing_m;
    if (study.project.geographic)
      crs_.emplace(dem.name, dem.crs_wkt,
                   std::vector<glm::dvec2>{dem.placement.at(
                       glm::dvec2(dem.grid->columns - 1, dem.grid->rows - 1) / 2.0)});
    glm::dvec2 low_uv(std::numeric_limits<double>::infinity());
    glm::dvec2 high_uv(-std::numeric_limits<double>::infinity());
    const auto hold = [&](PlanPlace place) {
      low_uv = glm::min(low_uv, uv_of(place));
      high_uv = glm::max(high_uv, uv_of(place));
    };
    for (const ViewpointStudy& viewpoint : study.viewpoints)
      if (viewpoint.error.empty()) hold(viewpoint.viewpoint.place);
    for (const ProjectBuilding& building : study.project.buildings)
      for (const PlanPolygon& part : building.parts)
        for (const PlanPlace place : part.front()) hold(place);
    lay(low_uv, high_uv);
  }

  [[nodiscard]] const PlanLattice& lattice() const { return lattice_; }
  [[nodiscard]] double pixel_m() const { return lattice_.step_uv.x * spacing_m_.x; }

  [[nodiscard]] glm::dvec2 pixel_of(PlanPlace place) const {
    return (uv_of(place) - lattice_.corner_uv) / lattice_.step_uv;
  }

 private:
  [[nodiscard]] glm::dvec2 uv_of(PlanPlace place) const {
    if (crs_) crs_->from_geographic({&place, 1});
    return dem_.placement.posts(place);
  }

  void lay(glm::dvec2 low_uv, glm::dvec2 high_uv) {
    const glm::dvec2 size_m = (high_uv - low_uv) * spacing_m_;
    constexpr double kLeastMargin_posts = 8;
    const glm::dvec2 margin_uv = glm::max(kMargin * std::max(size_m.x, size_m.y) / spacing_m_,
                                          glm::dvec2(kLeastMargin_posts));
    const glm::dvec2 posts(dem_.grid->columns, dem_.grid->rows);
    const glm::dvec2 begin_uv = glm::clamp(low_uv - margin_uv, glm::dvec2(-0.5), posts - 1.5);
    const glm::dvec2 end_uv = glm::clamp(high_uv + margin_uv, begin_uv + 1.0, posts - 0.5);
    const glm::dvec2 side_m = (end_uv - begin_uv) * spacing_m_;
    const double per_px_m = std::max(side_m.x, side_m.y) / kLongestSide_px;
    lattice_.corner_uv = begin_uv;
    lattice_.step_uv = per_px_m / spacing_m_;
    lattice_.size_px =
        glm::max(glm::ivec2(glm::round((end_uv - begin_uv) / lattice_.step_uv)), glm::ivec2(1));
  }

  const Dem& dem_;
  std::optional<CrsTransform> crs_;
  glm::dvec2 spacing_m_{1, 1};
  PlanLattice lattice_;
};

// Grey relief, whatever the pictures' colours are.
Image relief(const StudyGround& ground, const PlanLattice& lattice) {
  ViewOptions plan;
  plan.plan = true;
  plan.dems = ground.options.view.dems;
  plan.earth = EarthModel::flat;
  plan.light.relief = true;
  plan.colors = "grey";
  plan.threads = ground.options.view.threads;
  plan.quiet = true;
  const View view = make_view(plan, ground.dems, ground.inputs);
  PlanFrame frame = draw_plan(plan, view, lattice, "map");
  Image image = std::move(frame.image);
  for (int row = 0; row < image.height_px(); ++row)
    for (int column = 0; column < image.width_px(); ++column)
      if (frame.covered.at(column, row) == 0) image.at(column, row) = glm::vec3(1);
  return image;
}

// Lighter, so that what lies over it can be read; and tinted where the project is seen from.
void wash(const PlanLattice& lattice, const Zone* zone, Image& image) {
  const glm::vec3 paper(1);
  const glm::vec3 seen = from_srgb8(214, 96, 32);
  constexpr float kPaper = 0.4F;
  constexpr float kSeen = 0.45F;
  for (int row = 0; row < image.height_px(); ++row) {
    for (int column = 0; column < image.width_px(); ++column) {
      glm::vec3& color = image.at(column, row);
      color = glm::mix(color, paper, kPaper);
      if (zone == nullptr) continue;
      const glm::dvec2 uv = lattice.corner_uv + lattice.step_uv * (glm::dvec2(column, row) + 0.5);
      const glm::ivec2 post = glm::clamp(glm::ivec2(glm::round(uv)), glm::ivec2(0),
                                         glm::ivec2(zone->columns - 1, zone->rows - 1));
      if (zone->counts[zone->index(post.x, post.y)] > 0) color = glm::mix(color, seen, kSeen);
    }
  }
}

std::string point_text(glm::dvec2 at) { return svg_number(at.x, 1) + "," + svg_number(at.y, 1); }

std::string project_shapes(const MapLattice& map, const Project& project) {
  std::string shapes;
  for (const ProjectBuilding& building : project.buildings) {
    for (const PlanPolygon& part : building.parts) {
      std::string path;
      for (const auto& ring : part) {
        char command = 'M';
        for (const PlanPlace place : ring) {
          path += command + point_text(map.pixel_of(place));
          command = 'L';
        }
        path += "Z";
      }
      shapes += "<path class=\"project\" fill-rule=\"evenodd\" d=\"" + path + "\"/>\n";
    }
  }
  const glm::dvec2 at = map.pixel_of(project.middle);
  return shapes + "<path class=\"project-mark\" d=\"M" + point_text(at) + "m0,-14l10,18h-20z\"/>\n";
}

std::string viewpoint_marks(const MapLattice& map, const ImpactStudy& study) {
  std::string lines;
  std::string marks;
  const glm::dvec2 middle = map.pixel_of(study.project.middle);
  for (const ViewpointStudy& viewpoint : study.viewpoints) {
    if (!viewpoint.error.empty()) continue;
    const glm::dvec2 at = map.pixel_of(viewpoint.viewpoint.place);
    const bool seen = viewpoint.project.is_seen();
    if (seen)
      lines += "<line class=\"sight\" x1=\"" + svg_number(at.x, 1) + "\" y1=\"" +
               svg_number(at.y, 1) + "\" x2=\"" + svg_number(middle.x, 1) + "\" y2=\"" +
               svg_number(middle.y, 1) + "\"/>\n";
    marks += "<g class=\"" + std::string(seen ? "seeing" : "blind") + "\" transform=\"translate(" +
             point_text(at) + ")\"><title>" + html_text(viewpoint.name) +
             "</title><circle r=\"15\"/><text dy=\"0.36em\">" +
             std::to_string(viewpoint.viewpoint.number) + "</text></g>\n";
  }
  return lines + marks;
}

std::string scale_bar(const MapLattice& map, glm::dvec2 size_px) {
  constexpr double kShare = 0.25;
  const double length_m = round_length(kShare * size_px.x * map.pixel_m());
  const double length_px = length_m / map.pixel_m();
  const std::string label =
      length_m >= 1000 ? svg_number(length_m / 1000, 0) + " km" : svg_number(length_m, 0) + " m";
  return "<g class=\"scale\" transform=\"translate(24," + svg_number(size_px.y - 26, 1) +
         ")\"><rect x=\"-12\" y=\"-30\" width=\"" + svg_number(length_px + 24, 1) +
         "\" height=\"44\"/><path d=\"M0,-6v6h" + svg_number(length_px, 1) + "v-6\"/><text x=\"" +
         svg_number(length_px / 2, 1) + "\" y=\"-10\">" + label + "</text></g>\n";
}

// Towards the north from the middle of the map.
std::string north_arrow(const MapLattice& map, const Project& project, glm::dvec2 size_px) {
  const glm::dvec2 at = map.pixel_of(project.middle);
  const double step = project.geographic ? 1e-3 : 1;
  const glm::dvec2 north = map.pixel_of(project.middle + glm::dvec2(0, step)) - at;
  const double turn_deg = std::atan2(north.x, -north.y) * 180 / std::numbers::pi;
  return "<g class=\"north\" transform=\"translate(" + svg_number(size_px.x - 34, 1) +
         ",40) rotate(" + svg_number(turn_deg, 2) +
         ")\"><circle r=\"24\"/><path d=\"M0,-18l7,22l-7,-5l-7,5z\"/><text y=\"17\">N</text></g>\n";
}

}  // namespace

Zone zone_of(const StudyGround& ground) {
  const ImpactOptions& options = ground.options;
  ProgressBar bar("zone", show_bar(options.view));
  ZoneOptions how{.observer_m = options.eye_height_m,
                  .frame = frame_options(options.view),
                  .progress = [&](double share) {
                    check_interrupt();
                    bar.report(share);
                  }};
  if (!options.existing.empty())
    how.obstacles = [&](const ViewFrame& frame) -> std::shared_ptr<const ObjectSet> {
      PlacedObjects placed;
      for (const std::string& path : options.existing)
        static_cast<void>(
            place_buildings(*ground.inputs.footprints(path, options.view.objects.reading), frame,
                            options.view.objects.placing, placed));
      const auto scene = placed.scene_objects();
      return scene ? scene->set : nullptr;
    };
  return visible_zone(ground.dems, ground.project.roof_points, how);
}

std::string map_svg(const ImpactStudy& study, const StudyGround& ground, const Zone* zone) {
  const MapLattice map(ground.dems.front(), study);
  Image image = relief(ground, map.lattice());
  wash(map.lattice(), zone, image);
  const glm::dvec2 size_px(map.lattice().size_px);
  const std::string width = svg_number(size_px.x, 0);
  const std::string height = svg_number(size_px.y, 0);
  constexpr int kQuality = 85;
  return "<svg class=\"map\" role=\"img\" aria-label=\"Map of the viewpoints and the project\" "
         "viewBox=\"0 0 " +
         width + " " + height + "\">\n<image width=\"" + width + "\" height=\"" + height +
         "\" href=\"" + data_uri("image/jpeg", encode_jpeg(image, kQuality)) + "\"/>\n" +
         project_shapes(map, study.project) + viewpoint_marks(map, study) +
         scale_bar(map, size_px) + north_arrow(map, study.project, size_px) + "</svg>\n";
}

}  // namespace terrview
