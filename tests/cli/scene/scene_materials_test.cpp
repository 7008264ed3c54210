// Materials and shade trees of scene files: docs/scenes.md.
#include "cli/scene/scene_materials.h"

#include <cmath>
#include <filesystem>
#include <map>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "render/color_ramp.h"
#include "render/materials/texture.h"
#include "tests/cli/scene/scene_cases.h"
#include "tests/cli/small_picture.h"

namespace terrview {
namespace {

// Of a solid whose frame is the view's.
Material material(const std::string& members, const std::string& path = "s.json") {
  const SceneFile scene = parse_json_scene(
      R"({"solids": [{"at-xy": [0, 0, 0], "kind": "sphere", "radius": 1, "material": )" + members +
          "}]}",
      path);
  return scene.contents->solids.front().materials.front()->make(glm::dmat4(1));
}

glm::vec3 color_at(const std::string& shade, const glm::dvec3& position_m = {},
                   const std::string& path = "s.json") {
  return material("{\"color\": " + shade + "}", path).color->at({.position_m = position_m});
}

double diffuse_of(const std::string& shade) {
  return material("{\"diffuse\": " + shade + "}").diffuse->at({});
}

void expect_color(const glm::vec3& found, const glm::vec3& expected) {
  EXPECT_NEAR(glm::distance(found, expected), 0, 1e-6)
      << found.r << ' ' << found.g << ' ' << found.b;
}

TEST(SceneMaterials, WhatIsNotSaidIsPlain) {
  const Material plain = material("{}");
  EXPECT_EQ(plain.color, nullptr);
  EXPECT_EQ(plain.ambient->at({}), 1);
  EXPECT_EQ(plain.diffuse->at({}), 1);
  EXPECT_EQ(plain.specular, nullptr);
  EXPECT_EQ(plain.mirror, nullptr);
  EXPECT_EQ(plain.transparency, nullptr);
  EXPECT_EQ(plain.bump_m, nullptr);
  EXPECT_EQ(plain.model, LightModel::whitted);
  EXPECT_EQ(material(R"({"model": "guitteny", "exponent": 7})").model, LightModel::guitteny);
}

TEST(SceneMaterials, ColoursAreSrgbAndNumbersGreys) {
  expect_color(color_at("[180, 90, 30]"), from_srgb8(180, 90, 30));
  expect_color(color_at("0.25"), glm::vec3(0.25F));
  EXPECT_NEAR(diffuse_of("[255, 255, 255]"), 1, 1e-6);
  EXPECT_EQ(diffuse_of("0.25"), 0.25);
}

TEST(SceneMaterials, DisplayColoursAreTheirNumbers) {
  const SceneFile scene = parse_json_scene(
      R"({"colors": "display", "solids": [{"at-xy": [0, 0], "kind": "sphere", "radius": 1,
          "material": {"color": [51, 102, 255]}}]})",
      "s.json");
  const Material made = scene.contents->solids.front().materials.front()->make(glm::dmat4(1));
  expect_color(made.color->at({}), {0.2F, 0.4F, 1});
}

TEST(SceneMaterials, ShadesCombine) {
  EXPECT_NEAR(diffuse_of(R"({"kind": "add", "of": [0.1, 0.2, 0.4]})"), 0.7, 1e-12);
  EXPECT_NEAR(diffuse_of(R"({"kind": "multiply", "of": [0.5, 0.5, 0.5]})"), 0.125, 1e-12);
  expect_color(color_at(R"({"kind": "mix", "of": [[255, 0, 0], [0, 0, 255]], "share": 0.25})"),
               {0.75F, 0, 0.25F});
  EXPECT_NEAR(diffuse_of(R"({"kind": "fresnel", "index": 1.5})"), 0.04, 1e-9);
  EXPECT_NEAR(diffuse_of(R"({"kind": "facing"})"), 1, 1e-12);
}

TEST(SceneMaterials, TexturesAreMovedAndScaledInTheSolid) {
  const std::string checker =
      R"({"kind": "checker", "squares": [2, 2], "scale": [4, 6, 1], "move": [10, 0, 0]})";
  expect_color(color_at(checker, {10.5, 0.5, 0}), glm::vec3(0));
  expect_color(color_at(checker, {12.5, 0.5, 0}), glm::vec3(1));
  expect_color(color_at(checker, {12.5, 3.5, 0}), glm::vec3(0));
  expect_color(color_at(checker, {14.5, 0.5, 9}), glm::vec3(0));
  const std::string marble = R"({"kind": "marble", "seed": 3, "scale": 2})";
  const std::string moved = R"({"kind": "marble", "seed": 3, "scale": 2, "move": [1, 2, 3]})";
  expect_color(color_at(marble, {0.3, 0.4, 0.5}), color_at(moved, {1.3, 2.4, 3.5}));
  EXPECT_GT(glm::distance(color_at(marble, {0.3, 0.4, 0.5}), color_at(moved, {0.3, 0.4, 0.5})), 0);
}

