// Solids stand where the scene file says: cli/scene/place_scene.h.
#include "cli/scene/place_scene.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "ingest/dem.h"
#include "render/objects/object_set.h"
#include "render/objects/scene_objects.h"
#include "tests/cli/scene/scene_cases.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class PlacedScene : public SmallView {
 protected:
  [[nodiscard]] static ViewFrame frame_of(const std::vector<Dem>& dems, const EyePlace& eye,
                                          const ViewFrameOptions& options = {}) {
    return {dems, eye, options};
  }

  [[nodiscard]] std::vector<Dem> hills() const { return read_dems({path("hills.tif")}, {}); }

  [[nodiscard]] static std::shared_ptr<const SceneObjects> placed(const std::string& members,
                                                                  const ViewFrame& frame) {
    const SceneFile scene = parse_json_scene("{\"solids\": [{" + members + "}]}", "s.json");
    PlacedObjects objects;
    place_solids(*scene.contents, frame, objects);
    return objects.scene_objects();
  }

  // The height in the DEM's heights of the solids' top above a point; NaN beside them.
  [[nodiscard]] static double top_m(const SceneObjects& objects, const ViewFrame& frame,
                                    glm::dvec2 ground_m) {
    const auto hit =
        objects.set->first_hit({.origin_m = {ground_m, 5000}, .direction = {0, 0, -1}});
    if (!hit) return std::nan("");
    const VerticalFrame& vertical = frame.terrain()->frame();
    return vertical.at(ground_m).scene_height_m(hit->surface.position_m.z) / vertical.z_scale;
  }
};

constexpr GeoPoint kPlace{48.005, 7.008};

EyePlace eye() { return {GeoPoint{47.985, 6.985}, std::nullopt, 1200, false}; }

