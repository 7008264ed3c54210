// --water and --colors natural: docs/cli.md.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cli/small_picture.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class WaterOfView : public SmallView {
 protected:
  // A lake over the eastern half of plain.asc, at its very height.
  WaterOfView() {
    write_text(path("lake.geojson"),
               R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
                "geometry":{"type":"Polygon","coordinates":
                [[[400,-50],[900,-50],[900,700],[400,700],[400,-50]]]}}]})");
  }

  void look_down(const std::string& options) const {
    ASSERT_EQ(run(words("plain.asc -q --eye-xy 400,300,600 --heading 0 --pitch -90 --fov 40 --size "
                        "64x48 --visibility inf --samples 1 --overwrite " +
                        options))
                  .exit_code,
              0);
  }

  [[nodiscard]] nlohmann::json said_in(const std::string& name) const {
    const GDALDatasetUniquePtr picture(GDALDataset::Open(path(name).c_str()));
    const char* text = picture ? picture->GetMetadataItem("terrview_view") : nullptr;
    return text ? nlohmann::json::parse(text) : nlohmann::json();
  }
};

TEST_F(WaterOfView, LiesWhereItsPolygonsLie) {
  look_down("--water lake.geojson --water-color 0,0,255 -o seen.png");
  const ReadPicture seen = read_picture(path("seen.png"));
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column) {
      const glm::ivec4 color = seen.colors[static_cast<std::size_t>(row * 64 + column)];
      EXPECT_EQ(color.b > 2 * color.g, column >= 32) << column << ' ' << row;
    }
  EXPECT_EQ(said_in("seen.png").at("water").at("file"), "lake.geojson");
}

TEST_F(WaterOfView, IsSeenAtItsLevelInTheLayers) {
  look_down("--water 350 --layers water.tif -o seen.png");
  const Layers water = layers("water.tif");
  EXPECT_NEAR(water.at("height_m", 10, 10), 350, 1e-6);
  EXPECT_EQ(water.at("object_id", 10, 10), 0);
  EXPECT_NEAR(water.at("distance_m", 32, 24), 250, 1);
  EXPECT_EQ(said_in("seen.png").at("water").at("level_m"), 350);
}

TEST_F(WaterOfView, CostsNoByteWhereThereIsNone) {
  look_down("-o dry.png");
  look_down("--water 299.9 -o below.ppm");
  look_down("-o dry.ppm");
  EXPECT_EQ(bytes("below.ppm"), bytes("dry.ppm"));
  EXPECT_FALSE(said_in("dry.png").contains("water"));
}

TEST_F(WaterOfView, ThatCannotBeIsRefused) {
  const auto refused = [&](const std::string& options, const std::vector<std::string>& parts) {
    expect_refused(run(words("plain.asc -q --eye-xy 400,300,600 -o a.png " + options)), parts);
  };
  refused("--water 650", {"--water", "50.000 m under the water"});
  refused("--water nan", {"--water nan", "metres"});
  refused("--water 1 --water 2", {"--water 2", "second level"});
  refused("--water none.geojson", {"none.geojson"});
  refused("--water plain.asc", {"plain.asc"});
  refused("--water-color 1,2,3", {"--water-color", "--water"});
  refused("--water lake.geojson --stats lake.geojson", {"lake.geojson", "is read by this view"});
}

TEST_F(WaterOfView, NaturalColorsAreRecordedWithTheirLines) {
  look_down("--colors natural --snow-line 200 -o white.png");
  const ReadPicture white = read_picture(path("white.png"));
  EXPECT_GT(white.colors[100].g, 170);
  look_down("--colors natural --rock-slope 30 -o green.png");
  const ReadPicture green = read_picture(path("green.png"));
  EXPECT_GT(green.colors[100].g, green.colors[100].b + 30);
  const nlohmann::json natural = said_in("green.png").at("colors").at("natural");
  EXPECT_EQ(natural.at("snow_line_m"), 2800);
  EXPECT_NEAR(natural.at("rock_slope_deg").get<double>(), 30, 1e-9);
  expect_refused(run(words("plain.asc --eye-xy 400,300,600 -o a.png --snow-line 10")),
                 {"--snow-line", "--colors natural"});
}

}  // namespace
}  // namespace terrview
