#include "cli/scene/scene_materials.h"

#include <utility>
#include <vector>

#include "cli/scene/scene_shades.h"

namespace terrview {
namespace {

// What is not said of it is plain: it scatters all light, and neither shines, mirrors nor is clear.
struct Plans {
  ColorPlan color;
  ScalarPlan ambient;
  ScalarPlan diffuse;
  ScalarPlan specular;
  ScalarPlan exponent;
  ColorPlan mirror;
  ColorPlan transparency;
  ScalarPlan bump_m;
  double refractive_index = 1.5;
  LightModel model = LightModel::whitted;
};

template <class Value>
std::shared_ptr<const Shade<Value>> made(const ShadePlan<Value>& plan, const glm::dmat4& to_solid) {
  return plan ? plan(to_solid) : nullptr;
}

Material made(const Plans& plans, const glm::dmat4& to_solid) {
  Material material;
  material.color = made(plans.color, to_solid);
  material.ambient = made(plans.ambient, to_solid);
  material.diffuse = made(plans.diffuse, to_solid);
  material.specular = made(plans.specular, to_solid);
  material.exponent = made(plans.exponent, to_solid);
  material.mirror = made(plans.mirror, to_solid);
  material.transparency = made(plans.transparency, to_solid);
  material.bump_m = made(plans.bump_m, to_solid);
  material.refractive_index = plans.refractive_index;
  material.model = plans.model;
  return material;
}

double read_index(const SceneNode& node) {
  return node.number({1, 10, "an index of refraction from 1 to 10, as 1.5 for glass"});
}

SceneMaterial glass_material(const SceneNode& node) {
  node.check_keys({"glass"});
  const double index = read_index(node.at("glass"));
  return {[index](const glm::dmat4&) { return glass(index); }, 1, false};
}

Plans read_plans(const SceneNode& node, ShadeReader& shades) {
  const auto scalar = [&](const char* key) {
    const auto found = node.find(key);
    return found ? shades.scalar(*found) : ScalarPlan();
  };
  const auto color = [&](const char* key) {
    const auto found = node.find(key);
    return found ? shades.color(*found) : ColorPlan();
  };
  const auto in_full = [](const glm::dmat4&) { return constant(1.0); };
  Plans plans;
  plans.color = color("color");
  plans.ambient = node.has("ambient") ? scalar("ambient") : in_full;
  plans.diffuse = node.has("diffuse") ? scalar("diffuse") : in_full;
  plans.specular = scalar("specular");
  plans.exponent = scalar("exponent");
  plans.mirror = color("mirror");
  plans.transparency = color("transparency");
  plans.bump_m = scalar("bump");
  if (const auto index = node.find("refractive-index")) plans.refractive_index = read_index(*index);
  if (const auto model = node.find("model"))
    plans.model = model->word({"whitted", "guitteny"}) == "whitted" ? LightModel::whitted
                                                                    : LightModel::guitteny;
  return plans;
}

}  // namespace

const std::vector<std::string>& material_keys() {
  static const std::vector<std::string> keys{
      "color",  "ambient",      "diffuse",          "specular", "exponent",
      "mirror", "transparency", "refractive-index", "bump",     "model"};
  return keys;
}

SceneMaterials::SceneMaterials(const std::optional<SceneNode>& materials, const SceneColors& colors,
                               ScenePictures& pictures)
    : colors_(colors), pictures_(pictures) {
  if (!materials) return;
  for (const auto& [name, node] : materials->members()) named_[name] = read_material(node);
}

MaterialPlan SceneMaterials::read(const SceneNode& node) const {
  if (!node.json().is_string()) return read_material(node);
  const std::string name = node.text();
  const auto found = named_.find(name);
  if (found != named_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, unused] : named_) names.push_back(known);
  node.fail_unknown(name, names);
}

MaterialPlan SceneMaterials::read_material(const SceneNode& node) const {
  if (node.has("glass")) return std::make_shared<SceneMaterial>(glass_material(node));
  node.check_keys(material_keys());
  ShadeReader shades(colors_, pictures_);
  Plans plans = read_plans(node, shades);
  return std::make_shared<SceneMaterial>(SceneMaterial{
      [plans = std::move(plans)](const glm::dmat4& to_solid) { return made(plans, to_solid); },
      shades.nodes(), shades.has_texture()});
}

}  // namespace terrview
