#include "ingest/sphere_scene.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include <pugixml.hpp>

#include "ingest/shortened.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr std::size_t kLongest_bytes = std::size_t{16} << 20;
constexpr double kFarthest = 1e6;
constexpr int kMostPixels = 20'000;

std::string_view trimmed(std::string_view text) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return "";
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// A text, to tell lines by.
struct Source {
  const std::string& name;
  const std::string& text;

  [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& what) const {
    const auto end = text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text));
    throw InputError(name + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')) + ": " +
                     what);
  }
};

// An element and its path.
class Element {
 public:
  Element(const Source& source, pugi::xml_node node, std::string path)
      : source_(&source), node_(node), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& what) const {
    source_->fail(node_.offset_debug(), shortened(path_) + ": " + what);
  }

  // Only these elements may be in it, and text only if there are none.
  void allow(std::initializer_list<std::string_view> names) const {
    for (const pugi::xml_node child : node_.children()) {
      const bool is_text = child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata;
      if (is_text && names.size() > 0) fail("has a text: give elements alone");
      if (child.type() == pugi::node_element &&
          std::find(names.begin(), names.end(), child.name()) == names.end())
        inside(child).fail("no element is called so here: give " + listed(names));
    }
  }

  // The one of that name.
  [[nodiscard]] Element at(const char* name) const {
    const pugi::xml_node child = node_.child(name);
    if (!child) fail(std::string("<") + name + "> is missing: add it");
    if (const pugi::xml_node second = child.next_sibling(name))
      inside(second).fail("is said twice: leave one");
    return inside(child);
  }

  [[nodiscard]] std::vector<Element> all(const char* name, int most) const {
    std::vector<Element> elements;
    for (const pugi::xml_node child : node_.children(name)) {
      elements.push_back(inside(child));
      elements.back().path_ += "[" + std::to_string(elements.size()) + "]";
      if (std::ssize(elements) > most)
        elements.back().fail("is one too many: give " + std::to_string(most) + " at most");
    }
    return elements;
  }

  [[nodiscard]] double number(double lowest, double highest) const {
    allow({});
    const std::string_view text = trimmed(node_.text().get());
    const bool is_whole = node_.first_child() == node_.last_child();
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = is_whole && error == std::errc() && end == text.data() + text.size() &&
                           std::isfinite(value);
    if (!is_number || value < lowest || value > highest)
      fail("give a number from " + words(lowest) + " to " + words(highest));
    return value;
  }

  [[nodiscard]] int integer(int lowest, int highest) const {
    const double value = number(lowest, highest);
    if (value != std::floor(value)) fail("give a whole number");
    return static_cast<int>(value);
  }

  [[nodiscard]] glm::dvec3 numbers(const char* x, const char* y, const char* z, double lowest,
                                   double highest) const {
    allow({x, y, z});
    return {at(x).number(lowest, highest), at(y).number(lowest, highest),
            at(z).number(lowest, highest)};
  }

  [[nodiscard]] glm::dvec3 point() const { return numbers("x", "y", "z", -kFarthest, kFarthest); }
  [[nodiscard]] glm::dvec3 color() const { return numbers("r", "g", "b", 0, 255); }

 private:
  [[nodiscard]] Element inside(pugi::xml_node child) const {
    return {*source_, child, path_ + "/" + child.name()};
  }

  static std::string words(double value) {
    std::string text = std::to_string(value);
    return text.substr(0, text.find('.'));
  }

  static std::string listed(std::initializer_list<std::string_view> names) {
    std::string list;
    for (const std::string_view name : names)
      list += (list.empty() ? "<" : ", <") + std::string(name) + ">";
    return list.empty() ? "a number alone" : list;
  }

  const Source* source_;
  pugi::xml_node node_;
  std::string path_;
};

