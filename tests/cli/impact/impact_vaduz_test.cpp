// A tower at Vaduz, from ten viewpoints: every number of the table by brute force.
#include <cmath>
#include <map>
#include <random>
#include <regex>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cli/prepare_view.h"
#include "cli/view_setup.h"
#include "ingest/ground_under.h"
#include "ingest/viewpoint_file.h"
#include "tests/cli/small_view.h"
#include "tests/cli/vaduz_house.h"
#include "tests/support/sanitized.h"

namespace terrview {
namespace {

constexpr glm::ivec2 kSize_px{64, 36};
constexpr double kFar = std::numeric_limits<double>::infinity();

using Numbers = std::map<std::string, double>;  // by column; what is empty is not there

// By viewpoint and building; of the whole project as building 0.
using Table = std::map<std::pair<int, int>, Numbers>;

Table read_table(const std::string& text) {
  const Rows rows = csv_rows(text);
  const std::vector<std::string>& names = rows.front();
  Table table;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const std::vector<std::string>& values = rows[row];
    Numbers numbers;
    for (std::size_t i = 4; i + 1 < names.size(); ++i)
      if (!values[i].empty()) numbers[names[i]] = std::stod(values[i]);
    const int building = values[2].empty() ? 0 : std::stoi(values[2]);
    table[{std::stoi(values[0]), building}] = numbers;
  }
  return table;
}

// A footprint with a height, and the lowest ground under it: the same for every eye.
struct Plot {
  Footprint footprint;
  double lowest_m;
};

// Which ground is the lowest is what tests/ingest/buildings_test.cpp is about.
std::vector<Plot> plots_of(const FootprintFile& file, const ViewFrame& frame) {
  std::vector<Plot> plots;
  for (Footprint footprint : file.footprints) {
    footprint.height_m = footprint.height_m.value_or(6);
    std::vector<Polygon::Ring> rings = footprint.polygons.at(0);
    for (Polygon::Ring& ring : rings)
      for (glm::dvec2& corner : ring) corner = frame.to_ground({corner.y, corner.x});
    plots.push_back({footprint, ground_under(*frame.terrain(), Polygon(rings))->lowest_m});
  }
  return plots;
}

// All that stands, and the ground by its plain tracer.
struct City {
  const ViewFrame& frame;
  std::vector<House> old;
  std::vector<House> before_project;  // those of `old` that may stand before it
  std::vector<House> project;

  City(const ViewFrame& in, const std::vector<Plot>& standing, const std::vector<Plot>& planned)
      : frame(in) {
    constexpr double kBelow_m = 60;
    for (const Plot& plot : standing)
      old.push_back(house_of(plot.footprint, frame, plot.lowest_m, kBelow_m));
    for (const Plot& plot : planned)
      project.push_back(house_of(plot.footprint, frame, plot.lowest_m, kBelow_m));
    const glm::dvec3 middle_m = project.front().middle_m;
    const glm::dvec3 way = glm::normalize(middle_m);
    constexpr double kProject_m = 200;
    for (const House& house : old) {
      const double along_m = glm::dot(house.middle_m, way);
      if (along_m < glm::length(middle_m) + kProject_m &&
          glm::length(house.middle_m - along_m * way) < kProject_m + house.radius_m)
        before_project.push_back(house);
    }
  }

  static double first_m(const std::vector<House>& houses, const Ray& ray) {
    double nearest_m = kFar;
    for (const House& house : houses)
      if (const auto hit_m = house.first_m(ray)) nearest_m = std::min(nearest_m, *hit_m);
    return nearest_m;
  }

  [[nodiscard]] double ground_m(const Ray& ray) const {
    const auto hit = frame.terrain()->first_hit({ray.origin_m, glm::normalize(ray.direction)});
    return hit ? hit->distance_m : kFar;
  }

