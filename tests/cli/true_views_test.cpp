// Whole views against geocentric coordinates: what each pixel shows lies where the pixel looks.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <gdal_utils.h>
#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

// A tenth of a pixel of a picture 1920 pixels and 60 degrees wide.
constexpr double kTenth_rad = 0.1 * 0.57735026918962576 / 960;

// True directions at the eye of a camera file, refraction left out.
class TrueCamera {
 public:
  explicit TrueCamera(const nlohmann::json& camera)
      : width_px_(camera["size_px"][0]),
        height_px_(camera["size_px"][1]),
        k_(std::tan(camera["fov"].get<double>() / 2 * kRadians) / (width_px_ / 2)),
        enu_(camera["eye"]["latitude"], camera["eye"]["longitude"], camera["eye"]["height_m"]) {
    const double heading = camera["heading"].get<double>() * kRadians;
    const double pitch = camera["pitch"].get<double>() * kRadians;
    const double roll = camera["roll"].get<double>() * kRadians;
    const glm::dvec3 level(std::cos(heading), -std::sin(heading), 0);
    forward_ = {std::sin(heading) * std::cos(pitch), std::cos(heading) * std::cos(pitch),
                std::sin(pitch)};
    const glm::dvec3 upright = glm::cross(level, forward_);
    right_ = level * std::cos(roll) - upright * std::sin(roll);
    up_ = upright * std::cos(roll) + level * std::sin(roll);
  }

  [[nodiscard]] glm::dvec3 towards(double latitude, double longitude, double height_m) const {
    glm::dvec3 enu_m;
    enu_.Forward(latitude, longitude, height_m, enu_m.x, enu_m.y, enu_m.z);
    return enu_m;
  }

  [[nodiscard]] glm::dvec3 through(double column, double row) const {
    return glm::normalize(forward_ + right_ * ((column + 0.5 - width_px_ / 2) * k_) +
                          up_ * ((height_px_ / 2 - row - 0.5) * k_));
  }

 private:
  double width_px_;
  double height_px_;
  double k_;
  GeographicLib::LocalCartesian enu_;
  glm::dvec3 forward_{};
  glm::dvec3 right_{};
  glm::dvec3 up_{};
};

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

class TrueViews : public SmallView {
 protected:
  // The shared DEMs of these names, parted by blanks.
  static Arguments shared_dems(const std::string& names) {
    Arguments paths;
    for (const std::string& name : words(names)) paths.push_back(shared_data(name));
    return paths;
  }

  // Renders a view of DEMs without refraction into t.tif and t.json; must succeed.
  void look(const Arguments& dems, const std::string& line) const {
    const Finished finished =
        run(dems +
            Arguments{"-q", "--refraction", "0", "-o", "t.png", "--layers", "t.tif", "--camera",
                      "t.json", "--overwrite", "--no-shadows"} +
            words(line));
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
  }
};

struct WholeView {
  const char* dem;
  const char* line;
};

class LayersOfTrueViews : public TrueViews, public testing::WithParamInterface<WholeView> {};

