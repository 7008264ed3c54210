#include "cli/scene/place_scene.h"

#include <cmath>
#include <map>
#include <memory>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "render/color_ramp.h"
#include "render/objects/level_plane.h"
#include "render/objects/scene_objects.h"
#include "render/objects/solids/solid_object.h"
#include "render/objects/solids/transformed.h"
#include "terrain/error.h"

namespace terrview {
namespace {

struct PlacedPoint {
  glm::dvec2 ground_m;
  double scene_height_m;
};

PlacedPoint placed_point(const Target& target, const ViewFrame& frame) {
  const glm::dvec2 ground_m = target.geographic ? frame.to_ground(*target.geographic)
                                                : frame.to_ground_from_projected(*target.projected);
  if (!std::isfinite(ground_m.x + ground_m.y))
    throw InputError("its place is nowhere on the Earth: check it");
  const Terrain& terrain = *frame.terrain();
  if (!target.height.above_ground)
    return {ground_m, target.height.height_m * terrain.frame().z_scale};
  const auto ground = terrain.ground_at(ground_m);
  if (!ground) throw InputError("there is no ground at its place: give a height without a +");
  return {ground_m, ground->scene_height_m + target.height.height_m};
}

glm::dvec3 view_point(const PlacedPoint& point, const VerticalFrame& frame) {
  return {point.ground_m, frame.at(point.ground_m).z_m(point.scene_height_m)};
}

// Of a place: true north, or the y axis of coordinates without a system.
glm::dvec2 north_at(glm::dvec2 ground_m, const ViewFrame& frame) {
  if (!frame.is_geographic()) return {0, 1};
  GeoPoint point = frame.from_ground(ground_m);
  const double step_deg = point.latitude_deg < 0 ? 1e-5 : -1e-5;
  point.latitude_deg += step_deg;
  return glm::normalize((frame.to_ground(point) - ground_m) * step_deg);
}

// From x east, y north (both turned clockwise by the heading), z up at a place to the view frame.
glm::dmat4 stand_at(const PlacedPoint& point, double heading_rad, const ViewFrame& frame) {
  const VerticalFrame& vertical = frame.terrain()->frame();
  const glm::dvec2 north = north_at(point.ground_m, frame);
  const glm::dvec2 east(north.y, -north.x);
  const glm::dvec2 y = std::cos(heading_rad) * north + std::sin(heading_rad) * east;
  const glm::dvec2 x = std::cos(heading_rad) * east - std::sin(heading_rad) * north;
  const glm::dvec2 slope = level_plane(vertical, point.ground_m, point.scene_height_m).slope;
  const double rise = vertical.at(point.ground_m).slope(point.scene_height_m);
  return {glm::dvec4(x, glm::dot(slope, x), 0), glm::dvec4(y, glm::dot(slope, y), 0),
          glm::dvec4(0, 0, rise, 0), glm::dvec4(view_point(point, vertical), 1)};
}

// One for all solids of those without a texture.
using MadeMaterials = std::map<const SceneMaterial*, std::shared_ptr<const Material>>;

std::vector<std::shared_ptr<const Material>> make_materials(const std::vector<MaterialPlan>& plans,
                                                            const glm::dmat4& to_solid,
                                                            MadeMaterials& plain) {
  MadeMaterials textured;
  std::vector<std::shared_ptr<const Material>> materials;
  for (const MaterialPlan& plan : plans) {
    if (!plan) {
      materials.emplace_back();
      continue;
    }
    auto& material = (plan->has_texture ? textured : plain)[plan.get()];
    if (!material) material = std::make_shared<const Material>(plan->make(to_solid));
    materials.push_back(material);
  }
  return materials;
}

// Calls `place` for each of `all`, whose complaints name the file and the element.
template <class Elements, class Place>
void place_each(const Elements& all, const std::string& path, const char* kind,
                const Place& place) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    try {
      place(all[i], static_cast<int>(i) + 1);
    } catch (const InputError& error) {
      throw InputError(path + ": /" + kind + "/" + std::to_string(i) + ": " + error.what());
    }
  }
}

}  // namespace

void place_solids(const SceneContents& contents, const ViewFrame& frame, PlacedObjects& objects) {
  MadeMaterials plain;
  place_each(contents.solids, contents.path, "solids", [&](const SceneSolid& solid, int number) {
    const glm::dmat4 to_view = stand_at(placed_point(solid.place, frame), solid.heading_rad, frame);
    auto object = std::make_shared<const SolidObject>(
        std::make_shared<const Transformed>(solid.solid, to_view));
    const Box bounds = object->bounds();
    ObjectLook look;
    look.id = objects.next_id++;
    look.materials = make_materials(solid.materials, glm::inverse(to_view), plain);
    objects.objects.push_back(std::move(object));
    objects.looks.push_back(std::move(look));
    objects.features.push_back(
        {objects.next_id - 1, "solid", number, solid.name, bounds.highest_m.z - bounds.lowest_m.z});
  });
}

void place_light(const SceneContents& contents, const ViewFrame& frame, Scene& scene) {
  const VerticalFrame& vertical = frame.terrain()->frame();
  place_each(contents.lamps, contents.path, "lamps", [&](const SceneLamp& given, int /*number*/) {
    const PlacedPoint place = placed_point(given.place, frame);
    Lamp lamp = given.lamp;
    lamp.position_m = view_point(place, vertical);
    if (given.towards)
      lamp.spot->direction =
          view_point(placed_point(*given.towards, frame), vertical) - lamp.position_m;
    else if (lamp.spot)
      lamp.spot->direction = glm::dmat3(stand_at(place, 0, frame)) * lamp.spot->direction;
    if (lamp.spot && !(glm::length(lamp.spot->direction) > 0))
      throw InputError("its spot aims at its own place: aim elsewhere");
    scene.lamps.push_back(lamp);
  });
  if (contents.sun) scene.light.sun = *contents.sun;
  if (contents.ambient) scene.light.ambient = *contents.ambient;
  if (contents.background) {
    scene.painted_sky = nullptr;
    scene.sky = {*contents.background, *contents.background};
  }
}

void show_display_colors(Image& image) {
  for (int row = 0; row < image.height_px(); ++row)
    for (int column = 0; column < image.width_px(); ++column) {
      glm::vec3& color = image.at(column, row);
      color = from_srgb8(255 * color.r, 255 * color.g, 255 * color.b);
    }
}

}  // namespace terrview