  // Whether the ray meets that building before all else.
  [[nodiscard]] bool shows(std::size_t building, const Ray& ray) const {
    const auto own_m = project[building].first_m(ray);
    return own_m && first_m(project, ray) >= *own_m && first_m(before_project, ray) >= *own_m &&
           ground_m(ray) >= *own_m;
  }

  // Whether nothing is before a point of the project.
  [[nodiscard]] bool sees(const glm::dvec3& point_m) const {
    const Ray ray{.direction = point_m};
    const double before_m = glm::length(point_m) - 0.02;
    return ground_m(ray) > before_m && first_m(before_project, ray) > before_m &&
           first_m(project, ray) > before_m;
  }

  [[nodiscard]] bool has_sky(bool with_project, const Ray& ray) const {
    return !std::isfinite(ground_m(ray)) && !std::isfinite(first_m(old, ray)) &&
           !(with_project && std::isfinite(first_m(project, ray)));
  }
};

// By a net of azimuths and elevations over the building's corners.
double solid_angle_sr(const City& city, std::size_t building) {
  constexpr int kSteps = 90;
  const House& house = city.project[building];
  const double middle_rad = std::atan2(house.middle_m.x, house.middle_m.y);
  glm::dvec2 low(kFar);
  glm::dvec2 high(-kFar);
  for (const glm::dvec2 corner : house.oracle.rings[0]) {
    for (const double height_m : {-20.0, house.oracle.highest_roof_m}) {
      const glm::dvec3 at = house.middle_m + glm::dvec3(corner, height_m);
      const double azimuth = std::remainder(std::atan2(at.x, at.y) - middle_rad, 2 * M_PI);
      const glm::dvec2 angles(azimuth, std::atan2(at.z, std::hypot(at.x, at.y)));
      low = glm::min(low, angles);
      high = glm::max(high, angles);
    }
  }
  high.y += 0.02 * (high.y - low.y);
  const glm::dvec2 step = (high - low) / static_cast<double>(kSteps);
  double sum_sr = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const glm::dvec2 at = low + step * (glm::dvec2(i, j) + 0.5);
      const double azimuth = middle_rad + at.x;
      const Ray ray{.direction = {std::sin(azimuth) * std::cos(at.y),
                                  std::cos(azimuth) * std::cos(at.y), std::sin(at.y)}};
      if (city.shows(building, ray))
        sum_sr += step.x * (std::sin(at.y + step.y / 2) - std::sin(at.y - step.y / 2));
    }
  }
  return sum_sr;
}

// By points drawn at random over the roof, and over the walls that face the eye.
class RandomPoints {
 public:
  double facing_m2 = 0;
  double seen_m2 = 0;
  double nearest_m = kFar;  // of those seen
  double farthest_m = 0;

  RandomPoints(const City& city, std::size_t building)
      : city_(city), house_(city.project[building]), ring_(house_.oracle.rings[0]) {
    double turn = 0;
    for (std::size_t i = 0; i + 1 < ring_.size(); ++i)
      turn += ring_[i].x * ring_[i + 1].y - ring_[i].y * ring_[i + 1].x;
    for (std::size_t i = 0; i + 1 < ring_.size(); ++i) {
      const glm::dvec2 edge = ring_[i + 1] - ring_[i];
      const glm::dvec2 outward = (turn > 0 ? 1.0 : -1.0) * glm::dvec2(edge.y, -edge.x);
      if (glm::dot(outward, glm::dvec2(house_.middle_m) + ring_[i]) < 0) add_wall(ring_[i], edge);
    }
    add_roof();
  }

 private:
  static constexpr int kPoints = 1500;

  double share() { return std::uniform_real_distribution<double>(0, 1)(engine_); }

  double roof_m(glm::dvec2 corner) const {
    return house_.middle_m.z + glm::dot(house_.oracle.slope, corner) + house_.oracle.highest_roof_m;
  }

