#include "cli/scene/scene_shapes.h"

#include <algorithm>
#include <iterator>

#include "cli/scene/scene_transform.h"
#include "render/objects/solids/box_solid.h"
#include "render/objects/solids/csg.h"
#include "render/objects/solids/facet_sphere.h"
#include "render/objects/solids/frustum.h"
#include "render/objects/solids/half_space_solid.h"
#include "render/objects/solids/prism_solid.h"
#include "render/objects/solids/sphere_solid.h"
#include "render/objects/solids/torus.h"
#include "render/objects/solids/transformed.h"

namespace terrview {
namespace {

constexpr std::size_t kMostCorners = 10'000;

SolidPtr read_box(const SceneNode& node) {
  const glm::dvec3 size =
      node.at("size").vector({0, kFarthest_m, "metres above 0, up to a million", true});
  const Box box{{-size.x / 2, -size.y / 2, 0}, {size.x / 2, size.y / 2, size.z}};
  return node.make([&] { return std::make_shared<BoxSolid>(box); });
}

SolidPtr read_cylinder(const SceneNode& node) {
  const double radius_m = read_length_m(node.at("radius"));
  return std::make_shared<Frustum>(
      FrustumShape{radius_m, radius_m, read_length_m(node.at("height"))});
}

SolidPtr read_cone(const SceneNode& node) {
  FrustumShape shape{read_length_m(node.at("radius")), 0, read_length_m(node.at("height"))};
  if (const auto top = node.find("top-radius"))
    shape.top_radius_m = top->number({0, kFarthest_m, "metres, 0 or more"});
  return node.make([&] { return std::make_shared<Frustum>(shape); });
}

SolidPtr read_half_space(const SceneNode& node) {
  HalfSpace half{};
  half.normal = node.at("normal").vector({-1e3, 1e3, "a direction as [0, 0, 1]"});
  if (const auto offset = node.find("offset"))
    half.offset = offset->number({-kFarthest_m, kFarthest_m, "metres, a million at most"});
  return node.make([&] { return std::make_shared<HalfSpaceSolid>(half); });
}

std::vector<glm::dvec2> read_ring(const SceneNode& node) {
  const std::vector<SceneNode> corners = node.elements(kMostCorners);
  if (corners.size() < 3) node.fail("give three corners or more, as [[0, 0], [9, 0], [0, 9]]");
  std::vector<glm::dvec2> ring;
  for (const SceneNode& corner : corners) {
    const auto xy = corner.numbers(2, {-kFarthest_m, kFarthest_m, "metres, a million at most"});
    ring.emplace_back(xy[0], xy[1]);
  }
  return ring;
}

SolidPtr read_prism(const SceneNode& node) {
  std::vector<Polygon::Ring> rings{read_ring(node.at("outline"))};
  if (const auto holes = node.find("holes"))
    for (const SceneNode& hole : holes->elements(kMostCorners)) rings.push_back(read_ring(hole));
  const double height_m = read_length_m(node.at("height"));
  return node.make([&] { return std::make_shared<PrismSolid>(Polygon(rings), height_m); });
}

SolidPtr read_torus(const SceneNode& node) {
  const TorusShape shape{read_length_m(node.at("radius")), read_length_m(node.at("tube-radius"))};
  return node.make([&] { return std::make_shared<Torus>(shape); });
}

SceneShape together(CsgOperator op, SceneShape left, SceneShape right) {
  SceneShape both;
  both.depth = 1 + std::max(left.depth, right.depth);
  both.solid = std::make_shared<CsgSolid>(op, std::move(left.solid), std::move(right.solid));
  both.materials = std::move(left.materials);
  both.materials.insert(both.materials.end(), std::make_move_iterator(right.materials.begin()),
                        std::make_move_iterator(right.materials.end()));
  return both;
}

// A flat tree, whatever the number of shapes; the order of their primitives stays.
SceneShape together(CsgOperator op, std::vector<SceneShape> shapes) {
  while (shapes.size() > 1) {
    std::vector<SceneShape> pairs;
    for (std::size_t i = 0; i + 1 < shapes.size(); i += 2)
      pairs.push_back(together(op, std::move(shapes[i]), std::move(shapes[i + 1])));
    if (shapes.size() % 2 == 1) pairs.push_back(std::move(shapes.back()));
    shapes = std::move(pairs);
  }
  return std::move(shapes.front());
}

SolidPtr primitive(const SceneNode& node, const std::string& kind) {
  using Reader = SolidPtr (*)(const SceneNode&);
  static const std::map<std::string, Reader> readers{
      {"box", read_box},     {"cylinder", read_cylinder}, {"cone", read_cone},
      {"prism", read_prism}, {"torus", read_torus},       {"half-space", read_half_space}};
  return readers.at(kind)(node);
}

bool is_composed(const std::string& kind) {
  return kind == "union" || kind == "intersection" || kind == "difference";
}

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const auto& [kind, keys] : shape_keys()) names.push_back(kind);
  return names;
}

}  // namespace

const std::map<std::string, std::vector<std::string>>& shape_keys() {
  static const std::map<std::string, std::vector<std::string>> keys{
      {"sphere", {"radius", "meridians", "rings"}},
      {"box", {"size"}},
      {"cylinder", {"radius", "height"}},
      {"cone", {"radius", "top-radius", "height"}},
      {"half-space", {"normal", "offset"}},
      {"prism", {"outline", "holes", "height"}},
      {"torus", {"radius", "tube-radius"}},
      {"union", {"of"}},
      {"intersection", {"of"}},
      {"difference", {"of"}},
      {"shape", {"name"}}};
  return keys;
}

