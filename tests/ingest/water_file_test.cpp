// Lakes from vector files: ingest/water_file.h.
#include "ingest/water_file.h"

#include <gtest/gtest.h>

#include <GeographicLib/UTMUPS.hpp>
#include <cmath>

#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

std::string polygon_text(const std::vector<glm::dvec2>& corners) {
  std::string text = "[";
  for (std::size_t i = 0; i <= corners.size(); ++i) {
    const glm::dvec2& corner = corners[i % corners.size()];
    text += (i > 0 ? "," : "") + std::string("[") + std::to_string(corner.x) + "," +
            std::to_string(corner.y) + "]";
  }
  return text + "]";
}

std::string feature(const std::string& rings, const std::string& properties) {
  return R"({"type":"Feature","properties":{)" + properties +
         R"(},"geometry":{"type":"Polygon","coordinates":[)" + rings + "]}}";
}

class WaterFile : public testing::Test {
 protected:
  // 31 x 21 posts 10 m apart from (0, 0), without a system: a slope that rises by 2 m a post to the
  // east from 100 m.
  [[nodiscard]] std::vector<Dem> slope() const {
    TestRaster dem;
    dem.columns = 31;
    dem.rows = 21;
    dem.number = [](int column, int) { return 100.0 + 2 * column; };
    dem.geotransform = {{-5, 10, 0, 205, 0, -10}};
    dem.crs = "";
    return read_dems({dem.write(folder_ / "slope.tif")});
  }

  [[nodiscard]] std::string write(const std::string& features) const {
    const std::string path = folder_ / "lakes.geojson";
    write_text(path, R"({"type":"FeatureCollection","features":[)" + features + "]}");
    return path;
  }

  // A lake from (52, 52) to (148, 98): from 5.2 to 14.8 posts east.
  [[nodiscard]] std::string lake(const std::string& properties) const {
    return feature(polygon_text({{52, 52}, {148, 52}, {148, 98}, {52, 98}}), properties);
  }

  [[nodiscard]] FloodedDems flooded(const std::string& features) const {
    return flood(slope(), read_water(write(features)));
  }