  bool try_point(glm::dvec2 corner, double z_m) {
    const glm::dvec3 point(glm::dvec2(house_.middle_m) + corner, z_m);
    if (!city_.sees(point)) return false;
    const double distance_m = glm::length(city_.frame.to_true_enu(point));
    nearest_m = std::min(nearest_m, distance_m);
    farthest_m = std::max(farthest_m, distance_m);
    return true;
  }

  void add_wall(glm::dvec2 from, glm::dvec2 edge) {
    const VerticalFrame& vertical = city_.frame.terrain()->frame();
    double wall_m2 = 0;
    int free = 0;
    for (int k = 0; k < kPoints; ++k) {
      const glm::dvec2 corner = from + share() * edge;
      const glm::dvec2 ground_m = glm::dvec2(house_.middle_m) + corner;
      const double foot_m =
          vertical.at(ground_m).z_m(city_.frame.terrain()->ground_at(ground_m)->scene_height_m);
      const double height_m = roof_m(corner) - foot_m;
      wall_m2 += glm::length(edge) * height_m / kPoints;
      free += try_point(corner, foot_m + share() * height_m) ? 1 : 0;
    }
    facing_m2 += wall_m2;
    seen_m2 += wall_m2 * free / kPoints;
  }

  void add_roof() {
    glm::dvec2 low(kFar);
    glm::dvec2 high(-kFar);
    for (const glm::dvec2 corner : ring_) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    for (int k = 0; k < kPoints; ++k) {
      const glm::dvec2 corner = low + glm::dvec2(share(), share()) * (high - low);
      if (house_.oracle.over_footprint(corner)) try_point(corner, roof_m(corner));
    }
  }

  const City& city_;
  const House& house_;
  const Polygon::Ring& ring_;
  std::mt19937 engine_{11};
};

// Pixels of the project; and how many columns have a horizon, and another one.
struct Picture {
  int pixels = 0;
  int columns = 0;
  int changed = 0;
};

Picture picture(const City& city, const Camera& camera) {
  Picture found;
  for (int column = 0; column < kSize_px.x; ++column) {
    int before = 0;
    int after = 0;
    for (int row = 0; row < kSize_px.y; ++row) {
      const Ray ray = camera.ray({column + 0.5, row + 0.5});
      if (before == row && city.has_sky(false, ray)) ++before;
      if (after == row && city.has_sky(true, ray)) ++after;
      for (std::size_t i = 0; i < city.project.size(); ++i)
        if (city.shows(i, ray)) ++found.pixels;
    }
    const auto is_shown = [](int row) { return row > 0 && row < kSize_px.y; };
    if (!is_shown(before) && !is_shown(after)) continue;
    ++found.columns;
    found.changed += before != after ? 1 : 0;
  }
  return found;
}

View view_from(const Viewpoint& viewpoint, const std::vector<Dem>& dems) {
  ViewOptions options;
  options.dems = {dems.front().name};
  options.eye = EyePlace{.geographic = GeoPoint{viewpoint.place.y, viewpoint.place.x},
                         .projected = {},
                         .height_m = viewpoint.eye_height_m.value_or(1.6),
                         .above_ground = true};
  // The middle of the two buildings, and half of the tower.
  options.look_at = parse_look_at("47.13745,9.51765,+30");
  options.fov_deg = viewpoint.options.count("fov") ? std::stod(viewpoint.options.at("fov")) : 60;
  options.size_px = kSize_px;
  options.coherence = Coherence::off;
  options.sky.none = true;
  prepare(options);
  return make_view(options, dems);
}

void expect_picture(const Numbers& whole, const Picture& pixels) {
  // Buildings' edges may run along rows of rays.
  EXPECT_NEAR(whole.at("pixels"), pixels.pixels, 2 + 0.02 * pixels.pixels);
  EXPECT_EQ(whole.count("horizon_changed"), pixels.columns > 0 ? 1U : 0U);
  if (pixels.columns > 0) {
    EXPECT_NEAR(whole.at("horizon_changed"), static_cast<double>(pixels.changed) / pixels.columns,
                1.01 / pixels.columns);
  }
}

