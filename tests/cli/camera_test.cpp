// Where a view stands and looks, as its camera file and its layers tell: docs/cli.md.
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <functional>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

using Json = nlohmann::json;

constexpr double kRadians = std::numbers::pi / 180;
// A ray's track stays within 0.02 of a cell's 100 m; here that shifts a hit by a few centimetres.
constexpr double kTolerance_deg = 1e-6;

class CameraOfView : public SmallView {
 protected:
  Json camera_of(const std::string& line) const {
    view(line + " --overwrite -o a.png --camera c.json");
    return json("c.json");
  }
};

TEST_F(CameraOfView, IsMadeAgainToTheByteFromItsFile) {
  for (const std::string line :
       {"--eye 48,7,+20", "--eye 48,7,+20 --z-scale 2.7", "--eye 47.985,6.99,900.1 --z-scale 1.7",
        "--eye-xy 6.991,48.003,+1.5", "--eye-xy 6.991,48.003,+1.5 --z-scale 3",
        "--heading 37.3 --pitch -7.1 --roll 12 --fov 33.3", "--look-at 48.01,7.01,+30",
        "--earth flat", "--refraction 0.2", "--shift 0.13,0.21 --heading 12",
        "--shift 0.13,0.21 --look-at 48.01,7.01", "--crop 7,5,23,31",
        "--projection cylindrical --shift 0,-0.3 --crop 7,5,23,31",
        "--projection cylindrical --fov 360",
        "--projection orthographic --width 4321.5 --pitch -30 --size 31x57"}) {
    SCOPED_TRACE(line);
    view(line + " --overwrite -o a.png --layers a.tif --camera a.json");
    view("--from-camera a.json --overwrite -o b.png --layers b.tif --camera b.json");
    EXPECT_TRUE(bytes("a.png") == bytes("b.png"));
    EXPECT_TRUE(bytes("a.tif") == bytes("b.tif"));
    EXPECT_EQ(bytes("a.json"), bytes("b.json"));
  }
}

TEST_F(CameraOfView, OfAGridWithoutCoordinatesIsMadeAgainAndFlat) {
  const std::string line = "plain.asc -q --eye-xy 100,100,+7 --size 64x48 --z-scale 1.3 ";
  ASSERT_EQ(run(words(line + "-o a.png --camera c.json")).exit_code, 0);
  EXPECT_EQ(json("c.json").at("earth"), "flat");
  EXPECT_FALSE(json("c.json").contains("refraction"));
  ASSERT_EQ(run(words("plain.asc -q --from-camera c.json -o b.png")).exit_code, 0);
  EXPECT_TRUE(bytes("a.png") == bytes("b.png"));
}

TEST_F(CameraOfView, FromAFileYieldsToTheCommandLine) {
  const Json before = camera_of("--eye 48,7,+20 --heading 100 --pitch -5 --fov 40 --roll 2");
  const auto again = [&](const std::string& line) {
    view("--from-camera c.json --overwrite -o b.png --camera d.json " + line);
    return json("d.json");
  };
  const Json narrower = again("--fov 20");
  EXPECT_EQ(narrower.at("fov"), 20);
  EXPECT_EQ(narrower.at("heading"), before.at("heading"));
  EXPECT_EQ(narrower.at("eye"), before.at("eye"));
  const Json turned = again("--heading 200");
  EXPECT_EQ(turned.at("heading"), 200);
  EXPECT_EQ(turned.at("pitch"), 0);
  EXPECT_EQ(turned.at("roll"), 2);
  const Json level = again("--projection cylindrical");
  EXPECT_EQ(level.at("heading"), 100);
  EXPECT_EQ(level.at("pitch"), 0);
  EXPECT_EQ(level.at("roll"), 0);
  EXPECT_NE(again("--look-at 48.01,7.0").at("heading"), 100);
}

