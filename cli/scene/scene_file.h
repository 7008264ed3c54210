// Scene files: docs/scenes.md.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/batch/option_values.h"
#include "cli/scene/json_text.h"
#include "cli/scene/scene_contents.h"

namespace terrview {

struct SceneFile {
  std::string path;
  std::vector<std::string> dems;  // as seen from the current folder
  OptionValues options;           // likewise; none of how the program behaves
  std::shared_ptr<const SceneContents> contents;
  SceneJson contents_json;  // the same as it stands in the file
};

// A scene in JSON, or of spheres in XML (ingest/sphere_scene.h). `path` says what names of files
// are relative to, and is for messages. Throws InputError: `path:line: place: what: how to mend
// it`.
[[nodiscard]] SceneFile parse_json_scene(std::string text, const std::string& path);
[[nodiscard]] SceneFile parse_xml_scene(const std::string& text, const std::string& path);

[[nodiscard]] bool is_xml_name(const std::string& path);

// Either, by the file's name. Throws InputError also if it cannot be read.
[[nodiscard]] SceneFile read_scene_file(const std::string& path);

}  // namespace terrview
