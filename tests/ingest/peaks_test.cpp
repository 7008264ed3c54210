// Summits as files have them: ingest/peaks.h.
#include "ingest/peaks.h"

#include <gtest/gtest.h>

#include <string>

#include "terrain/error.h"
#include "tests/ingest/test_raster.h"

namespace terrview {
namespace {

class Peaks : public testing::Test {
 protected:
  PeakFile read(const std::string& name, const std::string& text) {
    write_text(folder_ / name, text);
    return read_peaks(folder_ / name);
  }
  // The message with which the file is refused; empty if it is not.
  std::string refused(const std::string& name, const std::string& text) {
    try {
      static_cast<void>(read(name, text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(Peaks, OfATableLieByTheirColumnsWhateverTheirCaseAndOrder) {
  for (const std::string text : {"name,lat,lon,ele,prominence\nSäntis,47.25,9.5,2502,2015\n",
                                 "ELE;Longitude;Latitude;Prominence_m;NAME\n2502 m;9.5;47.25;"
                                 "2015;Säntis\n"}) {
    const PeakFile file = read("p.csv", text);
    ASSERT_EQ(file.peaks.size(), 1U);
    EXPECT_EQ(file.peaks[0].name, "Säntis");
    EXPECT_EQ(file.peaks[0].place, glm::dvec2(9.5, 47.25));
    EXPECT_EQ(file.peaks[0].elevation_m, 2502);
    EXPECT_EQ(file.peaks[0].prominence_m, 2015);
    EXPECT_TRUE(file.file.geographic);
    EXPECT_FALSE(file.file.crs_wkt.empty());
  }
}

TEST_F(Peaks, OfATableWithXAndYAreInTheCoordinatesOfTheDem) {
  const PeakFile file = read("p.csv", "name,X,Y\nA,600000,200000\n");
  EXPECT_EQ(file.peaks.at(0).place, glm::dvec2(600000, 200000));
  EXPECT_TRUE(file.file.crs_wkt.empty());
  EXPECT_FALSE(file.peaks[0].elevation_m);
}

TEST_F(Peaks, OfGeoJsonAreThePointsThatHaveAName) {
  const std::string point = R"("geometry":{"type":"Point","coordinates":[7.1,47.9]}})";
  const PeakFile file =
      read("p.geojson",
           R"({"type":"FeatureCollection","features":[
        {"type":"Feature","properties":{"Name":" Grand\nBallon ","Elevation":1424},)" +
               point + R"(,{"type":"Feature","properties":{"Name":null},)" + point +
               R"(,{"type":"Feature","properties":{"Name":"A ridge"},"geometry":
            {"type":"LineString","coordinates":[[7,47],[8,48]]}}]})");
  ASSERT_EQ(file.peaks.size(), 1U);
  EXPECT_EQ(file.peaks[0].name, "Grand Ballon");
  EXPECT_EQ(file.peaks[0].elevation_m, 1424);
  EXPECT_EQ(file.without_name, 1);
  EXPECT_EQ(file.without_point, 1);
}

TEST_F(Peaks, AreRefusedNamingTheFieldsThereAre) {
  const std::string nowhere = refused("p.csv", "name,latitud,height\nA,47,1000\n");
  EXPECT_NE(nowhere.find("give lat and lon"), std::string::npos) << nowhere;
  EXPECT_NE(nowhere.find("name, latitud, height"), std::string::npos) << nowhere;
  const std::string nameless = refused("p.csv", "peak,lat,lon\nA,47,9\n");
  EXPECT_NE(nameless.find("'name'"), std::string::npos) << nameless;
  EXPECT_NE(nameless.find("peak, lat, lon"), std::string::npos) << nameless;
}

TEST_F(Peaks, AreRefusedWhereAPlaceIsNoNumberOrANameNoUtf8) {
  EXPECT_NE(refused("p.csv", "name,lat,lon\nA,47 N,9\n").find("feature 1"), std::string::npos);
  EXPECT_NE(refused("p.csv", "name,lat,lon\nA,nan,9\n").find("nowhere"), std::string::npos);
  EXPECT_NE(refused("p.csv", "name,lat,lon\nA,95,9\n").find("nowhere"), std::string::npos);
  EXPECT_NE(refused("p.csv", "name,lat,lon,x,y\nA,47,9,1,2\nB,,,1,2\n").find("feature 2"),
            std::string::npos);
  EXPECT_NE(refused("p.csv", "name,x,y\nA,1e10,9\n").find("nowhere"), std::string::npos);
  EXPECT_NE(refused("p.csv", "name,lat,lon\nS\xe4ntis,47,9\n").find("UTF-8"), std::string::npos);
  EXPECT_NE(refused("p.csv", "name,lat,lon\n"), "");
}

}  // namespace
}  // namespace terrview
