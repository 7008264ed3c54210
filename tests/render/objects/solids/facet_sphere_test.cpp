// Promises of render/objects/solids/facet_sphere.h and sphere_mesh.h.
#include "render/objects/solids/facet_sphere.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "render/objects/solids/solid_object.h"
#include "render/objects/solids/sphere_solid.h"
#include "terrain/error.h"
#include "tests/render/objects/solids/body.h"

namespace terrview {
namespace {

struct Cut {
  SphereCut cut;
  int count;
};

constexpr Cut kCuts[] = {{SphereCut::meridians, 3},     {SphereCut::meridians, 4},
                         {SphereCut::meridians, 5},     {SphereCut::meridians, 20},
                         {SphereCut::meridians, 81},    {SphereCut::equator_disc, 1},
                         {SphereCut::equator_disc, 2},  {SphereCut::equator_disc, 3},
                         {SphereCut::equator_disc, 14}, {SphereCut::equator_disc, 30}};
constexpr Cut kFolded{SphereCut::equator_disc, 60};

using Corners = std::array<glm::dvec3, 3>;

std::vector<Corners> triangles_of(const SphereMesh& mesh) {
  std::vector<Corners> all;
  for (const SphereMesh::Triangle& t : mesh.triangles()) {
    const auto at = [&](int i) { return mesh.corners()[static_cast<std::size_t>(i)]; };
    all.push_back({at(t[0]), at(t[1]), at(t[2])});
  }
  return all;
}

// A point is inside where it is on the centre's side of the triangle that its direction passes.
Body facet_body(double radius_m, const Cut& cut) {
  auto solid = std::make_shared<FacetSphere>(radius_m, cut.cut, cut.count);
  const auto contains = [triangles = triangles_of(solid->mesh())](const LongPoint& p) {
    for (const Corners& t : triangles) {
      const LongPoint a(t[0]);
      const LongPoint b(t[1]);
      const LongPoint c(t[2]);
      const auto side = [&](const LongPoint& u, const LongPoint& v) {
        return glm::dot(glm::cross(u, v), p) >= 0;
      };
      if (side(a, b) && side(b, c) && side(c, a))
        return glm::dot(glm::cross(b - a, c - a), p - a) < 0;
    }
    return false;
  };
  return {std::move(solid), contains, radius_m};
}

TEST(SphereMesh, HasTheTrianglesOfItsCut) {
  for (const int slices : {4, 10, 20, 40, 80})
    EXPECT_EQ(SphereMesh(1, SphereCut::meridians, slices).triangles().size(),
              static_cast<std::size_t>(slices * (4 * (slices / 2 - 1) + 2)));
  for (const int circles : {1, 2, 4, 8, 14, 20})
    EXPECT_EQ(SphereMesh(1, SphereCut::equator_disc, circles).triangles().size(),
              static_cast<std::size_t>(2 * (7 + 14 * (circles - 1))));
}

TEST(SphereMesh, HasItsCornersOnTheSphereAndItsEdgesInPairs) {
  std::vector<Cut> cuts(std::begin(kCuts), std::end(kCuts));
  cuts.push_back(kFolded);
  for (const Cut& cut : cuts) {
    const SphereMesh mesh(5, cut.cut, cut.count);
    for (const glm::dvec3& corner : mesh.corners()) EXPECT_NEAR(glm::length(corner), 5, 1e-14);
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : mesh.triangles())
      for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ((edges.count({edge.second, edge.first})), 1U);
    }
    // Euler's number of a sphere.
    EXPECT_EQ(mesh.corners().size() + mesh.triangles().size(), edges.size() / 2 + 2);
  }
}

TEST(SphereMesh, FacesOutwardsUnlessItIsFolded) {
  const auto facing_inwards = [](const Cut& cut) {
    int count = 0;
    for (const Corners& t : triangles_of(SphereMesh(5, cut.cut, cut.count)))
      if (glm::dot(glm::cross(t[0], t[1]), t[2]) <= 0) ++count;
    return count;
  };
  for (const Cut& cut : kCuts) EXPECT_EQ(facing_inwards(cut), 0) << cut.count;
  EXPECT_GT(facing_inwards({SphereCut::equator_disc, 31}), 0);
}

// Rings at equal angles, so that triangles are not larger near the equator.
TEST(SphereMesh, ADiscsCirclesRiseInEqualAngles) {
  const SphereMesh mesh(1, SphereCut::equator_disc, 3);
  const double angles[] = {90, 60, 30, 0};
  for (std::size_t ring = 1; ring < 4; ++ring)
    for (std::size_t i = 0; i < 7; ++i) {
      const glm::dvec3& corner = mesh.corners()[1 + (ring - 1) * 7 + i];
      EXPECT_NEAR(corner.z, std::sin(angles[ring] * std::numbers::pi / 180), 1e-15);
      const double steps = std::atan2(corner.y, corner.x) / (2 * std::numbers::pi / 7);
      const double off = std::remainder(steps, 1);
      EXPECT_NEAR(std::abs(off), ring == 2 ? 0.5 : 0, 1e-12);
    }
}

