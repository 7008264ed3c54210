#include "cli/scene/scene_command.h"

#include <cstdio>
#include <filesystem>

#include "cli/output_options.h"
#include "cli/parse.h"
#include "cli/prepare_view.h"
#include "cli/scene/scene_file.h"
#include "cli/scene/scene_json.h"
#include "cli/view_command.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr const char* kProgram = "terrview SCENE";

// The scene's name without its folder, in the format's usual extension; spheres go to PPM, as in
// the document that they come from.
std::string default_output(const SceneFile& scene, const ViewOptions& options) {
  const bool is_xml = is_xml_name(scene.path) && options.format.empty();
  return std::filesystem::path(scene.path).stem().string() +
         (is_xml ? ".ppm" : usual_extension(options.format));
}

// What the command line says goes before what the scene does.
void overrule(SceneFile& scene, const GivenView& given) {
  JobRow said;
  said.cells = given.values;
  scene.options = ViewVocabulary().with_row(std::move(scene.options), said);
  if (given.values.count("o") > 0) scene.options["o"] = given.values.at("o");
  if (!given.dems.empty()) scene.dems = given.dems;
}

ViewOptions view_of(const SceneFile& scene) {
  try {
    return parse_view(ViewVocabulary().arguments(scene.options, scene.dems), kProgram,
                      scene.contents);
  } catch (const InputError& error) {
    throw InputError(scene.path + ": " + error.what());
  }
}

}  // namespace

bool is_scene_name(const std::string& name) {
  const std::string extension = lower_case(std::filesystem::path(name).extension().string());
  return extension == ".json" || extension == ".xml";
}

int run_scene(const std::vector<std::string>& args) {
  const GivenView given = given_view({args.begin() + 1, args.end()}, kProgram);
  SceneFile scene = read_scene_file(args.front());
  overrule(scene, given);
  ViewOptions options = view_of(scene);
  if (given.prints_scene) {
    std::printf("%s", scene_text(scene_json(scene)).c_str());
    return 0;
  }
  if (options.output.empty()) options.output = default_output(scene, options);
  return run_prepared_view(std::move(options));
}

}  // namespace terrview
