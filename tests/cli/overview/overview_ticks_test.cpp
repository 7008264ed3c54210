// One test per promise of cli/overview_ticks.h.
#include "cli/overview_ticks.h"

#include <gtest/gtest.h>

#include <memory>

#include <ogr_spatialref.h>

#include "ingest/dem.h"

namespace terrview {
namespace {

// By PROJ through OGR: where a place of UTM zone 32 lies on the Earth.
TEST(OverviewTicks, LieWherePROJHasTheirCoordinates) {
  OGRSpatialReference utm;
  OGRSpatialReference wgs84;
  ASSERT_EQ(utm.importFromEPSG(32632), OGRERR_NONE);
  ASSERT_EQ(wgs84.importFromEPSG(4326), OGRERR_NONE);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> transform(
      OGRCreateCoordinateTransformation(&utm, &wgs84));
  const PostPlacement placement{{351037.5, 5325462.5}, {{75, 0}, {0, -75}}};
  const Coordinates degrees = [&](glm::dvec2 uv) {
    glm::dvec2 at = placement.at(uv);
    transform->Transform(1, &at.x, &at.y);
    return at;
  };
  const Ticks south = ticks_along({0, 299}, {199, 299}, degrees, 6);
  EXPECT_EQ(south.axis, 0);
  EXPECT_EQ(south.step, 0.05);
  ASSERT_EQ(south.ticks.size(), 4U);  // 7.05, 7.10, 7.15, 7.20 of 7.008 to 7.207
  for (const Tick& tick : south.ticks) EXPECT_NEAR(degrees(tick.uv).x, tick.value, 1e-12);
  EXPECT_NEAR(south.ticks.front().value, 7.05, 1e-12);
  const Ticks west = ticks_along({0, 0}, {0, 299}, degrees, 6);
  EXPECT_EQ(west.axis, 1);
  for (const Tick& tick : west.ticks) EXPECT_NEAR(degrees(tick.uv).y, tick.value, 1e-12);

  const Coordinates own = [&](glm::dvec2 uv) { return placement.at(uv); };
  const Ticks metres = ticks_along({0, 299}, {199, 299}, own, 6);
  EXPECT_EQ(metres.step, 5000);
  ASSERT_EQ(metres.ticks.size(), 3U);
  EXPECT_EQ(metres.ticks[0].value, 355000);
  EXPECT_NEAR(metres.ticks[0].uv.x, (355000 - 351037.5) / 75, 1e-9);
}

TEST(OverviewTicks, AreToldInWords) {
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 0, -7.2, 0.2), "7.2° W");
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 1, 48, 0.25), "48.0° N");
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 0, -1e-12, 0.5), "0.0° E");
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 0, 180.0329, 0.0008), "179.9671° W");
  EXPECT_EQ(coordinate_text(CoordinateKind::degrees, 0, 180, 0.01), "180.00° E");
  EXPECT_EQ(coordinate_text(CoordinateKind::grid, 1, 776000, 2000), "776000 N");
  EXPECT_EQ(coordinate_text(CoordinateKind::plain, 0, -0.5, 0.1), "x -0.5");
  EXPECT_EQ(round_length(4999), 2000);
  EXPECT_EQ(round_length(5000), 5000);
  EXPECT_EQ(round_length(0.3), 0.2);
}

}  // namespace
}  // namespace terrview
