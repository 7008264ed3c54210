#include "cli/scene/sphere_scene_json.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terrview {
namespace {

SceneJson place_json(const glm::dvec3& point) { return {point.x, 0 - point.z, 0 - point.y}; }

SceneJson color_json(const glm::dvec3& color) { return {color.r, color.g, color.b}; }

SceneJson options_json(const SphereScene& scene) {
  const glm::dvec2 size(scene.window_size);
  const glm::dvec2 middle = glm::dvec2(scene.window) + 0.5 * size;
  const double distance = scene.eye_z - scene.window.z;
  return {{"eye-xy", place_json({0, 0, scene.eye_z})},
          {"heading", 0},
          {"fov", 2 * std::atan(size.x / 2 / distance) * 180 / std::numbers::pi},
          {"shift", {middle.x / size.x, 0 - middle.y / size.y}},
          {"size", std::to_string(scene.window_size.x) + "x" + std::to_string(scene.window_size.y)},
          {"no-sky", true},
          {"visibility", "inf"}};
}

SceneJson sphere_json(const SphereScene::Sphere& sphere) {
  SceneJson json{{"kind", "sphere"},
                 {"at-xy", place_json(sphere.centre)},
                 {"radius", sphere.radius},
                 {"material",
                  {{"model", "guitteny"},
                   {"color", color_json(sphere.color)},
                   {"ambient", std::max(0.0, 1 - sphere.mirror - sphere.diffuse - sphere.specular)},
                   {"diffuse", sphere.diffuse},
                   {"specular", sphere.specular},
                   {"exponent", sphere.exponent}}}};
  if (sphere.mirror > 0) json["material"]["mirror"] = sphere.mirror;
  if (sphere.surface == SphereScene::Surface::meridians) json["meridians"] = sphere.facets;
  if (sphere.surface == SphereScene::Surface::equator) json["rings"] = sphere.facets;
  return json;
}

SceneJson lamp_json(const SphereScene::Lamp& lamp) {
  return {{"at-xy", place_json(lamp.position)},
          {"color", color_json(lamp.color)},
          {"intensity", lamp.intensity},
          {"distance", 0}};
}

}  // namespace

SceneJson sphere_scene_json(const SphereScene& scene) {
  SceneJson json{
      {"options", options_json(scene)},
      {"colors", "display"},
      {"light", {{"sun", {0, 0, 0}}, {"ambient", {255, 255, 255}}, {"background", {0, 0, 0}}}},
      {"solids", SceneJson::array()},
      {"lamps", SceneJson::array()}};
  for (const SphereScene::Sphere& sphere : scene.spheres)
    json["solids"].push_back(sphere_json(sphere));
  for (const SphereScene::Lamp& lamp : scene.lamps) json["lamps"].push_back(lamp_json(lamp));
  return json;
}

}  // namespace terrview
