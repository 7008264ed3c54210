// --buildings, --trees and --objects-csv: docs/cli.md, "Objects".
#include <cmath>
#include <map>
#include <numbers>

#include "cli/objects_csv.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

class ObjectsOfView : public SmallView {
 protected:
  // Two blocks north of the eye, in the plain's own coordinates, the second behind the first.
  ObjectsOfView() {
    write_text(path("b.geojson"), R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"height":40,"name":"Front, \"old\""},"geometry":{"type":"Polygon",
       "coordinates":[[[360,200],[420,200],[420,240],[360,240],[360,200]]]}},
      {"type":"Feature","properties":{},"geometry":null},
      {"type":"Feature","properties":{"colour":"#f00"},"geometry":{"type":"Polygon",
       "coordinates":[[[340,300],[380,300],[380,340],[340,340],[340,300]]]}}]})");
    write_text(path("t.geojson"), R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"height":30},"geometry":{"type":"Point","coordinates":[500,250]}}]})");
  }

  // A view north over the plain; returns its messages.
  std::string plain(const std::string& options) const {
    const Finished done =
        run(words("plain.asc --eye-xy 390,50,320 --heading 0 --fov 60 --size "
                  "96x64 -o a.png --overwrite " +
                  options));
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return done.err;
  }
};

TEST_F(ObjectsOfView, AreCountedInTheSummary) {
  EXPECT_TRUE(says(plain("--buildings b.geojson --trees t.geojson"),
                   {"b.geojson: 3 features, 2 buildings (1 with a height, 1 without), 1 without an "
                    "area",
                    "t.geojson: 1 features, 1 trees"}));
}

TEST_F(ObjectsOfView, ThatCannotBeSeenAsTheyAreAreCountedInTheSummary) {
  write_text(path("u.geojson"), R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"height":10,"min_height":20,"roof:height":"low"},"geometry":{"type":"Polygon",
       "coordinates":[[[360,200],[420,200],[420,240],[360,240],[360,200]]]}}]})");
  write_text(path("v.geojson"), R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"height":"tall"},"geometry":{"type":"Point","coordinates":[500,250]}}]})");
  EXPECT_TRUE(
      says(plain("--buildings u.geojson --trees v.geojson"),
           {"0 buildings", "1 no higher than their min_height",
            "min_height, 1 heights or sizes that are no numbers",
            "1 trees (0 with a height, 1 without), 1 heights or sizes that are no numbers"}));
}

TEST_F(ObjectsOfView, AroundTheEyeAreWarnedOf) {
  write_text(path("around.geojson"), R"({"type":"Feature","properties":{"height":90},"geometry":
      {"type":"Polygon","coordinates":[[[300,10],[450,10],[450,90],[300,90],[300,10]]]}})");
  const std::string warning = "warning: the eye is within building 1";
  EXPECT_TRUE(says(plain("--buildings around.geojson"), {warning}));
  EXPECT_FALSE(says(plain("--buildings b.geojson"), {warning}));
}

