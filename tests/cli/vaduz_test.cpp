// Ten buildings of Vaduz, each checked by brute force in every pixel: ids, distances and the CSV.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>

#include <glm/geometric.hpp>

#include "cli/objects_csv.h"
#include "cli/prepare_view.h"
#include "cli/view_setup.h"
#include "ingest/dem.h"
#include "tests/cli/small_view.h"
#include "tests/cli/vaduz_house.h"

namespace terrview {
namespace {

constexpr glm::ivec2 kSize_px{160, 100};

ViewOptions from_the_castle(const std::string& buildings) {
  ViewOptions options;
  options.dems = {shared_data("liechtenstein/li_srtm3_filled.tif")};
  options.objects.buildings = {buildings};
  options.eye = parse_eye("47.1395,9.5245,+30");
  options.heading_deg = 285;
  options.pitch_deg = -12;
  options.size_px = kSize_px;
  options.light.no_shadows = true;
  options.sky.none = true;
  prepare(options);
  return options;
}

// Ids by falling number of their pixels.
std::vector<std::int32_t> most_seen(const Frame& frame) {
  std::map<std::int32_t, int> pixels;
  for (const PixelSample& sample : frame.samples.pixels())
    if (sample.object_id > 0) ++pixels[sample.object_id];
  std::vector<std::int32_t> ids;
  for (const auto& [id, count] : pixels) ids.push_back(id);
  std::sort(ids.begin(), ids.end(),
            [&](std::int32_t a, std::int32_t b) { return pixels.at(a) > pixels.at(b); });
  return ids;
}

TEST(Vaduz, TenBuildingsAreRightInEveryPixelAndInTheCsv) {
  NEEDS_SHARED_DATA();
  const std::string buildings = shared_data("liechtenstein/li_buildings_vaduz_all.geojson");
  const ViewOptions options = from_the_castle(buildings);
  const std::vector<Dem> dems = read_dems(options.dems);
  const View view = make_view(options, dems);
  const Frame frame = render(view.scene, view.camera, {.keep_samples = true});
  const FootprintFile file = read_footprints(buildings, {});
  std::map<std::int32_t, std::string> csv;
  std::istringstream lines(objects_csv(view, frame, 0));
  for (std::string line; std::getline(lines, line);) csv[std::atoi(line.c_str())] = line;
  ASSERT_EQ(csv.size(), 1399U);

  int checked = 0;
  for (const std::int32_t id : most_seen(frame)) {
    Footprint footprint = file.footprints.at(static_cast<std::size_t>(id - 1));
    ASSERT_EQ(footprint.number, id);
    if (footprint.roof != RoofShape::flat) continue;
    footprint.height_m = footprint.height_m.value_or(6);
    const House house = house_of(footprint, view.frame, lowest_ground_m(footprint, view.frame));
    int pixels = 0;
    int whole = 0;
    double solid_angle_sr = 0;
    for (int row = 0; row < kSize_px.y; ++row)
      for (int column = 0; column < kSize_px.x; ++column) {
        const Ray ray = view.camera.ray({column + 0.5, row + 0.5});
        const PixelSample& sample = frame.samples.at(column, row);
        const auto expected_m = house.first_m(ray);
        const double seen_m = sample.object_id == PixelSample::kNothing
                                  ? std::numeric_limits<double>::infinity()
                                  : glm::length(sample.position_m);
        if (expected_m) ++whole;
        if (sample.object_id == id) {
          ++pixels;
          const double x = (column + 0.5 - kSize_px.x / 2.0) * view.camera.per_px();
          const double y = (kSize_px.y / 2.0 - row - 0.5) * view.camera.per_px();
          solid_angle_sr +=
              view.camera.per_px() * view.camera.per_px() / std::pow(1 + x * x + y * y, 1.5);
          ASSERT_TRUE(expected_m) << id << ": " << column << ", " << row;
          // The base is the lowest of more points of the ground than the corners.
          EXPECT_NEAR(seen_m, *expected_m, 0.02);
        } else if (expected_m) {
          EXPECT_LE(seen_m, *expected_m + 0.02) << id << ": " << column << ", " << row;
        }
      }
    char expected[160];
    std::snprintf(expected, sizeof expected, ",%.6g,%d,", *footprint.height_m, pixels);
    EXPECT_NE(csv.at(id).find(expected), std::string::npos) << csv.at(id) << expected;
    const std::string tail = csv.at(id).substr(csv.at(id).find(expected) + std::strlen(expected));
    EXPECT_NEAR(std::stod(tail), solid_angle_sr, 1e-3 * solid_angle_sr);
    const double share = std::stod(tail.substr(tail.find(',') + 1));
    // The house of the brute force goes on below the ground.
    EXPECT_GE(share, static_cast<double>(pixels) / whole - 1e-3);
    EXPECT_LE(share, 1);
    if (++checked == 10) break;
  }
  EXPECT_EQ(checked, 10);
}

}  // namespace
}  // namespace terrview
