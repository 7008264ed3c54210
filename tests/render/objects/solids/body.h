// Solids beside what they are, point by point: no code of the renderer.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "render/objects/solids/csg.h"
#include "render/objects/solids/solid.h"

namespace terrview {

using Long = long double;
using LongPoint = glm::vec<3, Long>;

struct Body {
  SolidPtr solid;
  std::function<bool(const LongPoint&)> contains;
  double size_m;  // about how far it reaches from its frame's origin
};

[[nodiscard]] Body sphere_body(double radius_m);
[[nodiscard]] Body box_body(const Box& box);
[[nodiscard]] Body half_space_body(const glm::dvec3& normal, double offset);
[[nodiscard]] Body frustum_body(double base_radius_m, double top_radius_m, double height_m);
[[nodiscard]] Body torus_body(double major_radius_m, double minor_radius_m);
// Over a star of that many points, which is concave.
[[nodiscard]] Body star_body(int points, double radius_m, double height_m);

[[nodiscard]] Body transformed(const Body& body, const glm::dmat4& to_parent);
[[nodiscard]] Body composed(CsgOperator op, const Body& left, const Body& right);

// A turn about a random axis, after a stretch of each axis by up to twice or half.
[[nodiscard]] glm::dmat4 turn(std::mt19937_64& engine, bool stretches = false);
[[nodiscard]] glm::dmat4 shift(const glm::dvec3& by_m);

[[nodiscard]] double real(std::mt19937_64& engine, double low, double high);
[[nodiscard]] glm::dvec3 direction(std::mt19937_64& engine);

// A primitive of each kind, of random sizes about 1.
[[nodiscard]] std::vector<Body> primitives(std::mt19937_64& engine);

// Through a point within `reach_m` of the middle, from up to `far_m` away.
[[nodiscard]] Line line_through(std::mt19937_64& engine, const glm::dvec3& middle_m, double reach_m,
                                double far_m);

[[nodiscard]] std::vector<Crossing> crossings_of(const Solid& solid, const Line& line);

[[nodiscard]] LongPoint point_of(const Line& line, Long t);

// What is wrong with the crossings of a line; nothing if they are those of the body: their number
// is even, they enter and leave by turns in order, each lies where it says to within its error,
// normals face the side they should, and points beside them are inside or outside as they tell.
[[nodiscard]] std::string fault_of(const Body& body, const Line& line, std::mt19937_64& engine);

}  // namespace terrview