TEST_F(ObjectsOfView, HaveTheirNumbersInLayersAndCsv) {
  plain("-q --buildings b.geojson --trees t.geojson --layers l.tif --objects-csv o.csv");
  const Layers found = layers("l.tif");
  std::map<int, int> pixels;
  std::map<int, double> solid_angle_sr;
  const double k = std::tan(std::numbers::pi / 6) / 48;
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 96; ++column) {
      const double id = found.at("object_id", column, row);
      if (!(id > 0)) continue;
      const double x = (column + 0.5 - 48) * k;
      const double y = (32 - row - 0.5) * k;
      ++pixels[static_cast<int>(id)];
      solid_angle_sr[static_cast<int>(id)] += k * k / std::pow(1 + x * x + y * y, 1.5);
    }
  const Rows rows = csv_rows(bytes("o.csv"));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"id", "kind", "feature", "name", "height_m",
                                               "pixels", "solid_angle_sr", "share_visible"}));
  const std::vector<std::vector<std::string>> known{
      {"1", "building", "1"}, {"3", "building", "3"}, {"4", "tree", "1"}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = rows[i + 1];
    const int id = std::stoi(row[0]);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(row[j], known[i][j]);
    EXPECT_EQ(std::stoi(row[5]), pixels[id]);
    EXPECT_NEAR(std::stod(row[6]), solid_angle_sr[id], 1e-3 * solid_angle_sr[id] + 1e-12);
  }
  EXPECT_EQ(rows[1][3], "\"Front, \"\"old\"\"\"");
  EXPECT_EQ(rows[1][4], "40");
  EXPECT_EQ(rows[2][4], "6");
  EXPECT_EQ(rows[1][7], "1.0000");
  EXPECT_EQ(rows[2][7], "0.0000") << "6 m, all behind 40 m";
  EXPECT_GT(pixels[1], 100);
  EXPECT_GT(pixels[4], 10);
}

TEST_F(ObjectsOfView, PartlyHiddenShowTheirShare) {
  plain("-q --buildings b.geojson --default-height 60 --objects-csv o.csv --layers l.tif");
  const auto row = csv_rows(bytes("o.csv"))[2];
  // 20 m under the eye to 40 m over it at 250 m; the block before it hides all up to 20 m over the
  // eye at 150 m.
  EXPECT_NEAR(std::stod(row[7]), (40 / 250.0 - 20 / 150.0) / (60 / 250.0), 0.03);
}

TEST_F(ObjectsOfView, LookTheSameForAnyNumberOfThreads) {
  const std::string options = "-q --buildings b.geojson --trees t.geojson --soft-shadows ";
  plain(options + "--threads 1 --objects-csv o.csv");
  const std::string one = bytes("a.png");
  const std::string csv = bytes("o.csv");
  plain(options + "--threads 7 --coherence off --objects-csv o.csv");
  EXPECT_EQ(bytes("a.png"), one);
  EXPECT_EQ(bytes("o.csv"), csv);
}

TEST_F(ObjectsOfView, ThatCannotBeAreRefusedInOneLine) {
  const std::string start = "plain.asc -q --eye-xy 390,50,320 --heading 0 --size 32x24 -o x.png ";
  for (const auto& [options, said] : std::vector<std::pair<std::string, std::string>>{
           {"--objects-csv o.csv", "--objects-csv: there are no objects"},
           {"--height FIELD", "belong to buildings"},
           {"--base max", "belong to buildings"},
           {"--default-height 9", "belong to buildings"},
           {"--buildings b.geojson --height stature", "has no field 'stature'"},
           {"--buildings b.geojson --building-color 300,0,0", "has no field '300,0,0'"},
           {"--buildings nothere.geojson", "nothere.geojson"},
           {"--buildings plain.asc", "cannot be read as features"},
           {"--buildings b.geojson --default-height 0", "--default-height"},
           {"--buildings b.geojson --default-height nan", "--default-height"},
           {"--buildings b.geojson --base top", "--base"},
           {"--buildings b.geojson --objects-csv b.geojson --overwrite", "is read by this view"},
           {"--buildings b.geojson --objects-csv o.csv --preview", "--preview"}}) {
    const Finished done = run(words(start + options));
    EXPECT_EQ(done.exit_code, 2) << options;
    EXPECT_TRUE(says(done.err, {said})) << done.err;
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
  }
  write_text(path("far.geojson"), R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon",
      "coordinates":[[[9000,0],[9010,0],[9010,10],[9000,0]]]}})");
  EXPECT_TRUE(says(run(words(start + "--buildings far.geojson")).err, {"none of its features"}));
  EXPECT_TRUE(says(run(words(start + "--buildings t.geojson")).err, {"points grow trees"}));
  EXPECT_TRUE(says(run(words(start + "--trees far.geojson")).err, {"polygons are raised"}));
}

}  // namespace
}  // namespace terrview
