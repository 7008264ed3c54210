#include "cli/scene/scene_shades.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <glm/matrix.hpp>

#include "cli/scene/scene_transform.h"

namespace terrview {
namespace {

const std::vector<std::string> kOperators{"add", "multiply", "mix"};
const std::vector<std::string> kScalars{"facing", "fresnel", "checker", "field"};
const std::vector<std::string> kTextures{"checker", "field", "marble", "wood", "picture"};

bool is_among(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// The shade's kind, whose keys alone it must have.
std::string kind_of(const SceneNode& node) {
  std::vector<std::string> kinds;
  for (const auto& [kind, keys] : shade_keys()) kinds.push_back(kind);
  const std::string kind = node.at("kind").word(kinds);
  std::vector<std::string> keys = shade_keys().at(kind);
  keys.emplace_back("kind");
  if (is_texture(kind)) keys.insert(keys.end(), transform_keys().begin(), transform_keys().end());
  node.check_keys(keys);
  return kind;
}

bool is_color(const std::string& kind) {
  return !is_among(kOperators, kind) && !is_among(kScalars, kind);
}

// From a solid's frame to texture space, which the transform places there.
glm::dmat4 to_texture(const SceneNode& node) { return glm::inverse(read_transform(node)); }

FieldOptions read_field(const SceneNode& node) {
  FieldOptions field;
  if (const auto seed = node.find("seed"))
    field.seed = static_cast<std::uint64_t>(seed->integer(0, 1'000'000'000));
  if (const auto levels = node.find("levels")) field.levels = glm::ivec2(levels->integer(1, 12));
  if (const auto smoothness = node.find("smoothness"))
    field.h = {smoothness->number({0, 1, "a number from 0 (rough) to 1 (soft)"})};
  return field;
}

Mapping read_mapping(const SceneNode& node) {
  const auto mapping = node.find("mapping");
  if (!mapping) return Mapping::planar;
  const std::string word = mapping->word({"planar", "cylindrical", "spherical"});
  return word == "planar"      ? Mapping::planar
         : word == "spherical" ? Mapping::spherical
                               : Mapping::cylindrical;
}

// A texture of a random field.
template <class Texture>
auto field_plan(const SceneNode& node, Texture texture) {
  return [field = read_field(node), own = to_texture(node), texture](const glm::dmat4& to_solid) {
    return texture(field, own * to_solid);
  };
}

}  // namespace

const std::map<std::string, std::vector<std::string>>& shade_keys() {
  static const std::map<std::string, std::vector<std::string>> keys{
      {"add", {"of"}},
      {"multiply", {"of"}},
      {"mix", {"of", "share"}},
      {"facing", {}},
      {"fresnel", {"index"}},
      {"checker", {"squares", "mapping"}},
      {"field", {"seed", "levels", "smoothness"}},
      {"marble", {"seed", "levels", "smoothness"}},
      {"wood", {"seed", "levels", "smoothness"}},
      {"picture", {"file", "mapping"}}};
  return keys;
}

bool is_texture(const std::string& kind) { return is_among(kTextures, kind); }

void ShadeReader::count(const SceneNode& node) {
  if (++nodes_ > kMostNodes)
    node.fail("with this the material has more than " + std::to_string(kMostNodes) +
              " shades: make it simpler");
}

ScalarPlan ShadeReader::scalar(const SceneNode& node) {
  count(node);
  if (node.json().is_number()) {
    const double value = node.number({-1e6, 1e6, "a number, a million at most either way"});
    return [shade = constant(value)](const glm::dmat4&) { return shade; };
  }
  if (node.json().is_object()) {
    const std::string kind = kind_of(node);
    if (!is_color(kind)) return scalar_kind(node, kind);
  }
  return [inner = color(node)](const glm::dmat4& to_solid) { return luminance(inner(to_solid)); };
}

ColorPlan ShadeReader::color(const SceneNode& node) {
  count(node);
  if (node.json().is_array())
    return [shade = constant(colors_.read(node))](const glm::dmat4&) { return shade; };
  if (node.json().is_object()) {
    const std::string kind = kind_of(node);
    if (!is_among(kScalars, kind)) return color_kind(node, kind);
  } else if (!node.json().is_number()) {
    node.fail("give a number, a colour as [180, 200, 220], or a shade as {\"kind\": \"marble\"}");
  }
  return [inner = scalar(node)](const glm::dmat4& to_solid) { return gray(inner(to_solid)); };
}

ScalarPlan ShadeReader::scalar_kind(const SceneNode& node, const std::string& kind) {
  if (is_among(kOperators, kind))
    return combined<double>(node, kind, [this](const SceneNode& one) { return scalar(one); });
  if (kind == "facing") return [shade = facing()](const glm::dmat4&) { return shade; };
  if (kind == "fresnel") {
    const double index = node.at("index").number({1, 10, "an index of refraction from 1 to 10"});
    return [shade = fresnel(index)](const glm::dmat4&) { return shade; };
  }
  has_texture_ = true;
  if (kind == "checker") return checker_plan(node);
  return field_plan(node, solid_field);
}

ColorPlan ShadeReader::color_kind(const SceneNode& node, const std::string& kind) {
  if (is_among(kOperators, kind))
    return combined<glm::vec3>(node, kind, [this](const SceneNode& one) { return color(one); });
  has_texture_ = true;
  if (kind == "picture") return picture_plan(node);
  return field_plan(node, kind == "marble" ? marble : wood);
}

template <class Value, class Read>
ShadePlan<Value> ShadeReader::combined(const SceneNode& node, const std::string& kind,
                                       const Read& read) {
  const bool mixes = kind == "mix";
  const SceneNode of = node.at("of");
  const std::vector<SceneNode> parts = of.elements(mixes ? 2 : kMostNodes);
  if (parts.size() < 2) of.fail("give two shades");
  std::vector<ShadePlan<Value>> plans;
  for (const SceneNode& part : parts) plans.push_back(read(part));
  if (mixes)
    return [plans, share = scalar(node.at("share"))](const glm::dmat4& to_solid) {
      return mix(plans[0](to_solid), plans[1](to_solid), share(to_solid));
    };
  return [plans, adds = kind == "add"](const glm::dmat4& to_solid) {
    auto all = plans[0](to_solid);
    for (std::size_t i = 1; i < plans.size(); ++i)
      all = adds ? add(all, plans[i](to_solid)) : multiply(all, plans[i](to_solid));
    return all;
  };
}

ScalarPlan ShadeReader::checker_plan(const SceneNode& node) {
  glm::ivec2 squares(2);
  if (const auto given = node.find("squares")) {
    const std::vector<SceneNode> both = given->elements(2);
    if (both.size() != 2) given->fail("give the squares along and up, as [8, 8]");
    constexpr int kMost = 1'000'000;
    squares = {both[0].integer(1, kMost), both[1].integer(1, kMost)};
  }
  return
      [squares, mapping = read_mapping(node), own = to_texture(node)](const glm::dmat4& to_solid) {
        return checker(squares, {mapping, own * to_solid});
      };
}

ColorPlan ShadeReader::picture_plan(const SceneNode& node) {
  return [picture = pictures_.read(node.at("file")), mapping = read_mapping(node),
          own = to_texture(node)](const glm::dmat4& to_solid) {
    return picture_texture(picture, {mapping, own * to_solid});
  };
}

}  // namespace terrview
