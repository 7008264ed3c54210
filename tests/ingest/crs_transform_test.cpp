// One test per promise of ingest/crs_transform.h.
#include "ingest/crs_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <glm/geometric.hpp>

#include "terrain/error.h"

namespace terrview {
namespace {

CrsTransform transform(const std::string& crs, glm::dvec2 xy) {
  return CrsTransform("dem", crs, std::vector<glm::dvec2>{xy});
}

constexpr double dms(double degrees, double minutes, double seconds) {
  return degrees + minutes / 60 + seconds / 3600;
}

struct Row {
  const char* source;
  const char* crs;
  glm::dvec2 xy;
  double latitude_deg;
  double longitude_deg;
  double tolerance_m;  // of the published figures and the operation's accuracy
};

const std::vector<Row>& published_points() {
  static const std::vector<Row> rows{
      {"Ordnance Survey, OSTN15 test point TP01 (Helmert instead of the grid)",
       "EPSG:27700",
       {91492.146, 11318.804},
       49.92226393730,
       -6.29977752014,
       6},
      {"swisstopo, the old observatory of Bern",
       "EPSG:2056",
       {2600000, 1200000},
       dms(46, 57, 3.898),
       dms(7, 26, 19.077),
       1},
      {"EPSG guidance note 7-2, Lambert azimuthal equal area",
       "EPSG:3035",
       {3962799.45, 2999718.85},
       50,
       5,
       0.02},
      {"EPSG guidance note 7-2, polar stereographic variant B (Australian Antarctic)",
       "EPSG:3032",
       {7255380.79, 7053389.56},
       -75,
       120,
       0.02},
      {"EPSG guidance note 7-2, popular visualisation pseudo-Mercator",
       "EPSG:3857",
       {-11169055.58, 2800000.00},
       dms(24, 22, 54.433),
       -dms(100, 20, 0),
       0.05},
      {"the pole", "EPSG:3413", {0, 0}, 90, 0, 1e-3},
      {"the pole", "EPSG:3031", {0, 0}, -90, 0, 1e-3},
      {"itself, east first", "EPSG:4326", {7.1, 47.9}, 47.9, 7.1, 1e-9},
      {"the pole's easting and northing, and half a thousand kilometres south",
       "EPSG:32661",
       {2000000, 1500000},
       90 - 4.5026,
       0,
       1000},
  };
  return rows;
}

TEST(CrsTransform, AgreesWithPublishedPoints) {
  constexpr double kMetresPerDegree = 111320;
  for (const Row& row : published_points()) {
    const CrsTransform crs = transform(row.crs, row.xy);
    glm::dvec2 point = row.xy;
    crs.to_geographic({&point, 1});
    const double turns = (point.x - row.longitude_deg) * std::cos(row.latitude_deg / 57.29577951);
    EXPECT_NEAR(point.y, row.latitude_deg, row.tolerance_m / kMetresPerDegree) << row.source;
    EXPECT_NEAR(std::remainder(turns, 360), 0, row.tolerance_m / kMetresPerDegree) << row.source;
    crs.from_geographic({&point, 1});
    EXPECT_LT(glm::distance(point, row.xy), CrsTransform::kRoundTrip_m) << row.source;
  }
}

TEST(CrsTransform, AgreesWithGeographicLibInUtm) {
  const CrsTransform crs = transform("EPSG:32632", {400000, 5300000});
  for (double latitude = 40; latitude < 70; latitude += 3) {
    for (double longitude = 5; longitude < 13; longitude += 1) {
      int zone = 0;
      bool north = false;
      glm::dvec2 expected;
      GeographicLib::UTMUPS::Forward(latitude, longitude, zone, north, expected.x, expected.y, 32);
      glm::dvec2 point(longitude, latitude);
      crs.from_geographic({&point, 1});
      EXPECT_LT(glm::distance(point, expected), 1e-6);
    }
  }
}

TEST(CrsTransform, AgreesWithGeographicLibOverThePoles) {
  GeographicLib::PolarStereographic map(GeographicLib::Constants::WGS84_a(),
                                        GeographicLib::Constants::WGS84_f(), 1);
  map.SetScale(70, 1);
  const CrsTransform crs = transform("EPSG:3413", {100000, -900000});
  for (double latitude = 65; latitude < 90; latitude += 2.5) {
    for (double longitude = -180; longitude < 180; longitude += 17) {
      glm::dvec2 expected;
      map.Forward(true, latitude, longitude + 45, expected.x, expected.y);
      glm::dvec2 point(longitude, latitude);
      crs.from_geographic({&point, 1});
      EXPECT_LT(glm::distance(point, expected), 1e-5) << latitude << " " << longitude;
    }
  }
}

TEST(CrsTransform, SaysWhichOperationAndItsAccuracy) {
  const CrsTransform british = transform("EPSG:27700", {200000, 800000});
  EXPECT_EQ(british.operation().dem, "dem");
  EXPECT_NE(british.operation().name.find("British National Grid"), std::string::npos);
  ASSERT_TRUE(british.operation().accuracy_m);
  EXPECT_LE(*british.operation().accuracy_m, 5);
  EXPECT_EQ(transform("EPSG:32632", {400000, 5300000}).operation().accuracy_m, 0);
}

TEST(CrsTransform, ChoosesForThePlaceOfTheDem) {
  // The American datum of 1927 has other parameters in Alaska than in Oregon.
  const CrsTransform oregon = transform("EPSG:4267", {-121, 45});
  const CrsTransform alaska = transform("EPSG:4267", {-150, 64});
  EXPECT_NE(oregon.operation().name, alaska.operation().name);
}

TEST(CrsTransform, TakesTheHorizontalPartOfACompoundSystem) {
  glm::dvec2 compound(400000, 5300000);
  glm::dvec2 horizontal = compound;
  transform("EPSG:32632+5773", compound).to_geographic({&compound, 1});
  transform("EPSG:32632", horizontal).to_geographic({&horizontal, 1});
  EXPECT_EQ(compound, horizontal);
}

TEST(CrsTransform, RefusesABallparkOperation) {
  for (const char* crs : {"+proj=laea +lat_0=45 +R=6371000 +type=crs",
                          "+proj=utm +zone=32 +ellps=bessel +type=crs"}) {
    try {
      (void)transform(crs, {0, 0});
      FAIL() << crs;
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("ballpark"), std::string::npos) << text;
      EXPECT_NE(text.find("'dem'"), std::string::npos) << text;
    }
  }
}

TEST(CrsTransform, RefusesWhatIsNoCoordinateSystem) {
  EXPECT_THROW((void)transform("PROJCS[nonsense", {0, 0}), InputError);
  EXPECT_THROW((void)transform("EPSG:5773", {0, 0}), InputError);  // heights only
}

TEST(CrsTransform, RefusesPostsThatAreNowhere) {
  EXPECT_THROW((void)transform("EPSG:3035", {1e9, 1e9}), InputError);
}

TEST(CrsTransform, IsNaNWhereTheProjectionEnds) {
  const CrsTransform crs = transform("EPSG:3857", {0, 0});
  glm::dvec2 pole(0, 90);
  crs.from_geographic({&pole, 1});
  EXPECT_TRUE(std::isnan(pole.x) || std::abs(pole.y) > 1e8);
}

TEST(CrsTransform, KnowsTheTurnOfCylindricalSystems) {
  EXPECT_NEAR(transform("EPSG:4326", {7, 47}).turn().value(), 360, 1e-9);
  // A datum of its own, grads, a meridian of its own.
  EXPECT_NEAR(transform("EPSG:4284", {40, 55}).turn().value(), 360, 1e-9);
  EXPECT_NEAR(transform("EPSG:4807", {4, 53}).turn().value(), 400, 1e-9);
  EXPECT_NEAR(transform("EPSG:3857", {0, 0}).turn().value(), 2 * 3.14159265358979 * 6378137, 1e-5);
  EXPECT_NEAR(transform("EPSG:3832", {0, 0}).turn().value(), 2 * 3.14159265358979 * 6378137, 1e-5);
  EXPECT_FALSE(transform("EPSG:32632", {400000, 5300000}).turn());
  EXPECT_FALSE(transform("EPSG:3035", {4000000, 3000000}).turn());
  EXPECT_FALSE(transform("EPSG:3413", {100000, 500000}).turn());
  EXPECT_FALSE(transform("EPSG:2154", {900000, 6800000}).turn());
}

}  // namespace
}  // namespace terrview
