// Whether things are drawn where a theodolite would see them: directions of the view frame against
// geocentric coordinates, refraction off unless said.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include <GeographicLib/Geodesic.hpp>

#include "ingest/view_frame.h"
#include "terrain/view_transform.h"
#include "tests/ingest/geodesy_cases.h"
#include "tests/ingest/test_raster.h"
#include "tests/ingest/true_earth.h"

namespace terrview {
namespace {

using cases::GridCase;
using true_earth::Place;

// A tenth of a pixel of a picture 1920 wide that spans 60 degrees.
constexpr double kTenthOfPixel_rad = 6e-5;
constexpr double kDegrees = 180 / std::numbers::pi;

const ViewFrameOptions kNoRefraction{.refraction = 0};

std::vector<GridCase> wide_grids() {
  return {{"geographic", "EPSG:4326", {6.3, 48.7}, 1.0 / 300, {400, 300}, {0.2, 0.8}},
          {"UTM", "EPSG:32632", {300000, 5400000}, 250, {400, 400}, {0.1, 0.2}},
          {"British grid", "EPSG:27700", {160000, 900000}, 250, {400, 400}, {0.5, 0.5}},
          {"polar stereographic", "EPSG:3413", {-80000, 70000}, 250, {400, 400}, {0.3, 0.9}}};
}

// A view from above the ground of `grid`.
struct View {
  explicit View(const GridCase& grid, double eye_height_m = 3500,
                const ViewFrameOptions& options = kNoRefraction)
      : dem(cases::dem(grid)),
        crs(cases::transform(grid)),
        eye_point(cases::eye_point(grid, *crs)),
        frame({dem}, {.geographic = eye_point, .projected = {}, .height_m = eye_height_m}, options),
        eye{eye_point.latitude_deg, eye_point.longitude_deg, eye_height_m} {}

  // Where the view frame has a point of this height.
  [[nodiscard]] glm::dvec3 drawn(glm::dvec2 ground_m, double height_m) const {
    return {ground_m, frame.terrain()->frame().at(ground_m).z_m(height_m)};
  }

