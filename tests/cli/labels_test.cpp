// The names of summits on views, and views as lines: files, refusals, and true azimuths.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>

#include <GeographicLib/Geodesic.hpp>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

using Attributes = std::map<std::string, std::string>;

// The data of each summit of a --labels-svg.
std::vector<Attributes> summits_of(const std::string& svg) {
  std::vector<Attributes> summits;
  const std::regex group("<g class=\"summit\"([^>]*)>");
  const std::regex attribute("data-([a-z-]+)=\"([^\"]*)\"");
  for (std::sregex_iterator g(svg.begin(), svg.end(), group), end; g != end; ++g) {
    const std::string text = (*g)[1];
    Attributes summit;
    for (std::sregex_iterator a(text.begin(), text.end(), attribute); a != end; ++a)
      summit[(*a)[1]] = (*a)[2];
    summits.push_back(summit);
  }
  return summits;
}

double number(const Attributes& summit, const std::string& name) {
  return std::stod(summit.at(name));
}

class Labels : public SmallView {
 protected:
  // Two hilltops of the DEM, and places in its valleys.
  void write_peaks() const {
    write_text(path("p.csv"),
               "name,lat,lon\nUn <Säntis> & Co,48.0045,6.9825\nNord,48.0205,7.0085\n");
  }
};

constexpr const char* kView = "--eye 47.985,6.99,900 --look-at 48.01,7 --size 320x200 --samples 1";

TEST_F(Labels, AreDrawnOnThePictureAndWrittenAsSvg) {
  write_peaks();
  ASSERT_NO_FATAL_FAILURE(view(words(kView) + words("-o bare.png")));
  ASSERT_NO_FATAL_FAILURE(
      view(words(kView) + words("--peaks p.csv --labels-svg l.svg -o named.png --threads 1")));
  const std::string svg = bytes("l.svg");
  const auto summits = summits_of(svg);
  ASSERT_FALSE(summits.empty());
  EXPECT_NE(bytes("bare.png"), bytes("named.png"));
  EXPECT_NE(svg.find("width=\"320\" height=\"200\""), std::string::npos);
  EXPECT_NE(svg.find(">Un &lt;Säntis&gt; &amp; Co</text>"), std::string::npos) << svg;
  ASSERT_NO_FATAL_FAILURE(
      view(words(kView) + words("--peaks p.csv --labels-svg m.svg -o again.png --threads 3")));
  EXPECT_EQ(bytes("again.png"), bytes("named.png"));
  EXPECT_EQ(bytes("m.svg"), svg);
}

TEST_F(Labels, AreOnEveryPictureOfAProgressiveView) {
  write_peaks();
  ASSERT_NO_FATAL_FAILURE(
      view(words(kView) + words("--peaks p.csv --progressive p.png -o named.png")));
  EXPECT_EQ(bytes("p.png"), bytes("named.png"));
}

TEST_F(Labels, AreRefusedWithoutSummitsOrAFont) {
  write_peaks();
  const Arguments start = words("hills.tif -q --size 8x8 --eye 47.985,6.99,900");
  expect_refused(run(start + words("--labels-svg l.svg")), {"--labels-svg", "--peaks"});
  expect_refused(run(start + words("--label-size 20")), {"--label-size", "--peaks"});
  expect_refused(run(start + words("--peaks nowhere.csv")), {"nowhere.csv"});
  expect_refused(run(start + words("--peaks p.csv --font p.csv")), {"p.csv", "font"});
  expect_refused(run(start + words("--peaks p.csv --labels-svg p.csv")), {"p.csv", "read"});
  expect_refused(run(start + words("--wireline-step 2")), {"--wireline-step", "--wireline"});
  EXPECT_EQ(outputs(), std::vector<std::string>{"p.csv"});
}

TEST_F(Labels, OfALineDrawingAreTheSameForAnyNumberOfThreads) {
  ASSERT_NO_FATAL_FAILURE(view(words(kView) + words("--wireline a.svg -o a.png --threads 1")));
  ASSERT_NO_FATAL_FAILURE(view(words(kView) + words("--wireline b.svg -o b.png --threads 3")));
  EXPECT_EQ(bytes("a.svg"), bytes("b.svg"));
  EXPECT_NE(bytes("a.svg").find("class=\"silhouette\""), std::string::npos);
  EXPECT_NE(bytes("a.svg").find("class=\"grid\""), std::string::npos);
}