SphereScene::Sphere read_sphere(const Element& element) {
  element.allow({"centre", "couleursph", "rayon", "indmiroir", "inddiffusion", "indspeculaire",
                 "indrugosite", "triangulee", "indtriangulee"});
  SphereScene::Sphere sphere{};
  sphere.centre = element.at("centre").point();
  sphere.color = element.at("couleursph").color();
  sphere.radius = element.at("rayon").number(0, kFarthest);
  if (sphere.radius == 0) element.at("rayon").fail("give a number above 0");
  sphere.mirror = element.at("indmiroir").number(0, 1);
  sphere.diffuse = element.at("inddiffusion").number(0, 1);
  sphere.specular = element.at("indspeculaire").number(0, 1);
  constexpr double kRounding = 1e-9;
  if (sphere.mirror + sphere.diffuse + sphere.specular > 1 + kRounding)
    element.fail("indmiroir, inddiffusion and indspeculaire are more than 1 together: lower them");
  sphere.exponent = element.at("indrugosite").number(0, 100);
  sphere.surface = static_cast<SphereScene::Surface>(element.at("triangulee").integer(0, 2));
  const bool is_perfect = sphere.surface == SphereScene::Surface::perfect;
  const int fewest = sphere.surface == SphereScene::Surface::meridians ? 3 : 1;
  sphere.facets = element.at("indtriangulee").integer(is_perfect ? 0 : fewest, kMostFacets);
  return sphere;
}

SphereScene::Lamp read_lamp(const Element& element) {
  element.allow({"point", "couleur", "intensite"});
  return {element.at("point").point(), element.at("couleur").color(),
          element.at("intensite").number(0, 1)};
}

SphereScene read_scene(const Element& root) {
  root.allow({"spheres", "srclums", "obs", "fenetre"});
  SphereScene scene;
  const Element spheres = root.at("spheres");
  spheres.allow({"sphere"});
  for (const Element& sphere : spheres.all("sphere", kMostSpheres))
    scene.spheres.push_back(read_sphere(sphere));
  const Element lamps = root.at("srclums");
  lamps.allow({"srclum"});
  for (const Element& lamp : lamps.all("srclum", kMostSphereLamps))
    scene.lamps.push_back(read_lamp(lamp));
  const Element eye = root.at("obs");
  eye.allow({"prof"});
  scene.eye_z = eye.at("prof").number(-kFarthest, kFarthest);
  const Element window = root.at("fenetre");
  window.allow({"chg", "larg", "haut"});
  const Element corner = window.at("chg");
  scene.window = corner.numbers("xchg", "ychg", "zchg", -kFarthest, kFarthest);
  if (scene.window.z >= scene.eye_z)
    corner.at("zchg").fail("the window is not before the eye: give less than prof");
  scene.window_size = {window.at("larg").integer(1, kMostPixels),
                       window.at("haut").integer(1, kMostPixels)};
  return scene;
}

}  // namespace

SphereScene parse_sphere_scene(const std::string& text, const std::string& name) {
  const Source source{name, text};
  if (text.size() > kLongest_bytes)
    source.fail(0, "is longer than " + std::to_string(kLongest_bytes >> 20) + " MiB: part it");
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(
      text.data(), text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  if (result.status == pugi::status_no_document_element)
    source.fail(0, "holds no element: give <scene>...</scene>");
  if (!result) source.fail(result.offset, "broken off, or no XML: check the tags up to here");
  for (const pugi::xml_node child : document.children())
    if (child.type() == pugi::node_doctype)
      source.fail(child.offset_debug(), "has a DOCTYPE: leave it out, and any entities");
  const pugi::xml_node root = document.document_element();
  const Element element(source, root, std::string("/") + root.name());
  if (std::string_view(root.name()) != "scene")
    element.fail("is no scene: give <scene>, or name a DEM after `terrview view`");
  if (root.next_sibling())
    source.fail(root.next_sibling().offset_debug(), "goes on after </scene>: leave that out");
  return read_scene(element);
}

}  // namespace terrview