TEST(SceneMaterials, TexturesAreThoseOfTheirKindWithTheirParameters) {
  const glm::dvec3 place(0.3, 0.4, 0.45);
  const FieldOptions field{.seed = 3, .levels = {5, 5}, .h = {0.2}};
  const std::string members = R"(", "seed": 3, "levels": 5, "smoothness": 0.2})";
  const glm::dmat4 same(1);
  const ShadingPoint there{.position_m = place};
  EXPECT_EQ(material(R"({"diffuse": {"kind": "field)" + members + "}").diffuse->at(there),
            solid_field(field, same)->at(there));
  expect_color(color_at(R"({"kind": "marble)" + members, place), marble(field, same)->at(there));
  expect_color(color_at(R"({"kind": "wood)" + members, place), wood(field, same)->at(there));
  EXPECT_NE(marble(field, same)->at(there), wood(field, same)->at(there));
}

TEST(SceneMaterials, TexturesAreMappedAsTheySay) {
  for (const auto& [word, mapping] :
       std::map<std::string, Mapping>{{"planar", Mapping::planar},
                                      {"cylindrical", Mapping::cylindrical},
                                      {"spherical", Mapping::spherical}}) {
    const Material made = material(
        R"({"diffuse": {"kind": "checker", "squares": [5, 7], "mapping": ")" + word + R"("}})");
    const ScalarShade expected = checker({5, 7}, {.mapping = mapping});
    for (int i = 0; i < 50; ++i) {
      const ShadingPoint point{.position_m = {std::cos(i), std::sin(1.7 * i), std::sin(i)}};
      EXPECT_EQ(made.diffuse->at(point), expected->at(point)) << word << ' ' << i;
    }
  }
}

class PictureOfScene : public SmallPicture {
 protected:
  static std::string scene_with_picture(const std::string& file) {
    return R"({"materials": {"a": {"color": {"kind": "picture", "file": ")" + file + "\"}}}}";
  }
};

TEST_F(PictureOfScene, LiesOnTheUnitSquareAndIsFoundBesideTheScene) {
  write_picture("two.png", "PNG", 3, GDT_Byte,
                [](int x, int, int band) { return band == 0 && 2 * x >= kWidth_px ? 255 : 0; });
  const std::string shade = R"({"kind": "picture", "file": "two.png"})";
  expect_color(color_at(shade, {0.2, 0.5, 0}, path("s.json")), {0, 0, 0});
  expect_color(color_at(shade, {0.7, 0.5, 0}, path("s.json")), {1, 0, 0});
  expect_color(color_at(shade, {1.2, 0.5, 0}, path("s.json")), {0, 0, 0});
  EXPECT_THROW(static_cast<void>(color_at(shade, {}, "s.json")), InputError);
}

TEST_F(PictureOfScene, IsBlackInItsHoles) {
  write_picture("hole.png", "PNG", 4, GDT_Byte,
                [](int x, int, int band) { return band == 3 && 2 * x >= kWidth_px ? 0 : 255; });
  const std::string shade = R"({"kind": "picture", "file": "hole.png"})";
  expect_color(color_at(shade, {0.2, 0.5, 0}, path("s.json")), {1, 1, 1});
  expect_color(color_at(shade, {0.7, 0.5, 0}, path("s.json")), {0, 0, 0});
}

TEST_F(PictureOfScene, IsAFileAndNothingElseThatGdalKnows) {
  write_picture("two.png", "PNG", 3, GDT_Byte, [](int, int, int) { return 255; });
  const std::string file = std::filesystem::absolute(path("two.png")).string();
  EXPECT_EQ(refusal_of_scene(scene_with_picture(file)), "");
  for (const std::string& name :
       {"/vsisubfile/0," + file, "vrt://" + file, std::string("/vsicurl/http://localhost/a.png"),
        std::string("<GDAL_WMS></GDAL_WMS>"), path("."), std::string()})
    expect_scene_refused(scene_with_picture(name), "/color/file: is no file: name a picture");
}

TEST(SceneMaterials, ShadesThatAreNoneAreRefused) {
  const auto refused = [](const std::string& color, const std::string& why) {
    expect_scene_refused("{\"materials\": {\"a\": {\"color\": " + color + "}}}", why);
  };
  refused("\"red\"", "/materials/a/color: give a number, a colour");
  refused("[1, 2]", "an array of 3 numbers");
  refused("[1, 2, 256]", "from 0 to 255");
  refused("1e7", "a number, a million at most");
  refused(R"({"kind": "mix", "of": [0, 1, 2], "share": 0})", "give 2 at most");
  refused(R"({"kind": "add", "of": [0]})", "give two shades");
  refused(R"({"kind": "checker", "squares": [0, 1]})", "a whole number from 1");
  refused(R"({"kind": "fresnel", "index": 0.5})", "an index of refraction");
  refused(R"({"kind": "fresnel", "index": 1.5, "scale": 2})", "nothing is called so here");
}

}  // namespace
}  // namespace terrview