TEST(SphereMesh, KnowsHowNearToTheCentreItComes) {
  for (const Cut& cut : kCuts) {
    const SphereMesh mesh(5, cut.cut, cut.count);
    double nearest_m = 5;
    constexpr int kSteps = 40;
    for (const Corners& t : triangles_of(mesh))
      for (int i = 0; i <= kSteps; ++i)
        for (int k = 0; i + k <= kSteps; ++k) {
          const glm::dvec3 at_m =
              t[0] + (t[1] - t[0]) * (1.0 * i / kSteps) + (t[2] - t[0]) * (1.0 * k / kSteps);
          nearest_m = std::min(nearest_m, glm::length(at_m));
        }
    EXPECT_LE(mesh.inner_radius_m(), nearest_m + 1e-12) << cut.count;
    EXPECT_GE(mesh.inner_radius_m(), nearest_m - 0.02) << cut.count;
  }
}

TEST(SphereMesh, RefusesCountsThatMakeNoSphere) {
  for (const int count : {-1, 0, 2, 1001})
    EXPECT_THROW(SphereMesh(1, SphereCut::meridians, count), InputError);
  for (const int count : {-1, 0, 1001})
    EXPECT_THROW(SphereMesh(1, SphereCut::equator_disc, count), InputError);
  EXPECT_THROW(SphereMesh(0, SphereCut::meridians, 9), InputError);
}

TEST(FacetSphere, IsCrossedAtItsFacets) {
  std::mt19937_64 engine(1);
  for (const Cut& cut : kCuts) {
    if (cut.count > 30) continue;  // the oracle looks at every triangle
    const Body body = facet_body(2, cut);
    for (int i = 0; i < 300; ++i)
      ASSERT_EQ(fault_of(body, line_through(engine, {0, 0, 0}, 2, 1e5), engine), "") << cut.count;
  }
}

std::string to_string(const Crossings& crossings) {
  std::ostringstream text;
  text.precision(17);
  for (const Crossing& c : crossings)
    text << c.t << ' ' << c.error << ' ' << c.normal.x << ' ' << c.normal.y << ' ' << c.normal.z
         << ' ' << c.part << ' ' << c.enters << '\n';
  return text.str();
}

void expect_as_by_all(const FacetSphere& sphere, const Line& line) {
  Crossings found;
  sphere.append_crossings(line, found);
  Crossings expected;
  sphere.append_crossings_of_all(line, expected);
  ASSERT_EQ(to_string(found), to_string(expected));
  ASSERT_EQ(found.size() % 2, 0U);
}

TEST(FacetSphere, IsFoundAsByTestingEveryTriangle) {
  std::mt19937_64 engine(2);
  std::vector<Cut> cuts(std::begin(kCuts), std::end(kCuts));
  cuts.push_back(kFolded);
  for (const Cut& cut : cuts) {
    const FacetSphere sphere(2, cut.cut, cut.count);
    const std::vector<glm::dvec3>& corners = sphere.mesh().corners();
    const auto corner = [&] {
      return corners[static_cast<std::size_t>(
          real(engine, 0, static_cast<double>(corners.size()) - 0.001))];
    };
    for (int i = 0; i < 300; ++i) {
      expect_as_by_all(sphere, line_through(engine, {0, 0, 0}, 2, 1e9));
      // Through corners, along edges and across the axis.
      const glm::dvec3 a_m = corner();
      const glm::dvec3 b_m = corner();
      if (a_m != b_m) expect_as_by_all(sphere, {a_m - 5.0 * (b_m - a_m), b_m - a_m});
      const glm::dvec3 way = direction(engine);
      expect_as_by_all(sphere, {a_m - std::pow(10.0, real(engine, 0, 10)) * way, way});
      expect_as_by_all(sphere, {corners[0] - way, way});
      const glm::dvec3 on_axis(0, 0, real(engine, -2, 2));
      expect_as_by_all(sphere, {on_axis - 9.0 * a_m, a_m});
      expect_as_by_all(sphere, {a_m, {0, 0, 1}});
      expect_as_by_all(sphere, {a_m, {1, 0, 0}});
    }
  }
}

TEST(FacetSphere, ManyFacetsAreNearlyASphere) {
  const FacetSphere facets(1, SphereCut::meridians, 400);
  const SphereSolid sphere(1);
  std::mt19937_64 engine(4);
  for (int i = 0; i < 2000; ++i) {
    const Line line = line_through(engine, {0, 0, 0}, 0.9, 10);
    const auto found = crossings_of(facets, line);
    const auto expected = crossings_of(sphere, line);
    ASSERT_EQ(found.size(), 2U);
    const double length = glm::length(line.direction);
    EXPECT_NEAR(found[0].t * length, expected[0].t * length, 5e-4);
    EXPECT_GT(glm::dot(found[0].normal, expected[0].normal), 0.9998);
  }
}

// Between two corners of the equator, far outside of the facets and well within the sphere.
TEST(FacetSphere, ShadowsFollowTheFacets) {
  const SolidObject facets(std::make_shared<FacetSphere>(1, SphereCut::meridians, 4));
  const SolidObject sphere(std::make_shared<SphereSolid>(1));
  const double r = 0.8 * std::sqrt(0.5);
  const Ray beside{{r, r, 9}, {0, 0, -1}};
  EXPECT_TRUE(sphere.stops(beside));
  EXPECT_FALSE(facets.stops(beside));
  const Ray at_corner{{0.95, 0, 9}, {0, 0, -1}};
  EXPECT_TRUE(facets.stops(at_corner));
}

}  // namespace
}  // namespace terrview
