// The options of light: docs/cli.md.
#include <cmath>
#include <numbers>

#include "cli/parse.h"
#include "sky/sun_time.h"
#include "terrain/error.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

class LightOptionsOfView : public SmallView {
 protected:
  [[nodiscard]] nlohmann::json said_in(const std::string& name) const {
    const GDALDatasetUniquePtr picture(GDALDataset::Open(path(name).c_str()));
    const char* text = picture ? picture->GetMetadataItem("terrview_view") : nullptr;
    return text ? nlohmann::json::parse(text) : nlohmann::json();
  }

  // A picture's pixels, without what it says of itself.
  [[nodiscard]] std::string pixels(const std::string& line) const {
    view(line + " -o pixels.ppm --overwrite");
    return bytes("pixels.ppm");
  }
};

TEST_F(LightOptionsOfView, TimeIsTheSunAtTheEyesPlace) {
  view("--time 2026-06-21T17:00+02:00 -o a.png");
  const SunPosition sun =
      sun_at(parse_time("2026-06-21T15:00Z"), {47.985 * kRadians, 6.99 * kRadians});
  const nlohmann::json said = said_in("a.png").at("sun");
  EXPECT_NEAR(said.at("azimuth").get<double>(), sun.azimuth_rad / kRadians, 1e-9);
  EXPECT_NEAR(said.at("elevation").get<double>(), sun.elevation_rad / kRadians, 1e-9);
  EXPECT_NEAR(said.at("elevation").get<double>(), 42.7, 0.1);
  EXPECT_EQ(said.at("refracted"), false);
}

TEST_F(LightOptionsOfView, RefractionLiftsTheDrawnSunOnlyWhereItIsAskedFor) {
  view("--sun 250,2 -o a.png");
  view("--sun 250,2 --sun-refraction on -o b.png");
  const double plain = said_in("a.png").at("sun").at("elevation");
  const double lifted = said_in("b.png").at("sun").at("elevation");
  EXPECT_NEAR(plain, 2, 1e-9);
  EXPECT_GT(lifted - plain, 0.25);
  EXPECT_LT(lifted - plain, 0.35);
  EXPECT_NE(pixels("--sun 250,2"), pixels("--sun 250,2 --sun-refraction on"));
}

TEST_F(LightOptionsOfView, ASunBelowTheHorizonIsSaidAndRendersDusk) {
  const Finished finished =
      run(words("hills.tif --eye 47.985,6.99,900 --size 16x12 --sun 290,-4 -o a.png"));
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_TRUE(says(finished.err, {"4.0 degrees below the horizon", "dusk"}));
  const std::string day = pixels("--sun 290,30");
  const std::string dusk = pixels("--sun 290,-4");
  const auto brightness = [](const std::string& picture) {
    double sum = 0;
    for (const char c : picture) sum += static_cast<unsigned char>(c);
    return sum;
  };
  EXPECT_LT(brightness(dusk), 0.6 * brightness(day));
  EXPECT_GT(brightness(dusk), 0.1 * brightness(day));
}

TEST_F(LightOptionsOfView, ReliefIsLightFromTheNorthWestWithoutShadows) {
  EXPECT_EQ(pixels("--shade relief"), pixels("--sun 315,45 --no-shadows"));
  EXPECT_EQ(pixels("--shade relief --sun 300,10"), pixels("--sun 300,10 --no-shadows"));
  EXPECT_NE(pixels("--sun 300,10"), pixels("--sun 300,10 --no-shadows"));
}

TEST_F(LightOptionsOfView, SoftShadowsAreAChoice) {
  const std::string low = "--sun 250,8 --size 200x150";
  EXPECT_NE(pixels(low + " --soft-shadows"), pixels(low));
  EXPECT_EQ(pixels(low + " --soft-shadows --threads 1"),
            pixels(low + " --soft-shadows --threads 3"));
}

TEST_F(LightOptionsOfView, SkyViewAndLevelOfDetailAreChoices) {
  EXPECT_NE(pixels("--sky-view 16"), pixels(""));
  EXPECT_EQ(pixels("--sky-view 16 --threads 1"), pixels("--sky-view 16 --threads 3"));
  expect_refused(run(words("hills.tif --eye 48,7,900 --sky-view 2")), {"--sky-view", "8 to 128"});
  const std::string far = "--eye 48,7,40000 --pitch -90 --fov 20 --size 12x12 --samples 1 ";
  EXPECT_NE(pixels(far), pixels(far + "--lod off"));
  EXPECT_EQ(pixels(far), pixels(far + "--lod on"));
}

TEST_F(LightOptionsOfView, TimeNeedsAPlaceOnTheEarth) {
  expect_refused(run(words("plain.asc --eye-xy 100,100,+2 --time 2026-06-21T15:00Z")),
                 {"--time", "--sun AZ,EL", "--a-srs"});
}

TEST(ParseTime, TakesUtcAndOffsets) {
  const double day = parse_time("2003-10-17T19:30:30Z");
  EXPECT_NEAR(day, 2452930.312847, 1e-6);  // the example of the Solar Position Algorithm
  EXPECT_EQ(parse_time("2003-10-17T12:30:30-07:00"), day);
  EXPECT_EQ(parse_time("2003-10-18 01:00:30+0530"), day);
  EXPECT_EQ(parse_time("2003-10-17T20:30:30+01"), day);
  EXPECT_NEAR(parse_time("2003-10-17T19:30:30.5Z") - day, 0.5 / 86400, 1e-9);
  EXPECT_EQ(parse_time("2000-01-01T12:00Z"), 2451545);
  EXPECT_EQ(parse_time("2024-02-29T00:00Z"), 2460369.5);
}

TEST(ParseTime, RefusesWhatIsNoTime) {
  for (const char* text :
       {"", "now", "2026-06-21", "2026-06-21T15:00", "2026-06-21T15Z", "2026-02-29T15:00Z",
        "2026-13-01T15:00Z", "2026-06-21T24:00Z", "2026-06-21T15:60Z", "2026-06-21T15:00:61Z",
        "2026-06-21T15:00+15", "2026-06-21T15:00+02:60", "2026-06-21T15:00Zx", "26-06-21T15:00Z",
        "2026-06-21T15:00+2"}) {
    try {
      static_cast<void>(parse_time(text));
      ADD_FAILURE() << text << " accepted";
    } catch (const InputError& error) {
      EXPECT_TRUE(says(error.what(), {"--time", "2026-06-21T15:00Z"}));
    }
  }
}

TEST(ParseColor, IsSrgbFrom0To255MadeLinear) {
  EXPECT_EQ(parse_color("--x", "255,0,255"), glm::vec3(1, 0, 1));
  EXPECT_NEAR(parse_color("--x", "128,0,0").x, 0.2158605F, 1e-6F);
  for (const char* text : {"1,2", "256,0,0", "-1,0,0", "red"})
    EXPECT_THROW(static_cast<void>(parse_color("--x", text)), InputError);
}

}  // namespace
}  // namespace terrview
