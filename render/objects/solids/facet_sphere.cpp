#include "render/objects/solids/facet_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/objects/solids/crossing.h"

namespace terrview {
namespace {

// By how much the searched shell is thicker than the surface, as a share of the radius.
constexpr double kSlack = 1e-9;

// Whether the edge between two points passes the x axis at a positive x: the same answer, to the
// last bit, in whichever order they come.
bool passes_axis(const glm::dvec2& a, const glm::dvec2& b) {
  if ((a.y > 0) == (b.y > 0)) return false;
  const glm::dvec2& low = a.y > 0 ? b : a;
  const glm::dvec2& high = a.y > 0 ? a : b;
  return low.x * high.y - high.x * low.y > 0;
}

}  // namespace

// A line against triangles, in the plane across its steepest axis.
class FacetSphere::Test {
 public:
  Test(const SphereMesh& mesh, const Line& line, Crossings& crossings)
      : mesh_(mesh), line_(line), first_(crossings.size()), crossings_(crossings) {
    // Twice: of a far origin, the first foot is not the nearest point to the last bits.
    nearest_ = nearest_to(line, glm::dvec3(0));
    const Line near{line.origin_m + nearest_ * line.direction, line.direction};
    const double rest = nearest_to(near, glm::dvec3(0));
    nearest_ += rest;
    foot_m_ = near.origin_m + rest * line.direction;
    const glm::dvec3 size = glm::abs(line.direction);
    deep_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  }

  [[nodiscard]] const glm::dvec3& foot_m() const { return foot_m_; }
  // At t from the foot.
  [[nodiscard]] glm::dvec3 at(double t) const { return foot_m_ + t * line_.direction; }

  void operator()(std::size_t triangle) {
    const SphereMesh::Triangle& t = mesh_.triangles()[triangle];
    const std::array<glm::dvec3, 3> corners{corner(t[0]), corner(t[1]), corner(t[2])};
    const std::array<glm::dvec2, 3> flat{across(corners[0]), across(corners[1]),
                                         across(corners[2])};
    const bool is_passed = passes_axis(flat[0], flat[1]) ^ passes_axis(flat[1], flat[2]) ^
                           passes_axis(flat[2], flat[0]);
    if (!is_passed) return;
    const glm::dvec3 normal =
        glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    Crossing crossing =
        crossing_at(line_, nearest_ + depth(corners, normal), normal, mesh_.corners()[0].z, true);
    crossing.part = static_cast<int>(triangle);
    crossings_.push_back(crossing);
  }

  // Puts what was found in order; two stretches may have found the same.
  void finish() {
    const auto found = crossings_.begin() + static_cast<std::ptrdiff_t>(first_);
    std::sort(found, crossings_.end(), [](const Crossing& a, const Crossing& b) {
      return std::pair(a.t, a.part) < std::pair(b.t, b.part);
    });
    const auto is_same = [](const Crossing& a, const Crossing& b) { return a.part == b.part; };
    crossings_.erase(std::unique(found, crossings_.end(), is_same), crossings_.end());
    bool enters = true;
    for (auto it = found; it != crossings_.end(); ++it) {
      it->part = 0;
      it->enters = enters;
      const double towards = glm::dot(it->normal, line_.direction);
      if (enters ? towards > 0 : towards < 0) it->normal = -it->normal;
      enters = !enters;
    }
  }

 private:
  [[nodiscard]] glm::dvec3 corner(int i) const {
    return mesh_.corners()[static_cast<std::size_t>(i)] - foot_m_;
  }
  [[nodiscard]] glm::dvec2 across(const glm::dvec3& p) const {
    const int x = (deep_ + 1) % 3;
    const int y = (deep_ + 2) % 3;
    const double share = p[deep_] / line_.direction[deep_];
    return {p[x] - share * line_.direction[x], p[y] - share * line_.direction[y]};
  }
  // Where the line passes the plane of a triangle, between its corners.
  [[nodiscard]] double depth(const std::array<glm::dvec3, 3>& corners,
                             const glm::dvec3& normal) const {
    std::array<double, 3> depths;
    for (std::size_t i = 0; i < 3; ++i) depths[i] = corners[i][deep_] / line_.direction[deep_];
    std::ranges::sort(depths);
    const double t = glm::dot(normal, corners[0]) / glm::dot(normal, line_.direction);
    return std::isfinite(t) ? std::clamp(t, depths[0], depths[2]) : depths[1];
  }

