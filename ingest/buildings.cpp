#include "ingest/buildings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ingest/feature_places.h"
#include "ingest/ground_under.h"
#include "render/color_ramp.h"
#include "render/objects/crown.h"
#include "render/objects/hull.h"
#include "render/objects/make_object_set.h"
#include "render/objects/prism.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// Footprints smaller than a hand have no walls worth the name.
constexpr double kLeastArea_m2 = 1e-2;
// Walls reach this far below the lowest post.
constexpr double kFoundation_m = 1;

glm::vec3 plaster() { return from_srgb8(226, 218, 200); }
glm::vec3 tiles() { return from_srgb8(166, 88, 66); }
glm::vec3 gravel() { return from_srgb8(150, 146, 140); }
glm::vec3 leaves() { return from_srgb8(62, 92, 48); }
glm::vec3 bark() { return from_srgb8(92, 74, 58); }

[[noreturn]] void refuse_place(const VectorFile& file, int number) {
  throw InputError("'" + file.name + "', feature " + std::to_string(number) +
                   ": a corner is nowhere on the Earth: mend its coordinates or the file's "
                   "coordinate system");
}

glm::vec3 color_of_height(double height_m) {
  const ColorRamp ramp{.stops = {{0, from_srgb8(68, 1, 84)},
                                 {5, from_srgb8(59, 82, 139)},
                                 {10, from_srgb8(33, 145, 140)},
                                 {20, from_srgb8(94, 201, 98)},
                                 {40, from_srgb8(253, 231, 37)}}};
  return ramp.at(height_m);
}

ObjectLook look_of(const Footprint& footprint, double height_m, const BuildingOptions& options) {
  ObjectLook look;
  if (options.color || options.color_by_height) {
    look.color = options.color.value_or(color_of_height(height_m));
    look.roof_color = look.color;
    return look;
  }
  look.color = footprint.color.value_or(plaster());
  look.roof_color =
      footprint.roof_color.value_or(footprint.roof == RoofShape::flat ? gravel() : tiles());
  return look;
}

// As steep as roofs are, if the file does not say, and at most half of the building.
double roof_rise_m(const Footprint& footprint, const Polygon& polygon, double height_m) {
  if (footprint.roof == RoofShape::flat) return 0;
  if (footprint.roof_height_m)
    return std::clamp(*footprint.roof_height_m, 0.0, height_m - footprint.min_height_m);
  constexpr double kPitch = 0.7;
  constexpr double kSkillionPitch = 0.2;
  const double half_m = enclosing_rectangle(convex_hull(polygon.vertices())).half_width;
  const double pitch = footprint.roof == RoofShape::skillion ? 2 * kSkillionPitch
                       : footprint.roof == RoofShape::dome   ? 1
                                                             : kPitch;
  return std::min((height_m - footprint.min_height_m) / 2, pitch * half_m);
}

double base_of(const GroundUnder& ground, BuildingBase base) {
  switch (base) {
    case BuildingBase::lowest:
      return ground.lowest_m;
    case BuildingBase::mean:
      return ground.mean_m;
    case BuildingBase::highest:
      return ground.highest_m;
  }
  return ground.lowest_m;
}

std::shared_ptr<const Prism> prism_of(const Footprint& footprint, Polygon polygon,
                                      const GroundUnder& ground, double height_m,
                                      const Terrain& terrain, BuildingBase base) {
  const VerticalFrame& frame = terrain.frame();
  const glm::dvec2 middle_m = (polygon.lowest() + polygon.highest()) / 2.0;
  const double base_m = base_of(ground, base);
  // z per metre of height.
  const double stretch = frame.at(middle_m).slope(base_m);
  PrismShape shape{.level = level_plane(frame, middle_m, base_m)};
  shape.base_m = footprint.min_height_m > 0 ? stretch * footprint.min_height_m
                                            : stretch * (ground.foot_m - base_m) - kFoundation_m;
  const double rise_m = roof_rise_m(footprint, polygon, height_m);
  shape.roof = {.shape = footprint.roof,
                .eaves_m = stretch * (height_m - rise_m),
                .top_m = stretch * height_m,
                .ridge_across = footprint.ridge_across};
  if (footprint.roof_azimuth_deg) {
    const double azimuth_rad = *footprint.roof_azimuth_deg * std::numbers::pi / 180;
    shape.roof.downhill = glm::dvec2(std::sin(azimuth_rad), std::cos(azimuth_rad));
  }
  return std::make_shared<Prism>(std::move(polygon), shape);
}

// The corners of every footprint, in the view frame.
std::vector<std::vector<Polygon>> placed_polygons(const FootprintFile& file,
                                                  const ViewFrame& frame) {
  std::vector<glm::dvec2> corners;
  for (const Footprint& footprint : file.footprints)
    for (const auto& rings : footprint.polygons)
      for (const Polygon::Ring& ring : rings)
        corners.insert(corners.end(), ring.begin(), ring.end());
  to_ground(file.file, frame, corners);
  std::vector<std::vector<Polygon>> placed;
  auto next = corners.begin();
  for (const Footprint& footprint : file.footprints) {
    placed.emplace_back();
    for (std::vector<Polygon::Ring> rings : footprint.polygons) {
      for (Polygon::Ring& ring : rings)
        for (glm::dvec2& corner : ring) {
          corner = *next++;
          if (!std::isfinite(corner.x + corner.y)) refuse_place(file.file, footprint.number);
        }
      placed.back().emplace_back(rings);
    }
  }
  return placed;
}