  Dem dem;
  std::shared_ptr<const CrsTransform> crs;
  GeoPoint eye_point;
  ViewFrame frame;
  Place eye;
};

class TrueDirections : public testing::TestWithParam<GridCase> {};

TEST_P(TrueDirections, OfAThousandPosts) {
  const View view(GetParam());
  const cases::Oracle oracle(GetParam(), view.eye_point);
  std::mt19937 random(11);
  double worst_rad = 0;
  for (int found = 0; found < 1000;) {
    const int column = static_cast<int>(random() % static_cast<unsigned>(GetParam().posts.x));
    const int row = static_cast<int>(random() % static_cast<unsigned>(GetParam().posts.y));
    const glm::dvec2 ground_m =
        view.frame.to_ground_from_projected(view.dem.placement.at({column, row}));
    if (glm::length(ground_m) > 100e3) continue;
    ++found;
    const double height_m = view.dem.grid->at(column, row);
    const GeoPoint place = oracle.geographic({column, row});
    const glm::dvec3 truth =
        true_earth::enu(view.eye, {place.latitude_deg, place.longitude_deg, height_m});
    worst_rad = std::max(worst_rad, true_earth::angle_rad(view.drawn(ground_m, height_m), truth));
  }
  RecordProperty("worst_microradians", std::to_string(worst_rad * 1e6));
  EXPECT_LT(worst_rad, kTenthOfPixel_rad / 10);
  EXPECT_LT(worst_rad, view.frame.direction_error_rad());
}

// The bent tracks take part here: a hit knows the posts around it.
TEST_P(TrueDirections, OfWhatRaysHit) {
  const View view(GetParam());
  const cases::Oracle oracle(GetParam(), view.eye_point);
  const VerticalFrame& vertical = view.frame.terrain()->frame();
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> share(-1, 1);
  double worst_by_posts_rad = 0;
  double worst_by_place_rad = 0;
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const double azimuth = std::numbers::pi * share(random);
    const glm::dvec3 direction = glm::normalize(
        glm::dvec3(std::sin(azimuth), std::cos(azimuth), 0.06 * share(random) - 0.05));
    const auto hit = view.frame.terrain()->first_hit({.direction = direction});
    if (!hit || glm::length(hit->position_m) > 100e3) continue;
    ++hits;
    const glm::dvec2 ground_m(hit->position_m);
    const double height_m = vertical.at(ground_m).scene_height_m(hit->position_m.z);
    const auto angle_to = [&](const GeoPoint& place) {
      return true_earth::angle_rad(
          direction,
          true_earth::enu(view.eye, {place.latitude_deg, place.longitude_deg, height_m}));
    };
    worst_by_posts_rad = std::max(worst_by_posts_rad, angle_to(oracle.geographic(hit->uv)));
    worst_by_place_rad = std::max(worst_by_place_rad, angle_to(view.frame.from_ground(ground_m)));
  }
  RecordProperty("worst_microradians_by_posts", std::to_string(worst_by_posts_rad * 1e6));
  RecordProperty("worst_microradians_by_place", std::to_string(worst_by_place_rad * 1e6));
  EXPECT_GT(hits, 500);
  EXPECT_LT(worst_by_posts_rad, kTenthOfPixel_rad);
  EXPECT_LT(worst_by_place_rad, kTenthOfPixel_rad / 10);
}

TEST_P(TrueDirections, OfSummitsHighAboveTheEye) {
  struct Summit {
    double distance_m;
    double height_m;
  };
  const View view(GetParam(), 3000);
  for (const Summit& summit : {Summit{10e3, 5800}, Summit{7e3, 8000}}) {
    for (double azimuth = 0; azimuth < 360; azimuth += 15) {
      Place top{0, 0, summit.height_m};
      GeographicLib::Geodesic::WGS84().Direct(view.eye.latitude_deg, view.eye.longitude_deg,
                                              azimuth, summit.distance_m, top.latitude_deg,
                                              top.longitude_deg);
      const glm::dvec2 ground_m = view.frame.to_ground({top.latitude_deg, top.longitude_deg});
      EXPECT_LT(true_earth::angle_rad(view.drawn(ground_m, summit.height_m),
                                      true_earth::enu(view.eye, top)),
                kTenthOfPixel_rad / 10);
    }
  }
}

// A sun beam through a point at `distance_m`, followed over `length_m`: how far the direction that
// the view frame gives it is from where it goes there.
double worst_sun_error_deg(const View& view, double distance_m, double length_m) {
  double worst = 0;
  for (double azimuth = 0; azimuth < 360; azimuth += 30) {
    Place hit{0, 0, 500};
    GeographicLib::Geodesic::WGS84().Direct(view.eye.latitude_deg, view.eye.longitude_deg, azimuth,
                                            distance_m, hit.latitude_deg, hit.longitude_deg);
    const glm::dvec3 truth = true_earth::enu(view.eye, hit);
    const glm::dvec3 drawn =
        view.drawn(view.frame.to_ground({hit.latitude_deg, hit.longitude_deg}), hit.height_m);
    for (double sun_azimuth = 0; sun_azimuth < 360; sun_azimuth += 45) {
      for (const double sun_elevation : {2.0, 10.0, 45.0, 80.0}) {
        const double flat = std::cos(sun_elevation / kDegrees);
        const glm::dvec3 sun(flat * std::sin(sun_azimuth / kDegrees),
                             flat * std::cos(sun_azimuth / kDegrees),
                             std::sin(sun_elevation / kDegrees));
        const Place on = true_earth::place(view.eye, truth + length_m * sun);
        const glm::dvec3 further =
            view.drawn(view.frame.to_ground({on.latitude_deg, on.longitude_deg}), on.height_m);
        const glm::dvec3 direction = direction_at(view.frame.terrain()->frame(), drawn, sun);
        worst = std::max(worst, true_earth::angle_rad(direction, further - drawn));
      }
    }
  }
  return worst * kDegrees;
}

TEST_P(TrueDirections, OfTheSunAtAHit) {
  const View view(GetParam(), 2500);
  for (const double distance_m : {1e3, 30e3, 100e3}) {
    const double near_deg = worst_sun_error_deg(view, distance_m, 1e3);
    const double far_deg = worst_sun_error_deg(view, distance_m, 30e3);
    const std::string key = "sun_error_deg_at_" + std::to_string(static_cast<int>(distance_m));
    RecordProperty(key, std::to_string(near_deg) + ", shadow of 30 km " + std::to_string(far_deg));
    EXPECT_LT(near_deg, 0.05) << distance_m;
    EXPECT_LT(far_deg, 0.05) << distance_m;
  }
}

TEST_P(TrueDirections, AreThoseOfTrueEnu) {
  const View view(GetParam(), 3500, {.refraction = 0.13});
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> across_m(-60e3, 60e3);
  std::uniform_real_distribution<double> height_m(-100, 5000);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec2 ground_m(across_m(random), across_m(random));
    const double height = height_m(random);
    const GeoPoint place = view.frame.from_ground(ground_m);
    const glm::dvec3 truth =
        true_earth::enu(view.eye, {place.latitude_deg, place.longitude_deg, height});
    const glm::dvec3 drawn = view.drawn(ground_m, height);
    EXPECT_LT(glm::distance(view.frame.to_true_enu(drawn), truth), 3e-6 * glm::length(truth));
    EXPECT_LT(glm::distance(view.frame.from_true_enu(view.frame.to_true_enu(drawn)), drawn), 1e-9);
  }
}