  const SphereMesh& mesh_;
  const Line& line_;
  double nearest_;     // t of the foot
  glm::dvec3 foot_m_;  // the line's point nearest to the centre
  int deep_;           // the line's steepest axis
  std::size_t first_;
  Crossings& crossings_;
};

FacetSphere::FacetSphere(double radius_m, SphereCut cut, int count)
    : radius_m_(radius_m), mesh_(radius_m, cut, count), inner_radius_m_(mesh_.inner_radius_m()) {}

Box FacetSphere::bounds() const { return {glm::dvec3(-radius_m_), glm::dvec3(radius_m_)}; }

void FacetSphere::append_crossings(const Line& line, Crossings& crossings) const {
  Test test(mesh_, line, crossings);
  const double off2_m2 = glm::dot(test.foot_m(), test.foot_m());
  const double outer_m = (1 + kSlack) * radius_m_;
  const double inner_m = (1 - kSlack) * inner_radius_m_;
  if (off2_m2 >= outer_m * outer_m) return;
  const double pace2 = glm::dot(line.direction, line.direction);
  const double outer = std::sqrt((outer_m * outer_m - off2_m2) / pace2);
  if (off2_m2 >= inner_m * inner_m) {
    test_stretch(-outer, outer, test);
  } else {
    const double inner = std::sqrt((inner_m * inner_m - off2_m2) / pace2);
    test_stretch(-outer, -inner, test);
    test_stretch(inner, outer, test);
  }
  test.finish();
}

void FacetSphere::append_crossings_of_all(const Line& line, Crossings& crossings) const {
  Test test(mesh_, line, crossings);
  for (std::size_t i = 0; i < mesh_.triangles().size(); ++i) test(i);
  test.finish();
}

void FacetSphere::test_stretch(double from, double to, Test& test) const {
  const glm::dvec3 a_m = test.at(from);
  const glm::dvec3 b_m = test.at(to);
  const double slack_m = kSlack * radius_m_;
  const int first = mesh_.band_at(std::max(a_m.z, b_m.z) + slack_m);
  const int last = mesh_.band_at(std::min(a_m.z, b_m.z) - slack_m);
  // The azimuth of a line turns one way, by up to half a circle. Near a pole it is uncertain.
  const double begin = std::atan2(a_m.y, a_m.x);
  const double turn = std::remainder(std::atan2(b_m.y, b_m.x) - begin, 2 * std::numbers::pi);
  constexpr double kNearAxis = 1e-6;
  const bool is_any =
      std::min(glm::length(glm::dvec2(a_m)), glm::length(glm::dvec2(b_m))) < kNearAxis * radius_m_;
  const double per_group = 2 * std::numbers::pi / mesh_.points();
  const double from_group = is_any ? 0 : (begin + std::min(turn, 0.0)) / per_group;
  const double to_group = is_any ? mesh_.points() : (begin + std::max(turn, 0.0)) / per_group;
  for (int band = first; band <= last; ++band) test_band(band, from_group, to_group, test);
}

// Those groups that the azimuths from one to another, in groups, may touch.
void FacetSphere::test_band(int band, double from_group, double to_group, Test& test) const {
  const int points = mesh_.points();
  const int first = static_cast<int>(std::floor(from_group - 1.5));
  const int last = std::min(static_cast<int>(std::ceil(to_group + 0.5)), first + points - 1);
  for (int i = first; i <= last; ++i) {
    const auto [begin, count] = mesh_.group(band, ((i % points) + points) % points);
    for (std::size_t k = begin; k < begin + count; ++k) test(k);
  }
}

}  // namespace terrview