struct Panorama {
  const char* name;
  const char* dems;
  const char* peaks;
  const char* line;
  double latitude, longitude, height_m;
  double width_px, height_px, fov_deg, heading_deg;
  std::size_t least;  // labels
};

class SharedPanoramas : public Labels, public testing::WithParamInterface<Panorama> {
 protected:
  void SetUp() override {
    NEEDS_SHARED_DATA();
    for (const std::string& dem : words(GetParam().dems)) args_.push_back(shared_data(dem));
    peaks_ = shared_data(GetParam().peaks);
    const Finished finished = run(
        args_ + words(GetParam().line) +
        Arguments{"-q", "--samples", "1", "--no-shadows", "--no-sky", "--projection", "cylindrical",
                  "--peaks", peaks_, "--labels-svg", "l.svg", "--layers", "l.tif", "-o", "l.png"});
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    summits_ = summits_of(bytes("l.svg"));
    ASSERT_GE(summits_.size(), GetParam().least);
  }

  // Latitude and longitude of the file's rows by name.
  [[nodiscard]] std::map<std::string, std::pair<double, double>> places() const {
    std::map<std::string, std::pair<double, double>> places;
    std::istringstream text(read_text(peaks_));
    std::string line;
    std::getline(text, line);  // name,lat,lon,...
    while (std::getline(text, line)) {
      std::istringstream row(line);
      std::string name;
      std::string latitude;
      std::string longitude;
      std::getline(row, name, ',');
      std::getline(row, latitude, ',');
      std::getline(row, longitude, ',');
      places[name] = {std::stod(latitude), std::stod(longitude)};
    }
    return places;
  }

  Arguments args_;
  std::string peaks_;
  std::vector<Attributes> summits_;
};

TEST_P(SharedPanoramas, HaveTheirSummitsAtTheTrueAzimuthsAndNoneThatIsHidden) {
  const Panorama& panorama = GetParam();
  const auto all = places();
  for (const Attributes& summit : summits_) {
    const auto& [latitude, longitude] = all.at(summit.at("name"));
    double distance_m = 0;
    double azimuth_deg = 0;
    double back_deg = 0;
    GeographicLib::Geodesic::WGS84().Inverse(panorama.latitude, panorama.longitude, latitude,
                                             longitude, distance_m, azimuth_deg, back_deg);
    const double seen_deg = panorama.heading_deg + (number(summit, "x") - panorama.width_px / 2) *
                                                       panorama.fov_deg / panorama.width_px;
    EXPECT_NEAR(std::remainder(seen_deg - azimuth_deg, 360), 0, 0.05) << summit.at("name");
    EXPECT_NEAR(std::remainder(number(summit, "azimuth") - azimuth_deg, 360), 0, 1e-4);
    // Two posts of the DEM along the line of sight.
    const double straight_m =
        std::hypot(distance_m, number(summit, "elevation-m") - panorama.height_m);
    EXPECT_NEAR(number(summit, "distance-km"), straight_m / 1000, 0.22) << summit.at("name");
  }
  // None is hidden: in the distance layer its pixel, or the one above or below it at a skyline, is
  // as far away as its ground, which a pixel sees more of where it grazes it.
  const Layers found = layers("l.tif");
  for (const Attributes& summit : summits_) {
    const int column = static_cast<int>(number(summit, "x"));
    const int row = static_cast<int>(number(summit, "y"));
    double nearest = 1e9;
    for (int y = std::max(0, row - 1); y <= std::min(found.height_px - 1, row + 1); ++y)
      nearest = std::min(nearest, std::abs(found.at("distance_m", column, y) / 1000 -
                                           number(summit, "distance-km")));
    EXPECT_LT(nearest, std::max(0.22, 0.03 * number(summit, "distance-km"))) << summit.at("name");
  }
}

INSTANTIATE_TEST_SUITE_P(
    Places, SharedPanoramas,
    testing::Values(Panorama{"GrandBallon", "vosges/N48E007.hgt vosges/N47E007.hgt",
                             "vosges/vosges_summits.csv",
                             "--eye 47.90083,7.09833,+10 --heading 180 --fov 360 --size 3600x300 "
                             "--visibility 120",
                             47.90083, 7.09833, 1423, 3600, 300, 360, 180, 9},
                    Panorama{"Liechtenstein", "liechtenstein/li_srtm3_filled.tif",
                             "liechtenstein/li_peaks.csv",
                             "--eye 47.1755,9.5730,+150 --heading 170 --fov 110 --size 1600x500",
                             47.1755, 9.5730, 2145, 1600, 500, 110, 170, 15}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace terrview
