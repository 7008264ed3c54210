// One test per promise of cli/impact/project.h, over a plain at 300 m.
#include "cli/impact/project.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "ingest/dem.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class Projects : public SmallView {
 protected:
  // A building 20 m high; `rings` are GeoJSON.
  Project project(const std::string& rings, double z_scale = 1) const {
    write_text(path("p.geojson"), R"({"type":"Feature","properties":{"height":20},"geometry":)"
                                  R"({"type":"Polygon","coordinates":)" +
                                      rings + "}}");
    ViewOptions options;
    options.dems = {path("plain.asc")};
    options.objects.buildings = {path("p.geojson")};
    options.z_scale = z_scale;
    SharedInputs inputs;
    return read_project(options, 1, read_dems(options.dems), inputs);
  }
};

bool has(const Project& project, glm::dvec2 at) {
  return std::ranges::any_of(project.roof_points, [&](const EyePlace& point) {
    return glm::distance(*point.projected, at) < 1e-6;
  });
}

TEST_F(Projects, HaveTheCornersAndTheMiddleOfARoof) {
  const Project found = project("[[[100,100],[140,100],[140,120],[100,120],[100,100]]]");
  EXPECT_EQ(found.roof_points.size(), 5U);
  EXPECT_TRUE(has(found, {140, 120}));
  EXPECT_TRUE(has(found, {120, 110}));
  for (const EyePlace& point : found.roof_points) EXPECT_NEAR(point.height_m, 320, 1e-6);
}

// The ground at 600 m of the scene, and 20 m of building that no scale makes higher.
TEST_F(Projects, HaveTheirRoofsInHeightsOfTheDemHoweverItIsExaggerated) {
  const Project found = project("[[[100,100],[140,100],[140,120],[100,120],[100,100]]]", 2);
  for (const EyePlace& point : found.roof_points) EXPECT_NEAR(point.height_m, 310, 1e-6);
}

TEST_F(Projects, ThatAreBentHaveTheirMiddleOnTheRoof) {
  const Project found =
      project("[[[100,100],[200,100],[200,110],[110,110],[110,200],[100,200],[100,100]]]");
  ASSERT_EQ(found.roof_points.size(), 7U);
  const glm::dvec2 middle = *found.roof_points.back().projected;
  EXPECT_NEAR(middle.x, 150, 1e-6);
  EXPECT_GT(middle.y, 100);
  EXPECT_LT(middle.y, 110);
}

TEST_F(Projects, WithACourtyardHaveItsCornersAndNoPointInIt) {
  const Project found = project(
      "[[[100,100],[160,100],[160,160],[100,160],[100,100]],"
      "[[110,110],[110,150],[150,150],[150,110],[110,110]]]");
  ASSERT_EQ(found.roof_points.size(), 9U);
  for (const double x : {110, 150})
    for (const double y : {110, 150}) EXPECT_TRUE(has(found, {x, y})) << x << ", " << y;
  const glm::dvec2 middle = *found.roof_points.back().projected;
  EXPECT_FALSE(middle.x > 110 && middle.x < 150 && middle.y > 110 && middle.y < 150);
  ASSERT_EQ(found.buildings.at(0).parts.size(), 1U);
  const PlanPolygon& rings = found.buildings[0].parts[0];
  ASSERT_EQ(rings.size(), 2U);
  for (const auto& ring : rings) {
    EXPECT_EQ(ring.size(), 5U);
    EXPECT_LT(glm::distance(ring.front(), ring.back()), 1e-9);
  }
}

}  // namespace
}  // namespace terrview
