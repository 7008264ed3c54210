#include "cli/scene/scene_transform.h"

#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "terrain/error.h"

namespace terrview {
namespace {

const SceneNode::Range& distances() {
  static const SceneNode::Range range{-kFarthest_m, kFarthest_m,
                                      "metres, a million at most either way"};
  return range;
}

glm::dmat4 read_matrix(const SceneNode& node) {
  const std::vector<SceneNode> rows = node.elements(4);
  if (rows.size() < 3) node.fail("give three rows of four numbers");
  glm::dmat4 matrix(1);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::vector<double> row = rows[r].numbers(4, distances());
    for (std::size_t c = 0; c < 4; ++c)
      matrix[static_cast<glm::length_t>(c)][static_cast<glm::length_t>(r)] = row[c];
  }
  const glm::dvec4 last(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
  if (last != glm::dvec4(0, 0, 0, 1)) node.fail("the fourth row is not 0, 0, 0, 1: leave it out");
  constexpr double kFlattest = 1e-12;
  if (!(std::abs(glm::determinant(matrix)) > kFlattest))
    node.fail("makes everything flat: give a matrix that has an inverse");
  return matrix;
}

glm::dvec3 read_scale(const SceneNode& node) {
  const SceneNode::Range factors{1e-4, 1e4, "factors above 0, from 0.0001 to 10000"};
  if (node.json().is_array()) return node.vector(factors);
  return glm::dvec3(node.number(factors));
}

glm::dmat4 read_rotation(const SceneNode& node) {
  const glm::dvec3 degrees = node.vector({-360, 360, "degrees from -360 to 360"});
  glm::dmat4 matrix(1);
  for (int axis = 2; axis >= 0; --axis) {
    glm::dvec3 about(0);
    about[axis] = 1;
    matrix = glm::rotate(matrix, degrees[axis] * std::numbers::pi / 180, about);
  }
  return matrix;
}

HeightText read_height(const SceneNode& node) {
  if (node.json().is_number()) return {node.number(distances()), false};
  const std::string text = node.text();
  try {
    const HeightText height = parse_height("a height", text);
    if (height.above_ground && std::abs(height.height_m) <= kFarthest_m) return height;
  } catch (const InputError&) {
  }
  node.fail("give metres, or \"+2\" for two metres above the ground");
}

}  // namespace

double read_length_m(const SceneNode& node) {
  return node.number({0, kFarthest_m, "metres above 0, up to a million", true});
}

const std::vector<std::string>& transform_keys() {
  static const std::vector<std::string> keys{"matrix", "scale", "rotate", "move"};
  return keys;
}

glm::dmat4 read_transform(const SceneNode& node) {
  if (const auto matrix = node.find("matrix")) {
    for (const char* other : {"scale", "rotate", "move"})
      if (const auto second = node.find(other)) second->fail("is in the matrix: leave one of them");
    return read_matrix(*matrix);
  }
  glm::dmat4 transform(1);
  if (const auto move = node.find("move"))
    transform = glm::translate(transform, move->vector(distances()));
  if (const auto rotate = node.find("rotate")) transform *= read_rotation(*rotate);
  if (const auto scale = node.find("scale")) transform = glm::scale(transform, read_scale(*scale));
  return transform;
}

Target read_place(const SceneNode& node, const std::string& at, const std::string& at_xy) {
  if (node.has(at) && node.has(at_xy))
    node.at(at_xy).fail("'" + at + "' says so already: leave one of them");
  const bool is_projected = node.has(at_xy);
  if (!is_projected && !node.has(at))
    node.fail("has no place: give '" + at + "' or '" + at_xy + "'");
  const SceneNode place = node.at(is_projected ? at_xy : at);
  const std::vector<SceneNode> parts = place.elements(3);
  if (parts.size() < 2)
    place.fail(is_projected ? "give [X, Y] or [X, Y, HEIGHT]"
                            : "give [LAT, LON] or [LAT, LON, HEIGHT]");
  Target target;
  if (is_projected) {
    constexpr double kFarthest = 1e9;
    const SceneNode::Range coordinates{-kFarthest, kFarthest, "a coordinate"};
    target.projected = {parts[0].number(coordinates), parts[1].number(coordinates)};
  } else {
    target.geographic = {
        parts[0].number({-90, 90, "a latitude from -90 to 90: the order is LAT, LON"}),
        parts[1].number({-360, 360, "a longitude from -360 to 360"})};
  }
  if (parts.size() == 3) target.height = read_height(parts[2]);
  return target;
}

}  // namespace terrview