// Returns the solid angle by brute force.
double expect_building(const Numbers& numbers, const City& city, int building) {
  const auto index = static_cast<std::size_t>(building - 1);
  const double seen_sr = solid_angle_sr(city, index);
  const double distance_m = glm::length(city.project[index].middle_m);
  const double own_sr = 40 * (building == 1 ? 60 : 9) / (distance_m * distance_m);
  EXPECT_NEAR(numbers.at("solid_angle_sr"), seen_sr, 0.015 * own_sr);
  const RandomPoints points(city, index);
  EXPECT_EQ(numbers.at("seen"), seen_sr > 0 || points.farthest_m > 0 ? 1 : 0);
  EXPECT_NEAR(numbers.at("facade_facing_m2"), points.facing_m2, 0.01 * points.facing_m2);
  EXPECT_NEAR(numbers.at("facade_share"), points.seen_m2 / points.facing_m2, 0.03);
  // Where hardly anything is seen, its ends hang on the last centimetres of what is before it.
  if (points.seen_m2 >= 0.1 * points.facing_m2) {
    EXPECT_NEAR(numbers.at("nearest_m"), points.nearest_m, 2);
    EXPECT_NEAR(numbers.at("farthest_m"), points.farthest_m, 2);
  }
  return seen_sr;
}

TEST(ImpactVaduz, TenViewpointsNumbersAreThoseOfBruteForce) {
  NEEDS_SHARED_DATA();
  const std::string dem = shared_data("liechtenstein/li_srtm3_filled.tif");
  const std::string samples = TERRVIEW_SOURCE_DIR "/samples/";
  const TemporaryFolder folder;
  // The houses of the brute force have level roofs.
  const std::string standing = folder / "standing.geojson";
  write_text(standing, std::regex_replace(
                           read_text(shared_data("liechtenstein/li_buildings_vaduz_all.geojson")),
                           std::regex("roof_shape"), "no_shape"));
  const Finished done = run_here(
      {"impact", dem, "--existing", standing, "--buildings", samples + "vaduz_tower.geojson",
       "--viewpoints", samples + "vaduz_viewpoints.geojson", "--size", "64x36", "--samples", "1",
       "--no-sky", "--no-shadows", "--zone", "off", "-q", "-o", "out"},
      folder.path().string());
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Table table = read_table(read_text(folder / "out/impact.csv"));

  const std::vector<Dem> dems = read_dems({dem});
  const ViewFrame anywhere(dems, parse_eye("47.13745,9.51765,+100"), {});
  const std::vector<Plot> old = plots_of(read_footprints(standing, {}), anywhere);
  const std::vector<Plot> planned =
      plots_of(read_footprints(samples + "vaduz_tower.geojson", {}), anywhere);
  int seeing = 0;
  for (const Viewpoint& viewpoint :
       read_viewpoints(samples + "vaduz_viewpoints.geojson", dems.front()).viewpoints) {
    SCOPED_TRACE(viewpoint.name);
    if (kSanitized && viewpoint.number % 4 != 1) continue;
    const View view = view_from(viewpoint, dems);
    const City city(view.frame, old, planned);
    const Numbers& whole = table.at({viewpoint.number, 0});
    expect_picture(whole, picture(city, view.camera));
    double sum_sr = 0;
    for (int building = 1; building <= 2; ++building) {
      SCOPED_TRACE(building);
      sum_sr += expect_building(table.at({viewpoint.number, building}), city, building);
    }
    EXPECT_NEAR(whole.at("solid_angle_sr"), sum_sr, 0.015 * std::max(sum_sr, 1e-6));
    seeing += sum_sr > 0 ? 1 : 0;
  }
  EXPECT_GE(seeing, kSanitized ? 2 : 7);
  EXPECT_LT(seeing, 10);
}

}  // namespace
}  // namespace terrview
