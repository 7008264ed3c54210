// Document: F. Guitteny, E. Le Goff & M. Lahuec, "Lancer de rayon". Its scenes as pictures.
#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "cli/scene/sphere_scene_json.h"
#include "tests/cli/small_picture.h"

namespace terrview {
namespace {

class SpherePicture : public SmallView {
 protected:
  // One ray a pixel, as in the document.
  [[nodiscard]] ReadPicture drawn(const std::string& xml) const {
    write_text(path("s.xml"), xml);
    const Finished finished = run(words("s.xml -q --overwrite --samples 1"));
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return read_picture(path("s.ppm"));
  }

  [[nodiscard]] static std::string sample(const std::string& name) {
    return read_text(TERRVIEW_SOURCE_DIR "/samples/scenes/" + name);
  }
};

std::string with(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// What the document's program computes for its example at a point of the window: part IV.
glm::dvec3 red_sphere_color(double x, double y, double ambient) {
  const glm::dvec3 eye(0, 0, 1000);
  const glm::dvec3 ray = glm::normalize(glm::dvec3(x, y, 200) - eye);
  const double b = glm::dot(ray, eye);
  const double discriminant = b * b - (glm::dot(eye, eye) - 50 * 50);
  if (discriminant < 0) return glm::dvec3(0);
  const glm::dvec3 point = eye + (-b - std::sqrt(discriminant)) * ray;
  const glm::dvec3 normal = point / 50.0;
  const glm::dvec3 to_lamp = glm::normalize(glm::dvec3(500, -500, 500) - point);
  const double facing = glm::dot(normal, to_lamp);
  glm::dvec3 color = ambient * glm::dvec3(255, 0, 0);
  if (facing < 0) return color;
  color += 0.4 * facing * glm::dvec3(255, 0, 0);
  const glm::dvec3 mirrored = 2 * facing * normal - to_lamp;
  const double shine = std::max(0.0, glm::dot(mirrored, -ray));
  color += 0.3 * std::pow(shine, 50) * glm::dvec3(255);
  return glm::min(color, glm::dvec3(255));
}

// How many components of 200 x 200 pixels are further than a step from that.
int far_off(const ReadPicture& picture, double ambient) {
  int off = 0;
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 200; ++column) {
      const glm::dvec3 expected = red_sphere_color(column + 0.5 - 100, row + 0.5 - 100, ambient);
      const auto& found = picture.colors[static_cast<std::size_t>(row * 200 + column)];
      for (int i = 0; i < 3; ++i)
        if (std::abs(found[i] - expected[i]) > 1) ++off;
    }
  return off;
}

TEST_F(SpherePicture, TheExampleIsWhatTheDocumentComputes) {
  const ReadPicture picture = drawn(sample("red-sphere.xml"));
  ASSERT_EQ(picture.width_px, 200);
  ASSERT_EQ(picture.height_px, 200);
  EXPECT_EQ(far_off(picture, 0.3), 0);
}

// A mirror takes its share from the ambient light, and shows nothing instead where it sees nothing.
TEST_F(SpherePicture, AMirrorThatSeesTheBackgroundAloneKeepsItsColour) {
  const std::string mirror = with(sample("red-sphere.xml"), "<indmiroir>0<", "<indmiroir>0.2<");
  EXPECT_EQ(far_off(drawn(mirror), 0.1), 0);
}

bool is_sphere(const glm::ivec4& color) { return color.r > 0; }

TEST_F(SpherePicture, TrianglesLieWithinThePerfectSphere) {
  const ReadPicture perfect = drawn(sample("red-sphere.xml"));
  for (const char* name : {"red-sphere-meridians.xml", "red-sphere-equator.xml"}) {
    const ReadPicture facets = drawn(sample(name));
    int inside = 0;
    int outside = 0;
    int missing = 0;
    for (std::size_t i = 0; i < perfect.colors.size(); ++i) {
      if (is_sphere(facets.colors[i]) && is_sphere(perfect.colors[i])) ++inside;
      if (is_sphere(facets.colors[i]) && !is_sphere(perfect.colors[i])) ++outside;
      if (!is_sphere(facets.colors[i]) && is_sphere(perfect.colors[i])) ++missing;
    }
    EXPECT_EQ(outside, 0) << name;
    EXPECT_GT(missing, 10) << name;
    EXPECT_LT(missing, inside / 10) << name;
  }
}

TEST(SphereSceneJson, LeavesTheAmbientLightNothingWhereTheOthersTakeMoreThanAll) {
  SphereScene scene;
  scene.window_size = {10, 10};
  SphereScene::Sphere sphere{};
  sphere.mirror = 0.5;
  sphere.diffuse = 0.25;
  sphere.specular = 0.125;
  scene.spheres.push_back(sphere);
  sphere.specular = 0.5;
  scene.spheres.push_back(sphere);
  const SceneJson json = sphere_scene_json(scene);
  EXPECT_EQ(json["solids"][0]["material"]["ambient"], 0.125);
  EXPECT_EQ(json["solids"][1]["material"]["ambient"], 0);
}

// The big sphere alone is green.
TEST_F(SpherePicture, TheShadowIsThatOfTheFacets) {
  const std::string facets = sample("facet-shadow.xml");
  const std::string perfect = with(facets, "<triangulee>1", "<triangulee>0");
  const std::string none = with(facets, "<rayon>42", "<rayon>0.001");
  const ReadPicture of_facets = drawn(facets);
  const ReadPicture of_perfect = drawn(perfect);
  const ReadPicture lit = drawn(none);
  int both = 0;
  int perfect_alone = 0;
  int facets_alone = 0;
  for (std::size_t i = 0; i < lit.colors.size(); ++i) {
    const auto is_green = [i](const ReadPicture& picture) {
      return picture.colors[i].g > picture.colors[i].b;
    };
    if (!is_green(lit) || !is_green(of_facets) || !is_green(of_perfect)) continue;
    const bool in_facets = of_facets.colors[i].g < lit.colors[i].g;
    const bool in_perfect = of_perfect.colors[i].g < lit.colors[i].g;
    both += in_facets && in_perfect;
    perfect_alone += in_perfect && !in_facets;
    facets_alone += in_facets && !in_perfect;
  }
  EXPECT_GT(both, 300);
  EXPECT_GT(perfect_alone, 30);
  EXPECT_EQ(facets_alone, 0);
}

// The red sphere, to the left, on the green one.
TEST_F(SpherePicture, MirrorsShowTheSpheresBesideThem) {
  for (const char* name : {"mirror-spheres.xml", "mirror-spheres-meridians.xml"}) {
    const std::string text = sample(name);
    const ReadPicture mirrors = drawn(text);
    const ReadPicture dull = drawn(with(text, "<indmiroir>0.4", "<indmiroir>0"));
    int red_on_green = 0;
    for (std::size_t i = 0; i < dull.colors.size(); ++i)
      if (dull.colors[i].g > dull.colors[i].r + 30 && mirrors.colors[i].r > mirrors.colors[i].g)
        ++red_on_green;
    EXPECT_GT(red_on_green, 50) << name;
  }
}

TEST_F(SpherePicture, PpmIsTheDefaultAndAnyFormatWillDo) {
  write_text(path("s.xml"), sample("red-sphere.xml"));
  EXPECT_EQ(run(words("s.xml -q --size 20x20")).exit_code, 0);
  EXPECT_EQ(bytes("s.ppm").substr(0, 2), "P6");
  EXPECT_EQ(run(words("s.xml -q --size 20x20 -o s.png")).exit_code, 0);
  EXPECT_EQ(bytes("s.png").substr(1, 3), "PNG");
  EXPECT_EQ(run(words("s.xml -q --size 20x20 --of JPEG")).exit_code, 0);
  EXPECT_EQ(bytes("s.jpeg").substr(0, 2), "\xff\xd8");
}

}  // namespace
}  // namespace terrview
