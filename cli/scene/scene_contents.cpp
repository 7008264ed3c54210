#include "cli/scene/scene_contents.h"

#include <algorithm>
#include <memory>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cli/scene/scene_colors.h"
#include "cli/scene/scene_pictures.h"
#include "cli/scene/scene_shapes.h"
#include "cli/scene/scene_transform.h"
#include "render/objects/solids/solid_object.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

// Of the shade trees that each solid has for itself.
constexpr std::int64_t kMostShades = 2'000'000;

void check_size(const SceneNode& node, const SolidPtr& solid) {
  const Box box = node.make([&] { return SolidObject(solid).bounds(); });
  const glm::dvec3 size = box.highest_m - box.lowest_m;
  constexpr double kSmallest_m = 1e-6;
  const glm::dvec3 furthest = glm::max(glm::abs(box.lowest_m), glm::abs(box.highest_m));
  if (!(std::min({size.x, size.y, size.z}) >= kSmallest_m) ||
      !(std::max({furthest.x, furthest.y, furthest.z}) <= kFarthest_m))
    node.fail(
        "is smaller than a thousandth of a millimetre, or reaches further than 1000 km: "
        "check its sizes");
}

std::int64_t shades_of(const SceneShape& shape) {
  std::vector<MaterialPlan> plans = shape.materials;
  std::sort(plans.begin(), plans.end());
  plans.erase(std::unique(plans.begin(), plans.end()), plans.end());
  std::int64_t nodes = 0;
  for (const MaterialPlan& plan : plans)
    if (plan && plan->has_texture) nodes += plan->nodes;
  return nodes;
}

void read_solids(const SceneNode& solids, SceneShapes& shapes, SceneContents& contents) {
  std::int64_t shades = 0;
  for (const SceneNode& node : solids.elements(kMostSolids)) {
    SceneShape shape = shapes.read(node, {"name", "at", "at-xy", "heading"});
    shades += shades_of(shape);
    if (shades > kMostShades)
      node.fail("with this the solids have more than " + std::to_string(kMostShades) +
                " shades: give fewer of them textures");
    check_size(node, shape.solid);
    SceneSolid solid;
    if (const auto name = node.find("name")) solid.name = name->text();
    solid.place = read_place(node, "at", "at-xy");
    if (const auto heading = node.find("heading"))
      solid.heading_rad = heading->number({-360, 360, "degrees from -360 to 360"}) * kRadians;
    solid.solid = std::move(shape.solid);
    solid.materials = std::move(shape.materials);
    contents.solids.push_back(std::move(solid));
  }
}

Spot read_spot(const SceneNode& node, std::optional<Target>& towards) {
  node.check_keys({"towards", "towards-xy", "direction", "half-angle"});
  Spot spot;
  if (const auto direction = node.find("direction")) {
    spot.direction = direction->vector({-1e6, 1e6, "a direction as [0, 0, -1]"});
    if (!(glm::length(spot.direction) > 1e-6)) direction->fail("give a direction with a length");
  } else {
    towards = read_place(node, "towards", "towards-xy");
  }
  if (const auto angle = node.find("half-angle"))
    spot.half_angle_rad = angle->number({0, 90, "degrees above 0, up to 90", true}) * kRadians;
  return spot;
}

SceneLamp read_lamp(const SceneNode& node, const SceneColors& colors) {
  node.check_keys({"at", "at-xy", "color", "intensity", "distance", "spot"});
  SceneLamp lamp;
  lamp.place = read_place(node, "at", "at-xy");
  if (const auto color = node.find("color")) lamp.lamp.color = colors.read(*color);
  if (const auto intensity = node.find("intensity"))
    lamp.lamp.intensity = intensity->number({0, 1e9, "a number, 0 or more"});
  if (const auto distance = node.find("distance"))
    lamp.lamp.reference_m =
        distance->number({0, kFarthest_m, "metres, or 0: as bright everywhere"});
  if (const auto spot = node.find("spot")) lamp.lamp.spot = read_spot(*spot, lamp.towards);
  return lamp;
}

void read_light(const SceneNode& node, const SceneColors& colors, SceneContents& contents) {
  node.check_keys({"sun", "ambient", "background"});
  if (const auto sun = node.find("sun")) contents.sun = colors.read(*sun);
  if (const auto ambient = node.find("ambient")) contents.ambient = colors.read(*ambient);
  if (const auto background = node.find("background"))
    contents.background = colors.read(*background);
}

}  // namespace

const std::vector<std::string>& contents_keys() {
  static const std::vector<std::string> keys{"materials", "shapes", "solids",
                                             "lamps",     "light",  "colors"};
  return keys;
}

SceneContents read_contents(const SceneNode& root, const std::string& path,
                            const std::string& folder) {
  SceneContents contents;
  contents.path = path;
  SceneColors colors;
  if (const auto said = root.find("colors"))
    colors.are_display = said->word({"linear", "display"}) == "display";
  contents.display_colors = colors.are_display;
  ScenePictures pictures(folder);
  const SceneMaterials materials(root.find("materials"), colors, pictures);
  SceneShapes shapes(root.find("shapes"), materials);
  if (const auto solids = root.find("solids")) read_solids(*solids, shapes, contents);
  if (const auto lamps = root.find("lamps"))
    for (const SceneNode& lamp : lamps->elements(kMostLamps))
      contents.lamps.push_back(read_lamp(lamp, colors));
  if (const auto light = root.find("light")) read_light(*light, colors, contents);
  contents.pictures = pictures.paths();
  return contents;
}

}  // namespace terrview
