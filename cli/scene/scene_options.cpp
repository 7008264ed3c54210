#include "cli/scene/scene_options.h"

#include "cli/command_line.h"
#include "cli/view_options.h"

namespace terrview {
namespace {

// Of an option: a plane's corners are no more.
constexpr std::size_t kMostValues = 100;

std::string scalar(const SceneNode& node) {
  const SceneJson& json = node.json();
  if (json.is_string()) return node.text();
  if (!json.is_number() && !json.is_boolean())
    node.fail("give a text or a number, or a list of these");
  return json.dump();
}

std::vector<std::string> texts(const SceneNode& node) {
  if (!node.json().is_array()) return {scalar(node)};
  std::vector<std::string> all;
  for (const SceneNode& element : node.elements(kMostValues)) all.push_back(scalar(element));
  if (all.empty()) node.fail("is an empty list: leave it out");
  return all;
}

// Throws InputError for what the command line would not take.
void check_alone(const ViewVocabulary& vocabulary, const OptionValues& value) {
  ViewOptions options;
  CommandLine app("", "terrview");
  add_view_options(app, options);
  app.get_option("DEM")->required(false);
  app.parse_args(vocabulary.arguments(value, {}));
}

}  // namespace

OptionValues read_scene_options(const SceneNode& options) {
  const ViewVocabulary vocabulary;
  std::vector<std::string> known;
  for (const std::string& name : vocabulary.names())
    if (!vocabulary.is_behaviour(name)) known.push_back(name);
  OptionValues values;
  for (const auto& [name, node] : options.members()) {
    if (vocabulary.is_behaviour(name)) node.fail("is for the command line: leave it out here");
    JobRow row;
    row.cells[name] = texts(node);
    OptionValues value = node.make([&] {
      OptionValues said = vocabulary.with_row({}, row);
      check_alone(vocabulary, said);
      return said;
    });
    values.merge(value);
  }
  options.check_keys(known);
  return values;
}

}  // namespace terrview
