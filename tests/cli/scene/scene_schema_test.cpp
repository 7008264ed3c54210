// docs/scene.schema.json says what the reader of scene files knows, no less and no more.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/command_line.h"
#include "cli/scene/scene_contents.h"
#include "cli/scene/scene_materials.h"
#include "cli/scene/scene_shades.h"
#include "cli/scene/scene_shapes.h"
#include "cli/scene/scene_transform.h"
#include "cli/view_options.h"
#include "tests/cli/scene/scene_cases.h"
#include "tests/cli/scene/schema_check.h"

namespace terrview {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::set<std::string>;

const Json& schema() {
  static const Json json = Json::parse(read_text(TERRVIEW_SOURCE_DIR "/docs/scene.schema.json"));
  return json;
}

const Json& definition(const std::string& name) { return schema().at("$defs").at(name); }

Names keys(const Json& object_schema) {
  Names names;
  for (const auto& [key, value] : object_schema.at("properties").items()) names.insert(key);
  return names;
}

Names joined(std::initializer_list<std::vector<std::string>> lists) {
  Names names;
  for (const auto& list : lists) names.insert(list.begin(), list.end());
  return names;
}

// The objects among the alternatives of a definition, by their kind.
std::map<std::string, Names> keys_by_kind(const std::string& name) {
  std::map<std::string, Names> kinds;
  for (const Json& one : definition(name).at("oneOf"))
    if (one.contains("properties")) kinds[one["properties"]["kind"]["const"]] = keys(one);
  return kinds;
}

// What the schema says of an option.
Json option_schema(const OptionDefinition& option) {
  Json json;
  const std::string type = option.type_name;
  const std::string words = type.substr(0, type.find(":{"));
  const bool has_choices = type.find(":{") != std::string::npos;
  if (option.is_flag) {
    json["type"] = "boolean";
  } else if (has_choices) {
    json["enum"] = Json::array();
    for (std::size_t at = 0; at <= words.size();) {
      const std::size_t end = std::min(words.find('|', at), words.size());
      json["enum"].push_back(words.substr(at, end - at));
      at = end + 1;
    }
  } else {
    json["$ref"] = "#/$defs/value";
  }
  json["description"] = option.help;
  return json;
}

TEST(SceneSchema, HasEveryOptionOfViewButThoseOfTheProgram) {
  CommandLine app("", "terrview view");
  ViewOptions options;
  add_view_options(app, options);
  const ViewVocabulary vocabulary;
  std::map<std::string, Json> by_name;
  for (const OptionDefinition& option : app.definitions())
    if (!vocabulary.is_behaviour(option.name)) by_name[option.name] = option_schema(option);
  const Json expected = by_name;
  EXPECT_EQ(definition("options").at("properties"), expected) << expected.dump();
}

TEST(SceneSchema, HasTheKeysThatTheReaderKnows) {
  EXPECT_EQ(keys(schema()), joined({{"$schema", "dems", "options"}, contents_keys()}));
  std::map<std::string, Names> shapes;
  std::map<std::string, Names> solids;
  for (const auto& [kind, own] : shape_keys()) {
    shapes[kind] = joined({own, {"kind", "material"}, transform_keys()});
    solids[kind] =
        joined({own, {"kind", "material", "name", "at", "at-xy", "heading"}, transform_keys()});
  }
  EXPECT_EQ(keys_by_kind("shape"), shapes);
  EXPECT_EQ(keys_by_kind("solid"), solids);
  EXPECT_EQ(keys(definition("material").at("oneOf").at(0)), joined({material_keys()}));
  std::map<std::string, Names> shades;
  for (const auto& [kind, own] : shade_keys()) {
    shades[kind] = joined({own, {"kind"}});
    if (is_texture(kind)) shades[kind].insert(transform_keys().begin(), transform_keys().end());
  }
  EXPECT_EQ(keys_by_kind("shade"), shades);
}

TEST(SceneSchema, TheSamplesAreValid) {
  for (const std::string& name : json_samples()) {
    EXPECT_EQ(schema_fault(schema(), Json::parse(sample_scene(name))), "") << name;
    EXPECT_EQ(refusal_of_scene(sample_scene(name)).find("s.json:"), std::string::npos) << name;
  }
}

// Wherever the reader refuses a key or a kind, so does the schema.
TEST(SceneSchema, RefusesWhatTheReaderRefuses) {
  for (const char* text :
       {R"({"solid": []})", R"({"options": {"fow": 60}})", R"({"options": {"no-shadows": "yes"}})",
        R"({"options": {"earth": "round"}})", R"({"solids": [{"kind": "ball", "radius": 1}]})",
        R"({"solids": [{"kind": "sphere", "at-xy": [0, 0], "radius": 0}]})",
        R"({"solids": [{"kind": "sphere", "at-xy": [0, 0]}]})",
        R"({"solids": [{"kind": "box", "at-xy": [0, 0], "size": [1, 2]}]})",
        R"({"materials": {"a": {"colour": [1, 2, 3]}}})",
        R"({"materials": {"a": {"color": [1, 2]}}})",
        R"({"lamps": [{"at-xy": [0, 0], "spot": {"half-angle": 0}}]})"}) {
    EXPECT_NE(schema_fault(schema(), Json::parse(text)), "") << text;
    EXPECT_NE(refusal_of_scene(text), "") << text;
  }
}

}  // namespace
}  // namespace terrview
