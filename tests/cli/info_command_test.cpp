// One test per promise of terrview info.
#include "cli/info_command.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "terrain/error.h"

namespace terrview {
namespace {

constexpr const char* kSample = TERRVIEW_SOURCE_DIR "/samples/vosges_like.tif";

std::string output_of(const std::vector<std::string>& args) {
  testing::internal::CaptureStdout();
  const int code = run_info(args);
  const std::string output = testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, 0);
  return output;
}

TEST(InfoCommand, JsonHoldsWhatTheDemIs) {
  const auto json = nlohmann::json::parse(output_of({kSample, "--json"}));
  ASSERT_EQ(json["dems"].size(), 1U);
  const auto& dem = json["dems"][0];
  EXPECT_EQ(dem["name"], kSample);
  EXPECT_EQ(dem["columns"], 257);
  EXPECT_NEAR(dem["spacing_m"][0].get<double>(), 60, 0.2);
  EXPECT_NEAR(dem["spacing_m"][1].get<double>(), 90, 0.2);
  EXPECT_EQ(dem["crs"]["code"], "EPSG:4326");
  EXPECT_NEAR(dem["middle"]["latitude"].get<double>(), 48, 1e-6);
  EXPECT_NEAR(dem["middle"]["longitude"].get<double>(), 7, 1e-6);
  EXPECT_EQ(dem["voids"]["open"], 0);
  ASSERT_FALSE(dem["summits"].empty());
  EXPECT_LE(dem["summits"][0]["height_m"].get<double>(), dem["highest_m"].get<double>());
}

TEST(InfoCommand, WithoutACrsPlacesAreInTheGridsOwnUnits) {
  const auto json =
      nlohmann::json::parse(output_of({kSample, "--json", "--spacing", "60,90", "--z-unit", "ft"}));
  const auto& dem = json["dems"][0];
  EXPECT_TRUE(dem["crs"].is_null());
  EXPECT_EQ(dem["height_unit"], "ft");
  EXPECT_EQ(dem["middle"]["x"], 128 * 60);
  EXPECT_FALSE(dem["middle"].contains("latitude"));
}

TEST(InfoCommand, TextNamesTheCrsAndTheSummits) {
  const std::string text = output_of({kSample, kSample});
  for (const char* part : {"257 x 257", "WGS 84 (EPSG:4326)", "summits", "48.0"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
}

TEST(InfoCommand, MistakesAreOneLine) {
  EXPECT_THROW(run_info({"none.tif"}), InputError);
  EXPECT_THROW(run_info({}), InputError);
}

}  // namespace
}  // namespace terrview