TEST_F(PlacedScene, StandsOnTheGroundAndTurnsClockwiseFromTrueNorth) {
  const std::vector<Dem> dems = hills();
  const ViewFrame frame = frame_of(dems, eye());
  const glm::dvec2 middle = frame.to_ground(kPlace);
  const double ground_m = frame.terrain()->ground_at(middle)->scene_height_m;
  for (const double heading_deg : {0.0, 30.0, 135.0, -60.0}) {
    const auto objects =
        placed(R"("kind": "box", "size": [4, 60, 25], "at": [48.005, 7.008, "+0"], "heading": )" +
                   std::to_string(heading_deg),
               frame);
    const auto at = [&](double bearing_deg, double distance_m) {
      const double bearing = bearing_deg * std::numbers::pi / 180;
      GeoPoint point = kPlace;
      point.latitude_deg += distance_m * std::cos(bearing) / 111'198;
      point.longitude_deg += distance_m * std::sin(bearing) / (111'320 * 0.6709);
      return top_m(*objects, frame, frame.to_ground(point));
    };
    for (const double along : {-29.0, -10.0, 0.0, 15.0, 29.0})
      EXPECT_NEAR(at(heading_deg, along), ground_m + 25, 0.01) << heading_deg << ", " << along;
    for (const double along : {-31.0, 31.0}) EXPECT_TRUE(std::isnan(at(heading_deg, along)));
    for (const double across : {-2.4, 2.4}) EXPECT_TRUE(std::isnan(at(heading_deg + 90, across)));
    for (const double across : {-1.6, 1.6})
      EXPECT_NEAR(at(heading_deg + 90, across), ground_m + 25, 0.01);
  }
}

TEST_F(PlacedScene, HeightsAreTheDemsOrAboveItsGroundHoweverItIsExaggerated) {
  const std::vector<Dem> dems = hills();
  ViewFrameOptions options;
  options.z_scale = 3;
  const ViewFrame frame = frame_of(dems, eye(), options);
  const glm::dvec2 middle = frame.to_ground(kPlace);
  const double scene_ground_m = frame.terrain()->ground_at(middle)->scene_height_m;
  const std::string tower = R"("kind": "cylinder", "radius": 5, "height": 30, )";
  const auto above = placed(tower + R"("at": [48.005, 7.008, "+12"])", frame);
  EXPECT_NEAR(3 * top_m(*above, frame, middle), scene_ground_m + 42, 1e-3);
  const auto absolute = placed(tower + R"("at": [48.005, 7.008, 800])", frame);
  EXPECT_NEAR(3 * top_m(*absolute, frame, middle), 3 * 800 + 30, 1e-3);
}

// Where what is level slopes by half a degree in the view frame, and north is not the eye's.
EyePlace far_eye() { return {GeoPoint{47.6, 6.3}, std::nullopt, 5000, false}; }

TEST_F(PlacedScene, StandsUprightFarAwayOnTheRoundEarth) {
  const std::vector<Dem> dems = hills();
  const ViewFrame frame = frame_of(dems, far_eye());
  const auto objects =
      placed(R"("kind": "box", "size": [400, 400, 25], "at": [48.005, 7.008, 700])", frame);
  const glm::dvec2 middle = frame.to_ground(kPlace);
  ASSERT_GT(glm::length(middle), 60'000);
  for (const glm::dvec2 off_m : {glm::dvec2(0), glm::dvec2(180, 0), glm::dvec2(0, -180)})
    EXPECT_NEAR(top_m(*objects, frame, middle + off_m), 725, 0.01);
}

TEST_F(PlacedScene, SpotsFarAwayAimByTheirOwnNorthAndLevel) {
  const std::vector<Dem> dems = hills();
  const ViewFrame frame = frame_of(dems, far_eye());
  const SceneFile file = parse_json_scene(
      R"({"lamps": [{"at": [48.005, 7.008, 800], "spot": {"direction": [0, 1, 0]}}]})", "s.json");
  Scene scene;
  place_light(*file.contents, frame, scene);
  const glm::dvec2 north_m = frame.to_ground({kPlace.latitude_deg + 1e-4, kPlace.longitude_deg});
  const glm::dvec3 ahead_m(north_m, frame.terrain()->frame().at(north_m).z_m(800));
  const Lamp& lamp = scene.lamps.front();
  EXPECT_NEAR(glm::distance(glm::normalize(lamp.spot->direction),
                            glm::normalize(ahead_m - lamp.position_m)),
              0, 1e-5);
}

// In the middle of a DEM around the North Pole, every way is south.
TEST_F(PlacedScene, StandsOnThePole) {
  Dem ice;
  ice.name = "ice";
  ice.grid = std::make_shared<const HeightGrid>(HeightGrid{3, 3, std::vector<float>(9, 50)});
  ice.placement = {{-1000, 1000}, glm::dmat2(1000, 0, 0, -1000)};
  ice.crs_wkt = "EPSG:3413";
  const ViewFrame frame = frame_of({ice}, {GeoPoint{89.998, 0}, std::nullopt, 90, false});
  const auto objects =
      placed(R"("kind": "cylinder", "radius": 9, "height": 7, "at": [90, 0])", frame);
  EXPECT_NEAR(top_m(*objects, frame, frame.to_ground({90, 0})), 57, 1e-3);
}

TEST_F(PlacedScene, TexturesStandWithTheirSolids) {
  const std::vector<Dem> dems = hills();
  const ViewFrame frame = frame_of(dems, eye());
  const SceneFile scene = parse_json_scene(
      R"({"materials": {"a": {"diffuse": {"kind": "checker", "squares": [1, 1], "scale": 10}}},
          "solids": [{"at": [48.005, 7.008, 700], "kind": "sphere", "radius": 9, "material": "a"},
                     {"at": [48.001, 7.002, 710], "kind": "sphere", "radius": 9, "material": "a"}]})",
      "s.json");
  PlacedObjects objects;
  place_solids(*scene.contents, frame, objects);
  const std::array<GeoPoint, 2> places{kPlace, {48.001, 7.002}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Material& material = *objects.looks[i].materials.front();
    const glm::dvec2 middle = frame.to_ground(places[i]);
    for (const glm::dvec2 off_m : {glm::dvec2(3, 4), glm::dvec2(-3, 4), glm::dvec2(-5, -2)}) {
      const double expected = off_m.x * off_m.y < 0 ? 1 : 0;
      EXPECT_EQ(material.diffuse->at({.position_m = {middle + off_m, 0}}), expected) << i;
    }
  }
}