// Pixels as small as those of a picture of 1920 pixels over 60 degrees.
TEST_P(LayersOfTrueViews, LieInTheDirectionOfTheirPixel) {
  NEEDS_SHARED_DATA();
  const Arguments dems = shared_dems(GetParam().dem);
  ASSERT_NO_FATAL_FAILURE(look(dems, GetParam().line));
  const TrueCamera camera(json("t.json"));
  const Layers found = layers("t.tif");
  double worst_rad = 0;
  int hits = 0;
  for (int row = 0; row < found.height_px; ++row) {
    for (int column = 0; column < found.width_px; ++column) {
      const double distance_m = found.at("distance_m", column, row);
      if (std::isnan(distance_m)) continue;
      ++hits;
      const glm::dvec3 true_m =
          camera.towards(found.at("latitude", column, row), found.at("longitude", column, row),
                         found.at("height_m", column, row));
      worst_rad = std::max(worst_rad, angle_between(true_m, camera.through(column, row)));
      EXPECT_NEAR(glm::length(true_m), distance_m, 1e-3 + 1e-6 * distance_m);
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_LT(worst_rad, kTenth_rad);
  RecordProperty("worst_tenths_of_a_pixel", std::to_string(worst_rad / kTenth_rad));
}

INSTANTIATE_TEST_SUITE_P(
    SixViews, LayersOfTrueViews,
    testing::Values(
        WholeView{"vosges/N47E007.hgt",
                  "--eye 47.9008,7.0986,+2 --heading 170 --pitch -1 --fov 15 "
                  "--size 480x200"},
        WholeView{"vosges/N47E007.hgt",
                  "--eye 47.9008,7.0986,+2 --heading 90 --fov 60 "
                  "--size 1920x60"},
        WholeView{"alps/N47E009.hgt",
                  "--eye 47.42,9.40,2500 --look-at 47.08,9.5 --roll 20 "
                  "--fov 15 --size 480x200"},
        WholeView{"mthood/lf_elev_220_mt_hood_utm.tif",
                  "--eye 45.305,-121.755,+700 --look-at 45.3735,-121.6959 --fov 15 --size 480x200"},
        WholeView{"osterrain50/NN16.asc",
                  "--eye 56.75,-5.08,900 --heading 80 --pitch -3 --fov 15 --size 480x200"},
        WholeView{"liechtenstein/li_srtm3_filled.tif",
                  "--eye 47.14,9.52,6000 --heading 30 --pitch -80 --fov 15 --size 480x200"}));

struct Summit {
  std::string name;
  double latitude;
  double longitude;
};

// name, latitude and longitude of a comma-separated list; a name may stand in quotes.
std::vector<Summit> summits_of(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<Summit> summits;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string name;
    std::string latitude;
    std::string longitude;
    std::getline(fields, name, ',');
    std::getline(fields, latitude, ',');
    std::getline(fields, longitude, ',');
    summits.push_back({name, std::stod(latitude), std::stod(longitude)});
  }
  return summits;
}

struct SummitsFromAnEye {
  const char* dem;
  const char* summits;
  const char* eye;
  int fewest_visible;
};

class SummitsOfTrueViews : public TrueViews,
                           public testing::WithParamInterface<SummitsFromAnEye> {};

// A camera aimed at a summit sees it in its middle, or something nearer; never past it.
TEST_P(SummitsOfTrueViews, AreInTheMiddleOfAViewAimedAtThem) {
  NEEDS_SHARED_DATA();
  const Arguments dems = shared_dems(GetParam().dem);
  const std::string list = shared_data(GetParam().summits);
  int visible = 0;
  int hidden = 0;
  for (const Summit& summit : summits_of(list)) {
    SCOPED_TRACE(summit.name);
    std::ostringstream line;
    line.precision(10);
    line << "--fov 1 --size 33x33 --eye " << GetParam().eye << " --look-at " << summit.latitude
         << ',' << summit.longitude;
    ASSERT_NO_FATAL_FAILURE(look(dems, line.str()));
    const Layers found = layers("t.tif");
    const TrueCamera camera(json("t.json"));
    const double summit_m = glm::length(camera.towards(summit.latitude, summit.longitude, 1500));
    if (summit_m < 1000) continue;  // the eye's own hill
    double nearest_m = INFINITY;
    double first_m = INFINITY;
    // The rows from the middle down: above it may be the sky.
    for (int row = 16; row <= 18; ++row) {
      for (int column = 15; column <= 17; ++column) {
        if (std::isnan(found.at("distance_m", column, row))) continue;
        first_m = std::min(first_m, found.at("distance_m", column, row));
        const double height_m = found.at("height_m", column, row);
        const glm::dvec3 seen_m = camera.towards(found.at("latitude", column, row),
                                                 found.at("longitude", column, row), height_m);
        nearest_m = std::min(
            nearest_m,
            glm::length(seen_m - camera.towards(summit.latitude, summit.longitude, height_m)));
      }
    }
    const bool is_visible = nearest_m < 150;
    EXPECT_TRUE(is_visible || first_m < summit_m) << "seen at " << first_m << " of " << summit_m;
    (is_visible ? visible : hidden) += 1;
  }
  EXPECT_GE(visible, GetParam().fewest_visible) << hidden << " hidden";
}

INSTANTIATE_TEST_SUITE_P(
    Lists, SummitsOfTrueViews,
    testing::Values(SummitsFromAnEye{"vosges/N47E007.hgt vosges/N48E007.hgt",
                                     "vosges/vosges_summits.csv", "47.95,7.056,3000", 6},
                    SummitsFromAnEye{"liechtenstein/li_srtm3_filled.tif",
                                     "liechtenstein/li_peaks.csv", "47.14,9.52,3500", 30}));

// The first row of each column that shows ground.
std::vector<int> skyline(const Layers& found) {
  std::vector<int> rows;
  for (int column = 0; column < found.width_px; ++column) {
    int row = 0;
    while (row < found.height_px && std::isnan(found.at("distance_m", column, row))) ++row;
    rows.push_back(row);
  }
  return rows;
}

void warp(const std::string& from, const std::string& to, const char* crs) {
  const GDALDatasetUniquePtr source(GDALDataset::Open(from.c_str()));
  // Posts so near to each other that the ground between them is that of the source.
  const char* const arguments[] = {"-t_srs", crs,   "-r",      "bilinear",   "-tr",   "15",
                                   "15",     "-ot", "Float32", "-dstnodata", "-9999", nullptr};
  GDALWarpAppOptions* options = GDALWarpAppOptionsNew(const_cast<char**>(arguments), nullptr);
  GDALDatasetH inputs[] = {GDALDataset::ToHandle(source.get())};
  GDALDatasetH made = GDALWarp(to.c_str(), nullptr, 1, inputs, options, nullptr);
  GDALWarpAppOptionsFree(options);
  ASSERT_NE(made, nullptr);
  GDALClose(made);
}

TEST_F(TrueViews, HaveTheSameSkylineInEveryProjection) {
  NEEDS_SHARED_DATA();
  const auto dem = shared_data("vosges/vosges_hohneck_grandballon_256.tif");
  // The Grand Ballon, well inside the grid: at its rim gdalwarp adds half a post of ground.
  const std::string line =
      "--eye 47.90,7.16,900 --look-at 47.9008,7.0983,1300 --fov 15 --size 480x120";
  ASSERT_NO_FATAL_FAILURE(look({dem}, line));
  const std::vector<int> expected = skyline(layers("t.tif"));
  for (const char* crs : {"EPSG:32632", "EPSG:3857"}) {
    SCOPED_TRACE(crs);
    const std::string warped = path("warped.tif");
    std::remove(warped.c_str());
    warp(dem, warped, crs);
    ASSERT_NO_FATAL_FAILURE(look({warped}, line));
    const std::vector<int> rows = skyline(layers("t.tif"));
    std::vector<int> differences;
    for (std::size_t i = 0; i < rows.size(); ++i)
      differences.push_back(std::abs(rows[i] - expected[i]));
    std::sort(differences.begin(), differences.end());
    EXPECT_LE(differences[differences.size() * 99 / 100], 1);
    std::remove(warped.c_str());
  }
}

}  // namespace
}  // namespace terrview