std::string test_name(const testing::TestParamInfo<GridCase>& test) {
  std::string name = test.param.name;
  std::erase(name, ' ');
  return name;
}

INSTANTIATE_TEST_SUITE_P(EveryKind, TrueDirections, testing::ValuesIn(wide_grids()), test_name);

struct Summit {
  std::string name;
  Place place;
};

std::vector<Summit> read_summits(const std::string& path) {
  std::ifstream file(path);
  std::vector<Summit> summits;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream row(line);
    std::vector<std::string> fields(5);
    for (std::string& field : fields) std::getline(row, field, ',');
    // Where nobody published a height, that of a DEM.
    const std::string& height = fields[3].empty() ? fields[4] : fields[3];
    summits.push_back({fields[0], {std::stod(fields[1]), std::stod(fields[2]), std::stod(height)}});
  }
  return summits;
}

// Azimuth, and apparent elevation with light bent by k = 0.13, of every summit from the first.
void expect_true_summits(const std::string& dem_path, const std::string& summits_path,
                         std::size_t count) {
  const std::vector<Summit> summits = read_summits(summits_path);
  ASSERT_EQ(summits.size(), count);
  const Place eye{summits[0].place.latitude_deg, summits[0].place.longitude_deg,
                  summits[0].place.height_m + 50};
  const ViewFrame frame({read_one(dem_path)},
                        {.geographic = GeoPoint{eye.latitude_deg, eye.longitude_deg},
                         .projected = {},
                         .height_m = eye.height_m},
                        {.refraction = 0.13});
  for (std::size_t i = 1; i < summits.size(); ++i) {
    const Place& top = summits[i].place;
    double distance_m = 0;
    double azimuth_deg = 0;
    double back_deg = 0;
    GeographicLib::Geodesic::WGS84().Inverse(eye.latitude_deg, eye.longitude_deg, top.latitude_deg,
                                             top.longitude_deg, distance_m, azimuth_deg, back_deg);
    const glm::dvec3 truth = true_earth::enu(eye, top);
    const double elevation_deg = std::atan2(truth.z, std::hypot(truth.x, truth.y)) * kDegrees +
                                 0.13 * distance_m / (2 * 6371000) * kDegrees;
    const glm::dvec2 ground_m = frame.to_ground({top.latitude_deg, top.longitude_deg});
    const double z_m = frame.terrain()->frame().at(ground_m).z_m(top.height_m);
    EXPECT_NEAR(std::remainder(std::atan2(ground_m.x, ground_m.y) * kDegrees - azimuth_deg, 360), 0,
                0.02)
        << summits[i].name;
    EXPECT_NEAR(std::atan2(z_m, glm::length(ground_m)) * kDegrees, elevation_deg, 0.02)
        << summits[i].name;
  }
}

TEST(Summits, OfTheVosges) {
  NEEDS_SHARED_DATA();
  const std::string dem = shared_data("vosges/vosges_hohneck_grandballon_256.tif");
  expect_true_summits(dem, shared_data("vosges/vosges_summits.csv"), 12);
}

TEST(Summits, OfLiechtenstein) {
  NEEDS_SHARED_DATA();
  const std::string dem = shared_data("liechtenstein/li_srtm3_filled.tif");
  expect_true_summits(dem, shared_data("liechtenstein/li_peaks.csv"), 48);
}

}  // namespace
}  // namespace terrview