  [[nodiscard]] std::string refusal_of(const std::string& features) const {
    try {
      static_cast<void>(flooded(features));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(WaterFile, IsLevelInAndAboutItsOutlineAndNothingElseMoves) {
  const FloodedDems result = flooded(lake(R"("ele":107.5)"));
  EXPECT_EQ(result.placed, 1);
  EXPECT_EQ(result.from_shore, 0);
  const HeightGrid& grid = *result.dems[0].grid;
  for (int row = 0; row < 21; ++row)
    for (int column = 0; column < 31; ++column) {
      // The rows of y = 50 to 100.
      const bool wet = column >= 5 && column <= 15 && row >= 10 && row <= 15;
      EXPECT_EQ(grid.at(column, row), wet ? 107.5F : 100.0F + 2 * static_cast<float>(column))
          << column << ' ' << row;
    }
  EXPECT_TRUE(result.lakes[0]->contain({5, 12}, {5.3, 12.5}));
  EXPECT_FALSE(result.lakes[0]->contain({5, 12}, {5.1, 12.5}));
}

TEST_F(WaterFile, WithoutALevelLiesAtTheLowerQuartileOfItsShore) {
  const FloodedDems result = flooded(lake(""));
  EXPECT_EQ(result.from_shore, 1);
  // Of 284 m of shore 46 lie at 110.4 m, and it rises by 0.2 m a metre along both sides: the lowest
  // 71 m reach 12.5 m up them. Half a post of shore is a metre high.
  EXPECT_NEAR(result.dems[0].grid->at(10, 12), 110.4 + 0.2 * 12.5, 1);
}

TEST_F(WaterFile, AroundTheWholeDemLiesAtTheLowerQuartileOfTheGround) {
  const FloodedDems result =
      flooded(feature(polygon_text({{-900, -900}, {900, -900}, {900, 900}, {-900, 900}}), ""));
  EXPECT_NEAR(result.dems[0].grid->at(3, 3), 100 + 60 / 4.0, 2);
}

TEST_F(WaterFile, LevelsComeFromTheFieldsOfGisFilesWithTheirUnits) {
  for (const std::string properties :
       {R"("level_m":90)", R"("Elevation":"90 m")", R"("water_level":90,"ele":80)",
        R"("level":"295.2755905511811 ft")"})
    EXPECT_NEAR(flooded(lake(properties)).dems[0].grid->at(10, 12), 90, 1e-4) << properties;
  EXPECT_TRUE(says(refusal_of(lake(R"("level":"high")")), {"feature 1", "'high'", "metres"}));
}

TEST_F(WaterFile, IslandsStayDry) {
  const std::string rings = polygon_text({{20, 20}, {280, 20}, {280, 180}, {20, 180}}) + "," +
                            polygon_text({{95, 65}, {165, 65}, {165, 135}, {95, 135}});
  const FloodedDems result = flooded(feature(rings, R"("level":50)"));
  const HeightGrid& grid = *result.dems[0].grid;
  EXPECT_EQ(grid.at(13, 10), 126);
  EXPECT_EQ(grid.at(11, 12), 122);
  EXPECT_EQ(grid.at(5, 10), 50);
  EXPECT_FALSE(result.lakes[0]->contain({13, 10}, {13.5, 10.5}));
  EXPECT_TRUE(result.lakes[0]->contain({5, 10}, {5.5, 10.5}));
}

TEST_F(WaterFile, FillsVoids) {
  TestRaster dem;
  dem.columns = 31;
  dem.rows = 21;
  dem.number = [](int column, int row) {
    return column > 6 && column < 12 && row > 11 && row < 14 ? -32768.0 : 120.0;
  };
  dem.nodata = -32768;
  dem.geotransform = {{-5, 10, 0, 205, 0, -10}};
  dem.crs = "";
  DemOptions options;
  options.fill_voids = false;
  const std::vector<Dem> dems = read_dems({dem.write(folder_ / "voids.tif")}, options);
  ASSERT_TRUE(std::isnan(dems[0].grid->at(9, 12)));
  const FloodedDems result = flood(dems, read_water(write(lake(""))));
  EXPECT_EQ(result.dems[0].grid->at(9, 12), 120);
}

// Corners in WGS 84 over a DEM in UTM.
TEST_F(WaterFile, OfAnotherSystemLiesWhereItIs) {
  const std::vector<Dem> dems = read_dems({TestRaster{}.write(folder_ / "utm.tif")});
  const auto degrees = [](double x, double y) {
    double latitude = 0;
    double longitude = 0;
    GeographicLib::UTMUPS::Reverse(32, true, x, y, latitude, longitude);
    return glm::dvec2(longitude, latitude);
  };
  // std::to_string keeps six digits: a decimetre.
  const std::string features = feature(
      polygon_text({degrees(400060, 5299960), degrees(400120, 5299960), degrees(400120, 5299910)}),
      R"("level":7)");
  const FloodedDems result = flood(dems, read_water(write(features)));
  ASSERT_TRUE(result.lakes[0]);
  const auto is_wet = [&](double x, double y) {
    const glm::dvec2 uv = dems[0].placement.posts({x, y});
    return result.lakes[0]->contain(glm::ivec2(uv), uv);
  };
  EXPECT_TRUE(is_wet(400062, 5299959.5));
  EXPECT_FALSE(is_wet(400058, 5299959.5));
  EXPECT_TRUE(is_wet(400119, 5299912));
  EXPECT_FALSE(is_wet(400121, 5299912));
}

TEST_F(WaterFile, WithNothingToShowIsRefused) {
  EXPECT_TRUE(says(refusal_of(feature(polygon_text({{5e4, 5e4}, {6e4, 5e4}, {6e4, 6e4}}), "")),
                   {"none of its features", "coordinate system"}));
  EXPECT_TRUE(says(refusal_of(R"({"type":"Feature","properties":{},"geometry":)"
                              R"({"type":"LineString","coordinates":[[0,0],[90,90]]}})"),
                   {"none of its features", "polygons"}));
  EXPECT_TRUE(says(refusal_of(feature("[[0,0],[90,1e300],[0,0]]", "")), {"feature 1", "nowhere"}));
}

TEST_F(WaterFile, BesideTheDemIsLeftOut) {
  const std::string far = feature(polygon_text({{5e4, 5e4}, {6e4, 5e4}, {6e4, 6e4}}), "");
  EXPECT_EQ(flooded(far + "," + lake("")).placed, 1);
}

}  // namespace
}  // namespace terrview