SceneShapes::SceneShapes(const std::optional<SceneNode>& shapes, const SceneMaterials& materials)
    : materials_(materials) {
  if (!shapes) return;
  for (const auto& [name, node] : shapes->members()) named_.emplace(name, Named{node});
  for (auto& [name, shape] : named_) static_cast<void>(resolved(shape, shape.node, 0));
}

SceneShape SceneShapes::read(const SceneNode& node, const std::vector<std::string>& more_keys) {
  SceneShape shape = read_at(node, more_keys, 0);
  count(shape, node);
  return shape;
}

void SceneShapes::count(const SceneShape& shape, const SceneNode& node) {
  primitives_ += std::ssize(shape.materials);
  if (primitives_ > kMostInAll)
    node.fail("with this the scene has more than " + std::to_string(kMostInAll) +
              " primitives: make it simpler");
}

SceneShape SceneShapes::read_at(const SceneNode& node, std::vector<std::string> keys, int depth) {
  const auto too_deep = [&] {
    node.fail("is nested deeper than " + std::to_string(kDeepest) + ": make it flatter");
  };
  if (depth > kDeepest) too_deep();
  const std::string kind = node.at("kind").word(kinds());
  keys.insert(keys.end(), {"kind", "material"});
  keys.insert(keys.end(), transform_keys().begin(), transform_keys().end());
  keys.insert(keys.end(), shape_keys().at(kind).begin(), shape_keys().at(kind).end());
  node.check_keys(keys);
  SceneShape shape = untransformed(node, kind, depth);
  if (shape.materials.size() > kMostPrimitives)
    node.fail("is of more than " + std::to_string(kMostPrimitives) +
              " primitives: part it into several solids");
  const glm::dmat4 transform = read_transform(node);
  if (transform != glm::dmat4(1)) {
    shape.solid = std::make_shared<Transformed>(std::move(shape.solid), transform);
    ++shape.depth;
  }
  if (shape.depth > kDeepest) too_deep();
  if (const auto material = node.find("material")) {
    const MaterialPlan plan = materials_.read(*material);
    std::replace(shape.materials.begin(), shape.materials.end(), MaterialPlan(), plan);
  }
  return shape;
}

SceneShape SceneShapes::untransformed(const SceneNode& node, const std::string& kind, int depth) {
  if (is_composed(kind)) return combined(node, kind, depth);
  if (kind == "shape") return named(node.at("name"), depth);
  return {kind == "sphere" ? sphere(node) : primitive(node, kind), {MaterialPlan()}};
}

SolidPtr SceneShapes::sphere(const SceneNode& node) {
  const double radius_m = read_length_m(node.at("radius"));
  const auto meridians = node.find("meridians");
  const auto rings = node.find("rings");
  if (!meridians && !rings) return std::make_shared<SphereSolid>(radius_m);
  if (meridians && rings) rings->fail("is another way to cut it: leave 'meridians' or this");
  constexpr int kMost = 1000;
  const auto facets = meridians ? std::make_shared<FacetSphere>(radius_m, SphereCut::meridians,
                                                                meridians->integer(3, kMost))
                                : std::make_shared<FacetSphere>(radius_m, SphereCut::equator_disc,
                                                                rings->integer(1, kMost));
  triangles_ += std::ssize(facets->mesh().triangles());
  if (triangles_ > kMostTriangles)
    node.fail("with this the scene has more than " + std::to_string(kMostTriangles) +
              " facets: give fewer meridians or rings");
  return facets;
}

SceneShape SceneShapes::combined(const SceneNode& node, const std::string& kind, int depth) {
  const SceneNode of = node.at("of");
  std::vector<SceneShape> shapes;
  std::size_t primitives = 0;
  for (const SceneNode& one : of.elements(kMostPrimitives)) {
    shapes.push_back(read_at(one, {}, depth + 1));
    primitives += shapes.back().materials.size();
    if (primitives > kMostPrimitives) break;
  }
  if (shapes.empty()) of.fail("is empty: give shapes");
  if (kind == "union") return together(CsgOperator::add, std::move(shapes));
  if (kind == "intersection") return together(CsgOperator::intersect, std::move(shapes));
  SceneShape first = std::move(shapes.front());
  shapes.erase(shapes.begin());
  if (shapes.empty()) return first;
  return together(CsgOperator::subtract, std::move(first),
                  together(CsgOperator::add, std::move(shapes)));
}

SceneShape SceneShapes::named(const SceneNode& node, int depth) {
  const std::string name = node.text();
  const auto found = named_.find(name);
  if (found != named_.end()) return resolved(found->second, node, depth);
  std::vector<std::string> names;
  for (const auto& [known, unused] : named_) names.push_back(known);
  node.fail_unknown(name, names);
}

const SceneShape& SceneShapes::resolved(Named& named, const SceneNode& by, int depth) {
  if (named.is_being_read) by.fail("a shape cannot be a part of itself: name another");
  if (!named.shape) {
    named.is_being_read = true;
    named.shape = read_at(named.node, {}, depth + 1);
    count(*named.shape, named.node);
    named.is_being_read = false;
  }
  return *named.shape;
}

}  // namespace terrview
