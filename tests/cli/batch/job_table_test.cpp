// Promises of cli/batch/job_table.h.
#include "cli/batch/job_table.h"

#include <gtest/gtest.h>

#include "terrain/error.h"

namespace terrview {
namespace {

JobTable parsed(const std::string& text) { return parse_job_table(text, "t"); }

TEST(JobTable, IsTheSameFromCsvJsonAndGeoJson) {
  const std::string csv =
      "name,eye,heading,no_shadows\na,\"48.5,7.25,900\",90,true\nb,\"48,7,+2\",,\n";
  const std::string json =
      R"([{"name": "a", "eye": [48.5, 7.25, 900], "heading": 90, "no_shadows": true},
                               {"name": "b", "eye": "48,7,+2", "heading": null, "no_shadows": ""}])";
  const std::string geojson = R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "geometry": {"type": "Point", "coordinates": [7.25, 48.5, 900]},
     "properties": {"name": "a", "heading": 90, "no_shadows": true}},
    {"type": "Feature", "geometry": {"type": "Point", "coordinates": [7, 48]},
     "properties": {"name": "b"}}]})";
  for (const std::string& text : {csv, json, geojson}) {
    const JobTable table = parsed(text);
    ASSERT_EQ(table.rows.size(), 2U) << text;
    EXPECT_EQ(table.rows[0].text("name"), "a");
    EXPECT_EQ(table.rows[0].text("eye"), "48.5,7.25,900");
    EXPECT_EQ(table.rows[0].text("heading"), "90");
    EXPECT_EQ(table.rows[0].text("no_shadows"), "true");
    EXPECT_EQ(table.rows[1].text("eye"), "48,7,+2");
    EXPECT_EQ(table.rows[1].cells.count("heading"), 0U);
    EXPECT_EQ(table.rows[1].cells.count("no_shadows"), 0U);
  }
}

TEST(JobTable, PlacesTheEyeByLatLonAltUnlessItSaysWhere) {
  const JobTable table = parsed(
      "lat,lon,alt,eye,eye-xy\n48,7,,,\n48,7,1200,,\n48,7,+30,,\n48,7,5,\"1,2,3\",\n48,7,5,,\"4,5,"
      "6\"\n");
  EXPECT_EQ(table.rows[0].text("eye"), "48,7,+2");
  EXPECT_EQ(table.rows[1].text("eye"), "48,7,1200");
  EXPECT_EQ(table.rows[2].text("eye"), "48,7,+30");
  EXPECT_EQ(table.rows[3].text("eye"), "1,2,3");
  EXPECT_EQ(table.rows[4].cells.count("eye"), 0U);
}

TEST(JobTable, PrefersThePropertyAltToTheThirdCoordinate) {
  const JobTable table = parsed(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "geometry": {"type": "Point", "coordinates": [7, 48, 500]},
     "properties": {"alt": "+10"}}]})");
  EXPECT_EQ(table.rows[0].text("eye"), "48,7,+10");
}

TEST(JobTable, KeepsEveryDigit) {
  EXPECT_EQ(parsed(R"([{"lat": 47.985123456789012, "lon": 0.1}])").rows[0].text("eye"),
            "47.98512345678901,0.1,+2");
}

TEST(JobTable, HasAnErrorForTheRowThatIsBadAlone) {
  const JobTable csv = parsed("name,heading\na,1\nb,1,2\nc\nd,4\n");
  ASSERT_EQ(csv.rows.size(), 4U);
  EXPECT_EQ(csv.rows[0].error, "");
  EXPECT_NE(csv.rows[1].error.find("line 3 has 3 cells"), std::string::npos) << csv.rows[1].error;
  EXPECT_NE(csv.rows[2].error, "");
  EXPECT_EQ(csv.rows[3].error, "");
}

TEST(JobTable, ThatIsNoneIsRefused) {
  for (const std::string text :
       {"", "a,b\n", "[]", "[1]", "{}", "{\"type\": \"Feature\"}", "[{\"a\": 1}", "a,a\n1,2\n",
        "{\"type\": \"FeatureCollection\", \"features\": 1}", "{\"type\": 1}",
        "{\"type\": \"FeatureCollection\", \"features\": [3]}", "name\n\xff\n"})
    EXPECT_THROW(static_cast<void>(parsed(text)), InputError) << text;
}

TEST(JobTable, InAnotherCoordinateSystemIsRefused) {
  const std::string text = R"({"type": "FeatureCollection", "crs": {"type": "name",
    "properties": {"name": "urn:ogc:def:crs:CODE"}}, "features": [{"type": "Feature",
    "properties": {}, "geometry": {"type": "Point", "coordinates": [7, 48]}}]})";
  const auto with = [&](const std::string& code) {
    return std::string(text).replace(text.find("CODE"), 4, code);
  };
  EXPECT_EQ(parsed(with("OGC:1.3:CRS84")).rows.size(), 1U);
  EXPECT_THROW(static_cast<void>(parsed(with("EPSG::25832"))), InputError);
}

TEST(JobTable, CutOffAnywhereIsReadOrRefused) {
  const std::string whole =
      R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"a": [1]},
      "geometry": {"type": "Point", "coordinates": [7, 48]}}]})";
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_THROW(static_cast<void>(parsed(whole.substr(0, n))), InputError) << n;
}

}  // namespace
}  // namespace terrview
