// Scenes of spheres in XML: ingest/sphere_scene.h.
#include "ingest/sphere_scene.h"

#include <gtest/gtest.h>

#include <string>

#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

std::string example() {
  return read_text(TERRVIEW_SOURCE_DIR "/samples/scenes/red-sphere-meridians.xml");
}

std::string refusal_of(const std::string& text) {
  try {
    static_cast<void>(parse_sphere_scene(text, "s.xml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_refused(const std::string& text, const std::string& why) {
  const std::string said = refusal_of(text);
  EXPECT_NE(said.find(why), std::string::npos) << said;
  EXPECT_EQ(said.rfind("s.xml:", 0), 0U) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
}

TEST(SphereScene, ReadsTheExampleOfItsDocument) {
  const SphereScene scene = parse_sphere_scene(example(), "s.xml");
  ASSERT_EQ(scene.spheres.size(), 1U);
  const SphereScene::Sphere& sphere = scene.spheres.front();
  EXPECT_EQ(sphere.centre, glm::dvec3(0));
  EXPECT_EQ(sphere.color, glm::dvec3(255, 0, 0));
  EXPECT_EQ(sphere.radius, 50);
  EXPECT_EQ(sphere.mirror, 0);
  EXPECT_EQ(sphere.diffuse, 0.4);
  EXPECT_EQ(sphere.specular, 0.3);
  EXPECT_EQ(sphere.exponent, 50);
  EXPECT_EQ(sphere.surface, SphereScene::Surface::meridians);
  EXPECT_EQ(sphere.facets, 20);
  ASSERT_EQ(scene.lamps.size(), 1U);
  EXPECT_EQ(scene.lamps.front().position, glm::dvec3(500, -500, 500));
  EXPECT_EQ(scene.lamps.front().color, glm::dvec3(255));
  EXPECT_EQ(scene.lamps.front().intensity, 1);
  EXPECT_EQ(scene.eye_z, 1000);
  EXPECT_EQ(scene.window, glm::dvec3(-100, -100, 200));
  EXPECT_EQ(scene.window_size, glm::ivec2(200));
}

TEST(SphereScene, EveryTruncationIsRefusedInOneLine) {
  const std::string whole = example();
  const std::size_t end = whole.rfind("</scene>") + std::string("</scene>").size();
  for (std::size_t length = 0; length < end; ++length) expect_refused(whole.substr(0, length), "");
}

TEST(SphereScene, ComplaintsNameLineAndElement) {
  expect_refused(with(example(), "<rayon>50</rayon>", "<rayon>-1</rayon>"),
                 "s.xml:8: /scene/spheres/sphere[1]/rayon: give a number from 0");
  expect_refused(with(example(), "<rayon>50</rayon>", ""), "sphere[1]: <rayon> is missing");
  expect_refused(with(example(), "<rayon>50</rayon>", "<rayon>50</rayon><rayon>51</rayon>"),
                 "rayon: is said twice");
  expect_refused(with(example(), "<rayon>50</rayon>", "<rayon>50</rayon><radius>5</radius>"),
                 "radius: no element is called so here: give <centre>");
  expect_refused(with(example(), "<scene>", "<GDAL_WMS>"), "broken off, or no XML");
  expect_refused("<VRTDataset/>", "is no scene");
  expect_refused(with(example(), "<zchg>200", "<zchg>1000"), "the window is not before the eye");
  expect_refused(with(example(), "<inddiffusion>0.4", "<inddiffusion>0.9"), "more than 1");
  expect_refused(with(example(), "<larg>200", "<larg>2.5"), "a whole number");
  expect_refused(with(example(), "<indtriangulee>20", "<indtriangulee>2"), "from 3 to 1000");
}

TEST(SphereScene, MessagesAreShortWhateverTheNames) {
  const std::string name(1'000'000, 'n');
  EXPECT_LT(refusal_of("<" + name + "/>").size(), 500U);
  EXPECT_LT(refusal_of("<scene><" + name + "/></scene>").size(), 500U);
}

TEST(SphereScene, NumbersAreFinite) {
  for (const char* number : {"nan", "inf", "1e308", "1e999", "0x10", "5O", "", "5 0", "5<!-- -->0",
                             "&five;", "<b>5</b>"})
    expect_refused(with(example(), "<x>500</x>", std::string("<x>") + number + "</x>"), "");
}

// A thousand million of the innermost entity, if anything expanded them.
TEST(SphereScene, EntitiesAreNotExpanded) {
  std::string bomb = "<?xml version=\"1.0\"?>\n<!DOCTYPE scene [\n<!ENTITY e0 \"50\">\n";
  for (int i = 1; i < 10; ++i) {
    bomb += "<!ENTITY e" + std::to_string(i) + " \"";
    for (int k = 0; k < 10; ++k) bomb += "&e" + std::to_string(i - 1) + ";";
    bomb += "\">\n";
  }
  bomb += "]>\n<scene>&e9;</scene>\n";
  expect_refused(bomb, "has a DOCTYPE");
  expect_refused("<scene><spheres>&e9;</spheres></scene>", "has a text");
}

TEST(SphereScene, DepthAndCountsAreBounded) {
  constexpr int kDeep = 200'000;
  std::string deep;
  for (int i = 0; i < kDeep; ++i) deep += "<scene>";
  expect_refused(deep, "broken off");
  for (int i = 0; i < kDeep; ++i) deep += "</scene>";
  expect_refused(deep, "no element is called so here");
  std::string many = "<scene><spheres>";
  for (int i = 0; i <= kMostSpheres; ++i) many += "<sphere/>";
  many += "</spheres></scene>";
  expect_refused(many, "is one too many");
  expect_refused(std::string((16 << 20) + 1, ' '), "is longer than 16 MiB");
}

}  // namespace
}  // namespace terrview
