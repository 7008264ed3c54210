// JSON scenes that are broken, or made to do harm: one clear line each.
#include <chrono>
#include <string>

#include "cli/scene/scene_contents.h"
#include "cli/scene/scene_shapes.h"
#include "tests/cli/scene/scene_cases.h"

namespace terrview {
namespace {

const std::string kBall = R"("kind": "sphere", "radius": 1)";

TEST(HostileScene, EveryTruncationIsRefusedInOneLine) {
  for (const std::string& name : json_samples()) {
    const std::string whole = sample_scene(name);
    const std::size_t end = whole.rfind('}') + 1;
    for (std::size_t length = 0; length < end; ++length)
      expect_scene_refused(whole.substr(0, length), "broken off, or no JSON");
  }
}

TEST(HostileScene, ComplaintsNameTheLineAndThePlace) {
  const std::string text =
      "{\n  \"solids\": [\n    {\"kind\": \"box\", \"at-xy\": [0, 0], \"size\": [1, 1, 1]},\n"
      "    {\"kind\": \"sphere\",\n     \"at-xy\": [0, 0],\n     \"radius\": -3\n    }\n  ]\n}\n";
  expect_scene_refused(text, "s.json:6: /solids/1/radius: give metres above 0");
  expect_scene_refused("{\"a/b~c\": 1}", "s.json:1: /a~1b~0c: 'a/b~c': nothing is called so here");
  expect_scene_refused("\xEF\xBB\xBF{\n\"solid\":\n[]}", "s.json:3: /solid: 'solid': nothing");
}

// Not that of a key called alike in another object.
TEST(HostileScene, ComplaintsNameTheLineOfTheirOwnPlace) {
  expect_scene_refused("{\"materials\": {\n\"kind\": {\n\"kind\": {}}},\n\"kind\": 1}",
                       "s.json:4: /kind: 'kind': nothing is called so here");
}

TEST(HostileScene, WrongNamesGetTheNearestRightOne) {
  expect_scene_refused(
      scene_of_solid(R"("kind": "shpere", "radius": 1)"),
      "/solids/0/kind: 'shpere': nothing is called so here: did you mean 'sphere'");
  expect_scene_refused(scene_of_solid(kBall + R"(, "roatte": [0, 0, 0])"), "mean 'rotate'?");
  expect_scene_refused(scene_of_solid(kBall + R"(, "material": "ston")",
                                      R"(, "materials": {"stone": {}, "glass": {}})"),
                       "mean 'stone'?");
  expect_scene_refused(R"({"options": {"fov": 60, "no-shadow": true}})", "mean 'no-shadows'?");
  expect_scene_refused(R"({"options": {"threads": 3}})", "is for the command line");
}

TEST(HostileScene, NestingIsBounded) {
  expect_scene_refused(std::string(300, '['), "nests deeper than 200");
  expect_scene_refused(std::string(10'000'000, '['), "nests deeper than 200");
  std::string objects;
  for (int i = 0; i < 300; ++i) objects += "{\"a\":";
  expect_scene_refused(objects, "nests deeper than 200");
}

std::string difference_of_depth(int depth) {
  std::string tree = "{" + kBall + "}";
  for (int i = 0; i < depth; ++i)
    tree = R"({"kind": "difference", "of": [)" + tree + R"(, {"kind": "sphere", "radius": 0.5}]})";
  return tree.substr(1, tree.size() - 2);
}

TEST(HostileScene, DifferencesNestFiftyDeepAndMore) {
  EXPECT_EQ(refusal_of_scene(scene_of_solid(difference_of_depth(50))), "");
  EXPECT_EQ(refusal_of_scene(scene_of_solid(difference_of_depth(95))), "");
}

TEST(HostileScene, NamesThatLeadBackAreRefused) {
  const auto shapes = [](const std::string& inner) { return "{\"shapes\": {" + inner + "}}"; };
  const std::string self = R"("a": {"kind": "shape", "name": "a"})";
  expect_scene_refused(shapes(self), "/shapes/a/name: a shape cannot be a part of itself");
  std::string ring;
  for (int i = 0; i < 20; ++i)
    ring += (i > 0 ? ", " : "") + ("\"s" + std::to_string(i)) +
            R"(": {"kind": "shape", "name": "s)" + std::to_string((i + 1) % 20) + "\"}";
  expect_scene_refused(shapes(ring), "a shape cannot be a part of itself");
  expect_scene_refused(scene_of_solid(R"("kind": "shape", "name": "tower")"), "leave it out");
}

// A chain of names, each made of the one before `copies` times.
std::string chain(int length, int copies) {
  std::string shapes = "\"s0\": {" + kBall + "}";
  for (int i = 1; i < length; ++i) {
    std::string of;
    for (int k = 0; k < copies; ++k)
      of +=
          (k > 0 ? ", " : "") + (R"({"kind": "shape", "name": "s)" + std::to_string(i - 1)) + "\"}";
    shapes += ", \"s" + std::to_string(i) + R"(": {"kind": "union", "of": [)" + of + "]}";
  }
  return scene_of_solid(R"("kind": "shape", "name": "s)" + std::to_string(length - 1) + "\"",
                        ", \"shapes\": {" + shapes + "}");
}

TEST(HostileScene, NamesThatMultiplyOrNestAreBounded) {
  EXPECT_EQ(refusal_of_scene(chain(13, 2)), "");
  expect_scene_refused(chain(60, 2), "is of more than 10000 primitives");
  expect_scene_refused(chain(5, 100), "is of more than 10000 primitives");
  expect_scene_refused(chain(20'000, 1), "is nested deeper than 500");
}

// Each name is read before the one that is made of it.
TEST(HostileScene, LongChainsOfMovesAreBounded) {
  std::string shapes = "\"s100000\": {" + kBall + "}";
  for (int i = 100'001; i < 110'000; ++i)
    shapes += ", \"s" + std::to_string(i) + R"(": {"kind": "shape", "name": "s)" +
              std::to_string(i - 1) + R"(", "move": [1, 0, 0]})";
  expect_scene_refused("{\"shapes\": {" + shapes + "}}", "is nested deeper than 500");
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += (i > 0 ? "," : "") + text;
  return all;
}

TEST(HostileScene, CountsAreBounded) {
  expect_scene_refused("{\"solids\": [" + repeated("0", kMostSolids + 1) + "]}",
                       "give 100000 at most");
  expect_scene_refused("{\"lamps\": [" + repeated("0", kMostLamps + 1) + "]}", "give 1000 at most");
  const std::string facets = R"({"kind":"sphere","at-xy":[0,0],"radius":1,"meridians":1000})";
  expect_scene_refused("{\"solids\": [" + repeated(facets, 10) + "]}", "more than 4000000 facets");
  const std::string shades = R"({"kind":"add","of":[)" + repeated("1", 2000) + "]}";
  expect_scene_refused("{\"materials\": {\"a\": {\"color\": " + shades + "}}}",
                       "give 1000 at most");
  expect_scene_refused(std::string((16 << 20) + 1, ' '), "is longer than 16 MiB");
}

// A texture is made for each solid anew, and once for all the parts of one.
TEST(HostileScene, ShadesCountForEachSolidThatHasThem) {
  const std::string materials = R"("materials": {"a": {"color": {"kind": "add", "of": [)" +
                                repeated("1", 480) + R"(, {"kind": "marble"}]}}})";
  const std::string part = "{" + kBall + R"(, "material": "a"})";
  const std::string one =
      R"({"at-xy": [0, 0], "kind": "union", "of": [)" + repeated(part, 3000) + "]}";
  EXPECT_EQ(refusal_of_scene("{" + materials + ", \"solids\": [" + one + "]}"), "");
  const std::string alone = "{\"at-xy\": [0, 0], " + kBall + R"(, "material": "a"})";
  expect_scene_refused("{" + materials + ", \"solids\": [" + repeated(alone, 3000) + "]}",
                       "more than 2000000 shades");
}

TEST(HostileScene, NamedShapesCountWhetherTheyAreSeenOrNot) {
  std::string shapes =
      R"("a": {"kind": "union", "of": [)" + repeated("{" + kBall + "}", 10'000) + "]}";
  for (int i = 0; i < 100; ++i)
    shapes += ",\"b" + std::to_string(i) + R"(": {"kind": "shape", "name": "a"})";
  expect_scene_refused("{\"shapes\": {" + shapes + "}}", "has more than 1000000 primitives");
}

TEST(HostileScene, KeysAndSchemasAreBounded) {
  expect_scene_refused("{\n\"" + std::string(1001, 'A') + "\": 1}",
                       "s.json:2: a key is longer than 1000 bytes");
  expect_scene_refused(R"({"$schema": {"a": [0, 0]}})", "/$schema: give a text in quotes");
}

// The line of a mistake that follows many values under a long pointer.
TEST(HostileScene, ALineIsFoundInTimeThatGrowsWithTheFile) {
  std::string inner = "[" + repeated("0", 200'000) + "]";
  for (int i = 0; i < 150; ++i) inner = "{\"" + std::string(900, 'A') + "\":" + inner + "}";
  const std::string text = "{\"$schema\":" + inner + ",\n\"zzz\":1}";
  const auto start = std::chrono::steady_clock::now();
  expect_scene_refused(text, "s.json:2: /zzz: ");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(HostileScene, MessagesAreShortWhateverTheNames) {
  const std::string name(900, 'n');
  const std::string unknown(9000, 'm');
  const std::string said =
      refusal_of_scene("{\"materials\": {\"" + name + "\": {}}, \"solids\": [{" + kBall +
                       R"(, "at-xy": [0, 0, 0], "material": ")" + unknown + "\"}]}");
  EXPECT_NE(said.find("did you mean 'nnn"), std::string::npos) << said;
  EXPECT_LT(said.size(), 500U);
}

TEST(HostileScene, NumbersAreFiniteAndOfAUsefulSize) {
  const auto ball = [](const std::string& radius) {
    return scene_of_solid(R"("kind": "sphere", "radius": )" + radius);
  };
  expect_scene_refused(ball("1e999"), "a number is too large");
  for (const char* bad : {"NaN", "Infinity", "0x10", "01", "+1"})
    expect_scene_refused(ball(bad), "no JSON");
  for (const char* bad : {"1e308", "-1e308", "0", "\"5\"", "null", "true", "[5]", "{}"})
    expect_scene_refused(ball(bad), "/solids/0/radius: give metres above 0");
  for (const char* bad : {"2.5", "0", "1001", "\"7\""})
    expect_scene_refused(scene_of_solid(kBall + R"(, "rings": )" + bad),
                         "/solids/0/rings: give a whole number from 1 to 1000");
  expect_scene_refused(ball("1e-300"), "is smaller than a thousandth of a millimetre");
  expect_scene_refused(scene_of_solid(R"("kind": "box", "size": [1, 1, 5e-324])"), "/solids/0: ");
  expect_scene_refused(scene_of_solid(kBall + R"(, "scale": [1, 1, 0])"), "factors above 0");
  expect_scene_refused(
      scene_of_solid(kBall + R"(, "matrix": [[1, 0, 0, 0], [2, 0, 0, 0], [0, 0, 1, 0]])"), "flat");
  expect_scene_refused(scene_of_solid(R"("kind": "half-space", "normal": [0, 0, 1])"),
                       "/solids/0: ");
  expect_scene_refused(R"({"solids": [{"kind": "sphere", "radius": 1, "at": [91, 0]}]})",
                       "/solids/0/at/0: give a latitude");
}

TEST(HostileScene, KeysAreSaidOnce) {
  expect_scene_refused("{\"dems\": [],\n\"dems\": []}", "s.json:2: /dems: is said twice");
  expect_scene_refused(scene_of_solid(kBall + ",\n\"radius\": 2"),
                       "s.json:2: /solids/0/radius: is said twice");
}

TEST(HostileScene, WhatHasNoInsideIsRefused) {
  expect_scene_refused(
      scene_of_solid(R"("kind": "intersection", "of": [{"kind": "sphere", "radius": 1},
                        {"kind": "sphere", "radius": 1, "move": [5, 0, 0]}])"),
      "/solids/0: ");
  expect_scene_refused(scene_of_solid(R"("kind": "union", "of": [])"), "is empty: give shapes");
  expect_scene_refused(scene_of_solid(R"("kind": "torus", "radius": 1, "tube-radius": 2)"),
                       "torus");
  expect_scene_refused(
      scene_of_solid(R"("kind": "prism", "height": 1, "outline": [[0, 0], [1, 1], [2, 2]])"),
      "/solids/0: ");
}

}  // namespace
}  // namespace terrview