class BuildingPlacer {
 public:
  BuildingPlacer(const Terrain& terrain, const BuildingOptions& options, PlacedObjects& objects)
      : terrain_(terrain), options_(options), objects_(objects) {}

  void place(const Footprint& footprint, std::vector<Polygon>& polygons, std::int32_t id,
             PlacedCounts& counts) {
    const double height_m =
        footprint.height_m.value_or(footprint.min_height_m + options_.default_height_m);
    if (height_m <= footprint.min_height_m) {
      ++counts.upside_down;
      return;
    }
    ObjectLook look = look_of(footprint, height_m, options_);
    look.id = id;
    const std::size_t before = objects_.objects.size();
    bool has_area = false;
    for (Polygon& polygon : polygons) {
      if (!(polygon.area() >= kLeastArea_m2)) continue;
      has_area = true;
      if (!is_near(polygon)) continue;
      const auto ground = ground_under(terrain_, polygon);
      if (!ground) continue;
      objects_.objects.push_back(
          prism_of(footprint, std::move(polygon), *ground, height_m, terrain_, options_.base));
      objects_.looks.push_back(look);
    }
    if (objects_.objects.size() == before) {
      ++(has_area ? counts.without_ground : counts.without_area);
      return;
    }
    ++counts.placed;
    if (!footprint.height_m) ++counts.default_height;
    objects_.features.push_back({id, "building", footprint.number, footprint.name, height_m});
  }

 private:
  [[nodiscard]] bool is_near(const Polygon& polygon) const {
    const glm::dvec2 nearest = glm::clamp(glm::dvec2(0), polygon.lowest(), polygon.highest());
    return glm::length(nearest) <= terrain_.reach_m();
  }

  const Terrain& terrain_;
  const BuildingOptions& options_;
  PlacedObjects& objects_;
};

}  // namespace

std::shared_ptr<const SceneObjects> PlacedObjects::scene_objects() const {
  if (objects.empty()) return nullptr;
  auto scene = std::make_shared<SceneObjects>();
  scene->set = make_object_set(objects);
  scene->looks = looks;
  return scene;
}

PlacedCounts place_buildings(const FootprintFile& file, const ViewFrame& frame,
                             const BuildingOptions& options, PlacedObjects& objects) {
  PlacedCounts counts{.features = file.file.features, .without_area = file.without_polygon};
  std::vector<std::vector<Polygon>> polygons = placed_polygons(file, frame);
  BuildingPlacer placer(*frame.terrain(), options, objects);
  const std::int32_t first = objects.next_id - 1;
  for (std::size_t i = 0; i < polygons.size(); ++i)
    placer.place(file.footprints[i], polygons[i], first + file.footprints[i].number, counts);
  objects.next_id += file.file.features;
  return counts;
}

PlacedCounts place_trees(const TreeFile& file, const ViewFrame& frame, PlacedObjects& objects) {
  constexpr double kHeight_m = 10;
  constexpr double kCrown = 0.6;
  constexpr double kClear = 0.2;
  constexpr double kTrunk = 0.2;  // around
  PlacedCounts counts{.features = file.file.features, .without_area = file.without_point};
  std::vector<glm::dvec2> places;
  for (const Tree& tree : file.trees) places.push_back(tree.place);
  to_ground(file.file, frame, places);
  const Terrain& terrain = *frame.terrain();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Tree& tree = file.trees[i];
    if (!std::isfinite(places[i].x + places[i].y)) refuse_place(file.file, tree.number);
    const auto ground = terrain.ground_at(places[i]);
    if (!ground) {
      ++counts.without_ground;
      continue;
    }
    const double height_m = std::max(tree.height_m.value_or(kHeight_m), tree.min_height_m + 0.1);
    if (!tree.height_m) ++counts.default_height;
    const double width_m = tree.crown_m.value_or(kCrown * height_m);
    const double bottom_m = tree.min_height_m > 0 ? tree.min_height_m : kClear * height_m;
    objects.objects.push_back(std::make_shared<Crown>(CrownShape{
        .level = level_plane(terrain.frame(), places[i], ground->scene_height_m),
        .foot_m = -kFoundation_m,
        .bottom_m = bottom_m,
        .top_m = height_m,
        .radius_m = std::max(width_m, 0.01) / 2,
        .trunk_radius_m =
            std::max(0.0, tree.trunk_m.value_or(kTrunk * width_m)) / (2 * std::numbers::pi)}));
    const std::int32_t id = objects.next_id - 1 + tree.number;
    objects.looks.push_back({id, tree.color.value_or(leaves()), bark()});
    objects.features.push_back({id, "tree", tree.number, tree.name, height_m});
    ++counts.placed;
  }
  objects.next_id += file.file.features;
  return counts;
}

}  // namespace terrview