TEST_F(CameraOfView, FromABadFileIsRefusedNamingTheMember) {
  const std::string eye = R"("eye": {"latitude": 48, "longitude": 7, "height_m": 900})";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "not JSON"},
      {"{", "not JSON"},
      {"[1]", "no camera"},
      {"{}", "--eye"},
      {R"({"eye": 3})", "height_m"},
      {R"({"eye": {"latitude": "x", "longitude": 7, "height_m": 900}})", "latitude"},
      {R"({"eye": {"latitude": 95, "longitude": 7, "height_m": 900}})", "latitude"},
      {"{" + eye + R"(, "heading": "north"})", "heading"},
      {"{" + eye + R"(, "size_px": [64]})", "size_px"},
      {"{" + eye + R"(, "size_px": [64, 4294967360]})", "size_px"},
      {"{" + eye + R"(, "size_px": [64, 0]})", "size_px"},
      {"{" + eye + R"(, "projection": "fisheye"})", "projection"},
      {"{" + eye + R"(, "earth": 7})", "earth"},
      {"{" + eye + R"(, "fov": 1e999})", "too large"}};
  for (const auto& [text, part] : cases) {
    SCOPED_TRACE(text);
    write_text(path("c.json"), text);
    expect_refused(run(words("hills.tif --from-camera c.json")), {part});
    EXPECT_EQ(outputs(), std::vector<std::string>{"c.json"});
  }
}

TEST_F(CameraOfView, HasPitch0WithAHeadingAlone) {
  const Json camera = camera_of("--heading -30");
  EXPECT_EQ(camera.at("heading"), -30);
  EXPECT_EQ(camera.at("pitch"), 0);
  EXPECT_EQ(camera.at("roll"), 0);
}

TEST_F(CameraOfView, KeepsTheHeadingOfLookAtWithAPitchAlone) {
  const double heading = camera_of("--look-at 48.01,7.015").at("heading");
  const Json camera = camera_of("--look-at 48.01,7.015 --pitch -.5");
  EXPECT_EQ(camera.at("heading"), heading);
  EXPECT_EQ(camera.at("pitch"), -0.5);
  EXPECT_EQ(camera_of("--pitch -10").at("heading"), camera_of("").at("heading"));
}

TEST_F(CameraOfView, TakesOptionsBelowZero) {
  TestRaster south;
  south.geotransform = {{-70, 0.001, 0, -33.9, 0, -0.001}};
  south.crs = "EPSG:4326";
  south.write(path("south.tif"));
  ASSERT_EQ(run(words("south.tif --eye -33.9015,-69.998,+2 --look-at -33.902,-69.997 --pitch -10 "
                      "--roll -1e1 -q --size 8x8 -o a.png --camera c.json"))
                .exit_code,
            0);
  const Json camera = json("c.json");
  EXPECT_EQ(camera.at("eye").at("latitude"), -33.9015);
  EXPECT_EQ(camera.at("eye").at("longitude"), -69.998);
  EXPECT_EQ(camera.at("pitch"), -10);
  EXPECT_EQ(camera.at("roll"), -10);
}

// The layers' place in the middle of a picture of odd width and height.
void expect_centre(const Layers& layers, double latitude_deg, double longitude_deg) {
  EXPECT_NEAR(layers.at("latitude", 32, 24), latitude_deg, kTolerance_deg);
  EXPECT_NEAR(layers.at("longitude", 32, 24), longitude_deg, kTolerance_deg);
}

TEST_F(CameraOfView, HasThePointThatItLooksAtInItsMiddle) {
  for (const std::string line :
       {"", "--z-scale 2", "--earth flat", "--refraction 0.4", "--roll 33", "--surface triangles",
        "--projection orthographic "
        "--width 500"}) {
    SCOPED_TRACE(line);
    view(
        "--eye 47.985,6.99,2500 --look-at 48.004,7.002 --size 65x49 --overwrite -o a.png "
        "--layers a.tif" +
        (line.empty() ? "" : " " + line));
    expect_centre(layers("a.tif"), 48.004, 7.002);
  }
}

TEST_F(CameraOfView, HasAPointGivenInTheDemsCoordinatesInItsMiddle) {
  view("--eye-xy 6.99,47.985,2500 --look-at-xy 7.002,48.004 --size 65x49 -o a.png --layers a.tif");
  expect_centre(layers("a.tif"), 48.004, 7.002);
}

TEST_F(CameraOfView, LooksAtTheMiddleOfTheDemByDefault) {
  view("--eye 47.985,6.99,2500 --size 65x49 -o a.png --layers a.tif");
  expect_centre(layers("a.tif"), 48, 7);
}

TEST_F(CameraOfView, LooksAtAHeightAboveTheGroundOrAnAbsoluteOne) {
  const double ground = camera_of("--look-at 48.004,7.002").at("pitch");
  const double above = camera_of("--look-at 48.004,7.002,+150").at("pitch");
  EXPECT_GT(above, ground + 1);
  // 900 m, as high as the eye: level, but for the Earth's drop over 2.3 km.
  EXPECT_NEAR(camera_of("--look-at 48.004,7.002,900").at("pitch"), 0, 0.02);
}

