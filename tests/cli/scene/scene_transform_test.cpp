// One test per promise of cli/scene/scene_transform.h.
#include "cli/scene/scene_transform.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "tests/cli/scene/scene_cases.h"

namespace terrview {
namespace {

glm::dvec3 moved(const std::string& members, const glm::dvec3& point) {
  const JsonText text("s.json", members);
  return glm::dvec3(read_transform(SceneNode(text)) * glm::dvec4(point, 1));
}

void expect_point(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_NEAR(glm::distance(found, expected), 0, 1e-12)
      << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(SceneTransform, ScalesThenTurnsThenMoves) {
  expect_point(
      moved(R"({"move": [10, 20, 30], "rotate": [90, 0, 0], "scale": [2, 3, 4]})", {1, 1, 1}),
      {12, 16, 33});
  expect_point(moved(R"({"scale": 2})", {1, 2, 3}), {2, 4, 6});
  expect_point(moved("{}", {1, 2, 3}), {1, 2, 3});
}

TEST(SceneTransform, TurnsAboutXThenYThenZAnticlockwise) {
  expect_point(moved(R"({"rotate": [90, 0, 0]})", {0, 1, 0}), {0, 0, 1});
  expect_point(moved(R"({"rotate": [0, 90, 0]})", {0, 0, 1}), {1, 0, 0});
  expect_point(moved(R"({"rotate": [0, 0, 90]})", {1, 0, 0}), {0, 1, 0});
  expect_point(moved(R"({"rotate": [90, 90, 0]})", {0, 1, 0}), {1, 0, 0});
  expect_point(moved(R"({"rotate": [0, 90, 90]})", {0, 0, 1}), {0, 1, 0});
}

TEST(SceneTransform, OfAMatrixIsItsRows) {
  const std::string rows = "[0, 2, 0, 5], [1, 0, 0, 6], [0, 0, 3, 7]";
  expect_point(moved("{\"matrix\": [" + rows + "]}", {1, 10, 100}), {25, 7, 307});
  expect_point(moved("{\"matrix\": [" + rows + ", [0, 0, 0, 1]]}", {1, 10, 100}), {25, 7, 307});
  const auto refused = [](const std::string& members, const std::string& why) {
    expect_scene_refused(scene_of_solid(R"("kind": "sphere", "radius": 1, )" + members), why);
  };
  refused("\"matrix\": [" + rows + ", [0, 0, 1, 1]]", "matrix: the fourth row is not 0, 0, 0, 1");
  refused("\"matrix\": [" + rows + "], \"move\": [0, 0, 1]", "move: is in the matrix");
}

TEST(ScenePlace, HasAHeightOrOneAboveTheGround) {
  const auto place = [](const std::string& at) {
    const JsonText text("s.json", "{\"at\": " + at + "}");
    return read_place(SceneNode(text), "at", "at-xy");
  };
  EXPECT_EQ(place("[48, 7, 12.5]").height.height_m, 12.5);
  EXPECT_FALSE(place("[48, 7, 12.5]").height.above_ground);
  EXPECT_EQ(place("[48, 7, \"+2\"]").height.height_m, 2);
  EXPECT_TRUE(place("[48, 7, \"+2\"]").height.above_ground);
  EXPECT_EQ(place("[48, 7]").height.height_m, 0);
  EXPECT_TRUE(place("[48, 7]").height.above_ground);
  for (const char* bad : {"\"12\"", "\"+2e6\"", "\"high\"", "2e6"})
    EXPECT_THROW(static_cast<void>(place("[48, 7, " + std::string(bad) + "]")), InputError) << bad;
}

}  // namespace
}  // namespace terrview
