#include "cli/scene/scene_json.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "cli/scene/scene_paths.h"
#include "terrain/error.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;

// A number where that is the same text.
Json json_of(const std::string& text) {
  const Json number = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (number.is_number() && number.dump() == text) return number;
  return text;
}

Json json_of(const std::vector<std::string>& texts) {
  if (texts.size() == 1) return json_of(texts.front());
  Json all = Json::array();
  for (const std::string& text : texts) all.push_back(json_of(text));
  return all;
}

// Names of pictures, wherever they are in the members of a file in `folder`.
void name_pictures(Json& json, const std::string& folder) {
  const bool is_picture = json.is_object() && json.value("kind", Json()) == "picture";
  if (is_picture) json["file"] = from_folder(json["file"].get<std::string>(), folder);
  if (json.is_structured())
    for (Json& inner : json) name_pictures(inner, folder);
}

}  // namespace

Json scene_json(const OptionValues& values, const std::vector<std::string>& dems,
                const std::string& folder) {
  const ViewVocabulary vocabulary;
  Json scene;
  scene["dems"] = Json::array();
  for (const std::string& dem : dems) scene["dems"].push_back(to_folder(dem, folder));
  scene["options"] = Json::object();
  for (const auto& [name, texts] : to_folder(values, folder)) {
    if (vocabulary.is_behaviour(name)) continue;
    scene["options"][name] = vocabulary.is_flag(name) ? Json(true) : json_of(texts);
  }
  return scene;
}

Json scene_json(const SceneFile& scene) {
  Json json = scene_json(scene.options, scene.dems);
  const std::string folder = std::filesystem::path(scene.path).parent_path().string();
  for (const auto& [key, value] : scene.contents_json.items()) {
    json[key] = value;
    name_pictures(json[key], folder);
  }
  return json;
}

std::string scene_text(const Json& scene) {
  try {
    return scene.dump(2) + "\n";
  } catch (const Json::type_error&) {
    throw InputError("scene file: a name in it is not UTF-8: rename the file");
  }
}

}  // namespace terrview
