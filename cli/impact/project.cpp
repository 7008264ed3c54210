#include "cli/impact/project.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

#include "cli/impact/html_text.h"
#include "cli/plan.h"
#include "cli/view_setup.h"
#include "ingest/feature_places.h"
#include "render/objects/prism.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// High above the first corner of a project.
EyePlace above(const FootprintFile& file, const ViewOptions& options,
               const std::vector<Dem>& dems) {
  if (file.footprints.empty())
    throw InputError("'" + file.file.name +
                     "': none of its features is a polygon: give footprints");
  const Polygon::Ring& ring = file.footprints.front().polygons.front().front();
  std::vector<glm::dvec2> at{ring.front()};
  EyePlace place = eye_of_plan(options, dems);
  place.projected = at.front();
  if (file.file.crs_wkt.empty() || dems.front().crs_wkt.empty()) return place;
  to_geographic(file.file, at);
  place.geographic = GeoPoint{at.front().y, at.front().x};
  place.projected.reset();
  return place;
}

// The middle of the widest stretch of the footprint on some lines from west to east.
glm::dvec2 middle_of_widest(const Polygon& footprint) {
  constexpr int kLines = 32;
  const glm::dvec2 size_m = footprint.highest() - footprint.lowest();
  glm::dvec2 middle_m = footprint.vertices().front();
  double widest_m = 0;
  Polygon::Crossings crossings;
  for (int i = 0; i < kLines; ++i) {
    const glm::dvec2 west_m = footprint.lowest() + glm::dvec2(0, (i + 0.5) / kLines * size_m.y);
    footprint.cross(west_m, {1, 0}, crossings);
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const double width_m = crossings[k + 1].t - crossings[k].t;
      if (!(width_m > widest_m)) continue;
      widest_m = width_m;
      middle_m = west_m + glm::dvec2(crossings[k].t + width_m / 2, 0);
    }
  }
  return middle_m;
}

// That of the bounding box, unless a bend or a courtyard leaves no roof there.
glm::dvec2 middle_of(const Polygon& footprint) {
  const glm::dvec2 middle_m = (footprint.lowest() + footprint.highest()) / 2.0;
  return footprint.contains(middle_m) ? middle_m : middle_of_widest(footprint);
}

class ProjectPlacer {
 public:
  ProjectPlacer(const ViewFrame& frame, Project& project) : frame_(frame), project_(project) {}

  void add(const PlacedObjects& placed) {
    for (const PlacedFeature& feature : placed.features) {
      ProjectBuilding building{
          feature.id, feature.number, utf8_text(feature.name), feature.height_m, {}};
      for (std::size_t i = 0; i < placed.objects.size(); ++i)
        if (placed.looks[i].id == feature.id)
          add_part(dynamic_cast<const Prism&>(*placed.objects[i]), building);
      project_.middle_m = std::max(project_.middle_m, feature.height_m / 2);
      project_.buildings.push_back(std::move(building));
    }
  }

  // To a millimetre, so that commands that aim there are short.
  void finish() {
    const double per_unit = project_.geographic ? 1e8 : 1e3;
    project_.middle =
        glm::round(plan_place(frame_, (low_m_ + high_m_) / 2.0) * per_unit) / per_unit;
  }

 private:
  void add_roof_point(const Prism& part, glm::dvec2 ground_m) {
    const VerticalFrame& vertical = frame_.terrain()->frame();
    const PlanPlace at = plan_place(frame_, ground_m);
    EyePlace point;
    if (frame_.is_geographic())
      point.geographic = GeoPoint{at.y, at.x};
    else
      point.projected = at;
    point.height_m =
        vertical.at(ground_m).scene_height_m(part.top_z_m(ground_m)) / vertical.z_scale;
    project_.roof_points.push_back(point);
  }

  void add_part(const Prism& part, ProjectBuilding& building) {
    const Polygon& footprint = part.footprint();
    PlanPolygon& rings = building.parts.emplace_back(1);
    for (std::size_t i = 0; i < footprint.vertices().size(); ++i) {
      const glm::dvec2 corner_m = footprint.vertices()[i];
      rings.back().push_back(plan_place(frame_, corner_m));
      if (footprint.is_edge(i))
        add_roof_point(part, corner_m);
      else if (i + 1 < footprint.vertices().size())
        rings.emplace_back();
    }
    add_roof_point(part, middle_of(footprint));
    low_m_ = glm::min(low_m_, footprint.lowest());
    high_m_ = glm::max(high_m_, footprint.highest());
  }

  const ViewFrame& frame_;
  Project& project_;
  glm::dvec2 low_m_{std::numeric_limits<double>::infinity()};
  glm::dvec2 high_m_{-std::numeric_limits<double>::infinity()};
};

}  // namespace

PlanPlace plan_place(const ViewFrame& frame, glm::dvec2 ground_m) {
  if (!frame.is_geographic()) return frame.projected_from_ground(ground_m);
  const GeoPoint point = frame.from_ground(ground_m);
  return {point.longitude_deg, point.latitude_deg};
}

Project read_project(const ViewOptions& options, std::size_t files, const std::vector<Dem>& dems,
                     SharedInputs& inputs) {
  const std::vector<std::string>& paths = options.objects.buildings;
  const std::size_t existing = paths.size() - files;
  Project project;
  std::vector<std::shared_ptr<const FootprintFile>> read;
  for (const std::string& path : paths)
    read.push_back(inputs.footprints(path, options.objects.reading));
  for (std::size_t i = 0; i < existing; ++i) project.before += read[i]->file.features;
  const ViewFrame frame(dems, above(*read[existing], options, dems), frame_options(options));
  project.geographic = frame.is_geographic();
  PlacedObjects placed;
  placed.next_id = project.before + 1;
  for (std::size_t i = existing; i < read.size(); ++i)
    static_cast<void>(place_buildings(*read[i], frame, options.objects.placing, placed));
  project.last = placed.next_id - 1;
  if (placed.features.empty())
    throw InputError("'" + paths.back() +
                     "': none of its features lies on the ground of the DEM with an area and a "
                     "height: check its coordinate system");
  ProjectPlacer placer(frame, project);
  placer.add(placed);
  placer.finish();
  return project;
}

}  // namespace terrview