TEST_F(PlacedScene, MapCoordinatesAreThoseOfTheFirstDem) {
  const std::vector<Dem> dems = read_dems({path("plain.asc")}, {});
  const ViewFrame frame = frame_of(dems, {std::nullopt, glm::dvec2(400, 300), 310, false});
  const auto objects =
      placed(R"("kind": "box", "size": [2, 20, 7], "at-xy": [450, 380], "heading": 90)", frame);
  EXPECT_NEAR(top_m(*objects, frame, {59, 80}), 307, 1e-9);
  EXPECT_NEAR(top_m(*objects, frame, {41, 80.9}), 307, 1e-9);
  EXPECT_TRUE(std::isnan(top_m(*objects, frame, {50, 89})));
  EXPECT_THROW(static_cast<void>(placed(R"("kind": "sphere", "radius": 1, "at": [48, 7])", frame)),
               InputError);
}

TEST_F(PlacedScene, LampsHangOverTheGroundAndSpotsAim) {
  const std::vector<Dem> dems = hills();
  const ViewFrame frame = frame_of(dems, eye());
  const SceneFile file = parse_json_scene(
      R"({"lamps": [{"at": [48.005, 7.008, "+20"], "color": [255, 0, 0], "intensity": 3,
                     "distance": 7, "spot": {"towards": [48.007, 7.008, 900], "half-angle": 90}},
                    {"at-xy": [7.008, 48.005, 800], "spot": {"direction": [0, 0, -2]}}],
          "light": {"ambient": [255, 255, 255], "background": [0, 255, 0]}})",
      "s.json");
  Scene scene;
  const glm::vec3 daylight = scene.light.sun;
  place_light(*file.contents, frame, scene);
  ASSERT_EQ(scene.lamps.size(), 2U);
  const VerticalFrame& vertical = frame.terrain()->frame();
  const auto at = [&](GeoPoint point, double height_m) {
    const glm::dvec2 ground_m = frame.to_ground(point);
    return glm::dvec3(ground_m, vertical.at(ground_m).z_m(height_m));
  };
  const double ground_m = frame.terrain()->ground_at(frame.to_ground(kPlace))->scene_height_m;
  const Lamp& first = scene.lamps[0];
  EXPECT_NEAR(glm::distance(first.position_m, at(kPlace, ground_m + 20)), 0, 1e-6);
  EXPECT_EQ(first.color, glm::vec3(1, 0, 0));
  EXPECT_EQ(first.intensity, 3);
  EXPECT_EQ(first.reference_m, 7);
  const glm::dvec3 aim = at({48.007, 7.008}, 900) - first.position_m;
  EXPECT_NEAR(glm::distance(first.spot->direction, aim), 0, 1e-6);
  EXPECT_NEAR(first.spot->half_angle_rad, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(glm::distance(scene.lamps[1].position_m, at(kPlace, 800)), 0, 1e-5);
  EXPECT_NEAR(glm::distance(glm::normalize(scene.lamps[1].spot->direction), {0, 0, -1}), 0, 1e-9);
  EXPECT_EQ(scene.light.sun, daylight);
  EXPECT_EQ(scene.light.ambient, glm::vec3(1));
  EXPECT_EQ(scene.sky.zenith, glm::vec3(0, 1, 0));
  EXPECT_EQ(scene.sky.horizon, glm::vec3(0, 1, 0));
}

TEST_F(PlacedScene, PartsHaveTheirOwnMaterialsOrTheOneAround) {
  const SceneFile scene = parse_json_scene(
      R"({"materials": {"a": {}, "b": {}},
          "shapes": {"pair": {"kind": "union", "of": [{"kind": "sphere", "radius": 1},
                                                     {"kind": "sphere", "radius": 2, "material": "b"}]}},
          "solids": [{"at-xy": [0, 0, 0], "kind": "union", "of": [
            {"kind": "shape", "name": "pair", "material": "a"}, {"kind": "shape", "name": "pair"}]}]})",
      "s.json");
  const auto& plans = scene.contents->solids.front().materials;
  ASSERT_EQ(plans.size(), 4U);
  EXPECT_NE(plans[0], nullptr);
  EXPECT_NE(plans[1], nullptr);
  EXPECT_NE(plans[0], plans[1]);
  EXPECT_EQ(plans[2], nullptr);
  EXPECT_EQ(plans[3], plans[1]);
}

}  // namespace
}  // namespace terrview