TEST_F(CameraOfView, LooksStraightDownWithNorthAtTheTop) {
  const Json camera = camera_of("--eye 48,7,2000");
  EXPECT_EQ(camera.at("pitch"), -90);
  EXPECT_EQ(camera.at("heading"), 0);
  view("--eye 48,7,2000 --fov 40 --size 65x49 -o b.png --layers b.tif");
  EXPECT_GT(layers("b.tif").at("latitude", 32, 5), 48.001);
  EXPECT_GT(layers("b.tif").at("longitude", 60, 24), 7.001);
}

// --layers .exr, by channel.
class EnuLayers {
 public:
  explicit EnuLayers(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw std::runtime_error("no layers in " + path);
    spec_ = input->spec();
    values_.resize(static_cast<std::size_t>(spec_.width * spec_.height * spec_.nchannels));
    if (!input->read_image(0, 0, 0, spec_.nchannels, OIIO::TypeFloat, values_.data()))
      throw std::runtime_error("unreadable layers in " + path);
  }
  [[nodiscard]] float at(const char* channel, int column, int row) const {
    const int index = spec_.channelindex(channel);
    if (index < 0) throw std::runtime_error(std::string("no channel ") + channel);
    return values_[static_cast<std::size_t>((row * spec_.width + column) * spec_.nchannels +
                                            index)];
  }

  // Where a pixel's hit lies, for every pixel that has one. Returns how many have.
  int for_each_hit(
      const std::function<void(int column, int row, const glm::dvec3& enu_m)>& act) const {
    int hits = 0;
    for (int row = 0; row < spec_.height; ++row)
      for (int column = 0; column < spec_.width; ++column) {
        if (std::isnan(at("distance", column, row))) continue;
        ++hits;
        act(column, row, {at("E", column, row), at("N", column, row), at("U", column, row)});
      }
    return hits;
  }

 private:
  OIIO::ImageSpec spec_;
  std::vector<float> values_;
};

TEST_F(CameraOfView, SeesEveryPlaceInTheTrueDirectionOfItsPixel) {
  view(
      "--eye 47.985,6.99,900 --heading 30 --pitch -12 --fov 70 --refraction 0 -o a.png "
      "--layers a.exr");
  const EnuLayers layers(path("a.exr"));
  const double k = std::tan(35 * kRadians) / 32;
  const int hits = layers.for_each_hit([&](int column, int row, const glm::dvec3& enu_m) {
    // Into the camera: heading, then pitch, turned back.
    const double right = enu_m.x * std::cos(30 * kRadians) - enu_m.y * std::sin(30 * kRadians);
    const double ahead = enu_m.x * std::sin(30 * kRadians) + enu_m.y * std::cos(30 * kRadians);
    const double depth = ahead * std::cos(12 * kRadians) - enu_m.z * std::sin(12 * kRadians);
    const double height = ahead * std::sin(12 * kRadians) + enu_m.z * std::cos(12 * kRadians);
    EXPECT_NEAR(right / depth / k, column + 0.5 - 32, 1e-3);
    EXPECT_NEAR(height / depth / k, 24 - row - 0.5, 1e-3);
    EXPECT_NEAR(layers.at("distance", column, row), glm::length(enu_m), 1e-2);
  });
  EXPECT_GT(hits, 1000);
}

TEST_F(CameraOfView, IsLevelAndLinearInAzimuthWhereCylindrical) {
  const Json camera = camera_of("--projection cylindrical --heading 20 --fov 90");
  EXPECT_EQ(camera.at("pitch"), 0);
  EXPECT_EQ(camera.at("roll"), 0);
  EXPECT_EQ(camera_of("--projection cylindrical --look-at 48,7").at("pitch"), 0);
  view("--projection cylindrical --heading 20 --fov 90 --refraction 0 -o b.png --layers b.exr");
  const EnuLayers layers(path("b.exr"));
  const int hits = layers.for_each_hit([](int column, int row, const glm::dvec3& enu_m) {
    const double azimuth_deg = std::atan2(enu_m.x, enu_m.y) / kRadians;
    EXPECT_NEAR(azimuth_deg, 20 + (column + 0.5 - 32) * 90 / 64, 1e-4);
    const double focal_px = 64 / (90 * kRadians);
    EXPECT_NEAR(enu_m.z / std::hypot(enu_m.x, enu_m.y), (24 - row - 0.5) / focal_px, 1e-6);
  });
  EXPECT_GT(hits, 500);
}

}  // namespace
}  // namespace terrview
