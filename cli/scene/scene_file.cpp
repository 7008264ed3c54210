#include "cli/scene/scene_file.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/parse.h"
#include "cli/read_file.h"
#include "cli/scene/scene_node.h"
#include "cli/scene/scene_options.h"
#include "cli/scene/scene_paths.h"
#include "cli/scene/sphere_scene_json.h"
#include "ingest/sphere_scene.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr std::size_t kMostDems = 10'000;

void check_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw InputError("'" + path + "': is no file: name a scene file");
  const auto bytes = std::filesystem::file_size(path, error);
  if (!error && bytes > JsonText::kLongest)
    throw InputError("'" + path + "': is longer than " + std::to_string(JsonText::kLongest >> 20) +
                     " MiB: a scene refers to its data by the names of files");
}

SceneFile scene_of(const JsonText& json, const std::string& path) {
  const SceneNode root(json);
  std::vector<std::string> keys{"$schema", "dems", "options"};
  keys.insert(keys.end(), contents_keys().begin(), contents_keys().end());
  root.check_keys(keys);
  if (const auto schema = root.find("$schema")) static_cast<void>(schema->text());
  const std::string folder = std::filesystem::path(path).parent_path().string();
  SceneFile scene;
  scene.path = path;
  if (const auto dems = root.find("dems"))
    for (const SceneNode& dem : dems->elements(kMostDems))
      scene.dems.push_back(from_folder(dem.text(), folder));
  if (const auto options = root.find("options"))
    scene.options = from_folder(read_scene_options(*options), folder);
  scene.contents = std::make_shared<const SceneContents>(read_contents(root, path, folder));
  for (const std::string& key : contents_keys())
    if (root.has(key)) scene.contents_json[key] = json.root()[key];
  return scene;
}

}  // namespace

SceneFile parse_json_scene(std::string text, const std::string& path) {
  return scene_of(JsonText(path, std::move(text)), path);
}

SceneFile parse_xml_scene(const std::string& text, const std::string& path) {
  return scene_of(JsonText(path, sphere_scene_json(parse_sphere_scene(text, path))), path);
}

bool is_xml_name(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string()) == ".xml";
}

SceneFile read_scene_file(const std::string& path) {
  check_file(path);
  const std::string text = read_file(path);
  return is_xml_name(path) ? parse_xml_scene(text, path) : parse_json_scene(text, path);
}

}  // namespace terrview
