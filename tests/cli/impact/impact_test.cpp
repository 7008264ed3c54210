// `terrview impact`: docs/cli.md and docs/impact.md.
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <regex>
#include <thread>

#include "cli/impact/impact_options.h"
#include "tests/cli/small_picture.h"
#include "tests/cli/small_view.h"

namespace terrview {
namespace {

using Names = std::vector<std::string>;

class Impact : public SmallView {
 protected:
  // Over the plain: a low block stands, a tower is planned behind it, seen from three points in the
  // south, one of which looks away, and not from one behind the block.
  Impact() {
    write_text(path("old.geojson"), collection(building(R"("height":12)", "360,200,420,240")));
    write_text(path("new.geojson"),
               collection(building(R"("height":60,"name":"<script>alert(1)</script>")",
                                   "380,300,400,320")));
    write_text(path("points.geojson"),
               collection(point(R"("name":"South","eye_height":20)", "390,50") + "," +
                          point(R"("name":"Beside, \"the\" <b>","heading":270)", "500,100") + "," +
                          point(R"("name":"Behind the block")", "390,196")));
  }

  static std::string building(const std::string& properties, const std::string& box) {
    std::array<double, 4> b{};
    std::sscanf(box.c_str(), "%lf,%lf,%lf,%lf", &b[0], &b[1], &b[2], &b[3]);
    std::string ring;
    for (const auto& [x, y] : {std::pair(b[0], b[1]), {b[2], b[1]}, {b[2], b[3]}, {b[0], b[3]}})
      ring += "[" + std::to_string(x) + "," + std::to_string(y) + "],";
    return R"({"type":"Feature","properties":{)" + properties +
           R"(},"geometry":{"type":"Polygon","coordinates":[[)" + ring + "[" +
           std::to_string(b[0]) + "," + std::to_string(b[1]) + "]]]}}";
  }

  static std::string collection(const std::string& features) {
    return R"({"type":"FeatureCollection","features":[)" + features + "]}";
  }

  static std::string point(const std::string& properties, const std::string& at) {
    return R"({"type":"Feature","properties":{)" + properties +
           R"(},"geometry":{"type":"Point","coordinates":[)" + at + "]}}";
  }

  Finished study(const std::string& more = "") const {
    return run(
        words("impact plain.asc -q --existing old.geojson --buildings new.geojson "
              "--viewpoints points.geojson --size 96x64 -o out " +
              more));
  }

  Rows table() const { return csv_rows(bytes("out/impact.csv")); }
};

TEST_F(Impact, WritesAReportItsTablesAndTheFilesOfEachViewpoint) {
  const Finished done = study();
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  std::set<std::string> expected{"impact.csv", "impact.gpkg", "report.html", "zone.tif"};
  for (const std::string number : {"01", "02", "03"})
    for (const std::string file :
         {"_before.png", "_after.png", "_difference.png", "_wireline.svg", "_scene.json"})
      expected.insert(number + file);
  EXPECT_EQ(names_in(path("out")), expected);
}

TEST_F(Impact, ChangesNoPixelOutsideTheMask) {
  ASSERT_EQ(study("--no-shadows").exit_code, 0);
  for (const std::string number : {"out/01", "out/02", "out/03"}) {
    const auto before = read_picture(path(number + "_before.png")).colors;
    const auto after = read_picture(path(number + "_after.png")).colors;
    const auto mask = read_picture(path(number + "_difference.png")).colors;
    int changed = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
      const bool differs = before[i] != after[i];
      EXPECT_EQ(differs, mask[i].x > 0) << number << ", pixel " << i;
      changed += differs ? 1 : 0;
    }
    if (number == "out/01") {
      EXPECT_GT(changed, 20);
      // Nothing beside the tower, which is 20 m across 250 m away, and no air of another colour.
      EXPECT_LT(changed, 20 / 250.0 * 96 * 64);
    } else {
      EXPECT_EQ(changed, 0);
    }
  }
}

TEST_F(Impact, GivesTheCommandsOfItsPicturesAndTheyMakeThemAgain) {
  ASSERT_EQ(study().exit_code, 0);
  const std::string report = bytes("out/report.html");
  const std::regex commands("<pre>(terrview view [^\n]*)\n(terrview view [^<]*)</pre>");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(report, found, commands));
  for (const std::size_t which : {1U, 2U}) {
    const std::string name = which == 1 ? "out/01_before.png" : "out/01_after.png";
    const std::string first = bytes(name);
    Arguments args = words(found[which]);
    args.erase(args.begin());
    args.insert(args.begin() + 1, {"--overwrite", "-q"});
    const Finished done = run(args);
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_TRUE(bytes(name) == first) << name;
  }
  ASSERT_EQ(run(words("out/01_scene.json -q -o scene.png")).exit_code, 0);
  EXPECT_TRUE(read_picture(path("scene.png")).colors ==
              read_picture(path("out/01_after.png")).colors);
}

TEST_F(Impact, SaysWhatIsSeenOfEachBuildingAndThatNothingIs) {
  ASSERT_EQ(study().exit_code, 0);
  const auto rows = table();
  ASSERT_EQ(rows.size(), 1U + 3 * 2) << "the project and its one building";
  EXPECT_EQ(rows[0][4], "seen");
  EXPECT_EQ(rows[1][4], "1");
  EXPECT_EQ(rows[3][4], "1") << "beside the block, though the picture looks away";
  EXPECT_EQ(rows[3][5], "0") << "pixels";
  EXPECT_EQ(rows[3][1], "\"Beside, \"\"the\"\" <b>\"");
  EXPECT_EQ(rows[5][4], "0");
  EXPECT_EQ(rows[5][6], "0");
  EXPECT_EQ(rows[1][9], rows[2][9]) << "one building is the whole";
  // From 20 m over the plain all of the tower but what is under 12 m at 150 m hides.
  const double hidden_m = 20 - 8 * 250 / 190.0;
  EXPECT_NEAR(std::stod(rows[1][9]), 1 - hidden_m / 60, 0.02);
  EXPECT_NEAR(std::stod(rows[1][10]), 250, 1);
}

TEST_F(Impact, KeepsMarkupOfNamesOutOfThePage) {
  ASSERT_EQ(study("--title <h1>&'").exit_code, 0);
  const std::string report = bytes("out/report.html");
  EXPECT_EQ(report.find("<script>alert"), std::string::npos);
  EXPECT_NE(report.find("&lt;script&gt;alert(1)&lt;/script&gt;"), std::string::npos);
  EXPECT_NE(report.find("Beside, &quot;the&quot; &lt;b&gt;"), std::string::npos);
  EXPECT_NE(report.find("<title>&lt;h1&gt;&amp;&#39;</title>"), std::string::npos);
}

TEST_F(Impact, IsTheSameForAnyNumberOfThreads) {
  ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  ASSERT_EQ(study("--threads 1").exit_code, 0);
  const std::string page = bytes("out/report.html");
  std::map<std::string, std::string> first;
  for (const std::string& name : names_in(path("out"))) first[name] = bytes("out/" + name);
  ASSERT_EQ(study("--threads 3 --overwrite").exit_code, 0);
  ::unsetenv("SOURCE_DATE_EPOCH");
  // The page has the command, which says how many threads.
  for (const auto& [name, before] : first) {
    const std::string now = bytes("out/" + name);
    if (name == "report.html")
      EXPECT_EQ(now.size(), before.size() + std::string("--overwrite ").size());
    else
      EXPECT_TRUE(now == before) << name;
  }
}

TEST_F(Impact, GoesOnWhereAViewpointHasNoView) {
  write_text(path("points.geojson"),
             collection(point(R"("name":"South")", "390,50") + "," +
                        point(R"("name":"Off the ground")", "9000,50") + "," +
                        point(R"("name":"Odd","fov":"wide")", "390,60")));
  const Finished done = study();
  EXPECT_EQ(done.exit_code, 3);
  EXPECT_TRUE(says(
      done.err, {"terrview: viewpoint 2 (Off the ground): ", "terrview: viewpoint 3 (Odd): --fov"}))
      << done.err;
  EXPECT_EQ(names_in(path("out")).count("01_after.png"), 1U);
  EXPECT_EQ(names_in(path("out")).count("02_after.png"), 0U);
  const std::string report = bytes("out/report.html");
  EXPECT_TRUE(says(report, {"There is no view from here: --fov",
                            "is seen from 1 of 1 viewpoint; 2 have no view."}));
  // The map does not reach for a place beside the ground.
  EXPECT_EQ(report.find("Off the ground</title>"), std::string::npos);
  EXPECT_NE(report.find(">20 m</text>"), std::string::npos);
}

TEST_F(Impact, RefusesWhatCannotBeInOneLineAndLeavesNothing) {
  const std::string start = "impact plain.asc -q ";
  const std::string project = "--buildings new.geojson ";
  const std::string points = "--viewpoints points.geojson ";
  for (const auto& [options, said] : std::vector<std::pair<std::string, std::string>>{
           {project + points, "-o: missing"},
           {project + "-o out", "--viewpoints: missing"},
           {points + "-o out", "--buildings: missing"},
           {project + points + "-o plain.asc", "is no folder"},
           {project + points + "-o out --eye-height -1", "--eye-height"},
           {project + points + "-o out --projection plan", "--projection"},
           {project + points + "-o out --projection orthographic", "--projection"},
           {project + points + "-o out --zone perhaps", "--zone"},
           {project + points + "-o out --layers a.tif", "--layers"},
           {project + "--viewpoints new.geojson -o out", "is no point"},
           {"--buildings points.geojson " + points + "-o out", "none of its features"},
           {project + points + "-o plain.asc/out", "cannot be made"}})
    expect_refused(run(words(start + options)), {said});
  EXPECT_EQ(outputs(), (Names{"new.geojson", "old.geojson", "points.geojson"}));
}

TEST_F(Impact, ReplacesAStudyOnlyWhenTold) {
  ASSERT_EQ(study("--zone off").exit_code, 0);
  const Finished again = study("--zone off");
  expect_refused(again, {"exists already: give --overwrite"});
  EXPECT_EQ(study("--zone off --overwrite").exit_code, 0);
  expect_refused(
      run(words("impact plain.asc -q --buildings new.geojson --viewpoints out/impact.gpkg "
                "-o out --overwrite")),
      {"impact.gpkg", "is read by this study"});
  EXPECT_EQ(names_in(path("out")).count("zone.tif"), 0U);
}

TEST_F(Impact, LeavesNoFileOfTheStudyItReplaces) {
  ASSERT_EQ(study().exit_code, 0);
  write_text(path("out/7_before.png"), "mine");
  write_text(path("out/notes.txt"), "mine");
  write_text(path("points.geojson"), collection(point(R"("name":"South")", "390,50") + "," +
                                                point(R"("name":"Off the ground")", "9000,50")));
  EXPECT_EQ(study("--zone off --overwrite").exit_code, 3);
  EXPECT_EQ(names_in(path("out")),
            (std::set<std::string>{"01_before.png", "01_after.png", "01_difference.png",
                                   "01_wireline.svg", "01_scene.json", "7_before.png", "impact.csv",
                                   "impact.gpkg", "notes.txt", "report.html"}));
  expect_refused(run(words("impact plain.asc -q --buildings new.geojson --viewpoints "
                           "out/01_scene.json -o out --overwrite --zone off")),
                 {"out/01_scene.json"});
}

TEST_F(Impact, FindsOfTheWholeProjectWhatItsBuildingsHaveTogether) {
  const std::string high = R"("height":60)";
  write_text(path("new.geojson"), collection(building(high, "380,300,400,320") + "," +
                                             building(high, "430,400,450,420")));
  write_text(path("points.geojson"), collection(point(R"("eye_height":20)", "390,50")));
  // The scene's ground is at 600 m, its roofs at 660 m.
  ASSERT_EQ(study("--zone off --z-scale 2").exit_code, 0);
  const Rows rows = table();
  ASSERT_EQ(rows.size(), 4U);
  const auto number = [&](std::size_t row, const char* name) {
    const auto column = std::ranges::find(rows[0], name) - rows[0].begin();
    return std::stod(rows[row].at(static_cast<std::size_t>(column)));
  };
  EXPECT_LT(number(2, "nearest_m"), number(3, "nearest_m") - 50);
  EXPECT_EQ(number(1, "nearest_m"), number(2, "nearest_m"));
  EXPECT_EQ(number(1, "farthest_m"), number(3, "farthest_m"));
  EXPECT_EQ(number(1, "pixels"), number(2, "pixels") + number(3, "pixels"));
  EXPECT_NEAR(number(1, "solid_angle_sr"),
              number(2, "solid_angle_sr") + number(3, "solid_angle_sr"), 1e-9);
  for (const char* end : {"nearest_height_m", "farthest_height_m"})
    for (const std::size_t row : {1U, 2U, 3U}) {
      EXPECT_GT(number(row, end), 300);
      EXPECT_LE(number(row, end), 330.001);
    }
}

TEST_F(Impact, ShowsNoBuildingBeforeWhereNoneStands) {
  const auto parsed =
      parse_impact(words("plain.asc --buildings new.geojson --viewpoints points.geojson -o out "
                         "--building-color 200,0,0 --default-height 9 --fov 50"));
  const OptionValues before = parsed.values_before();
  for (const char* of_buildings : {"buildings", "building-color", "default-height"}) {
    EXPECT_EQ(before.count(of_buildings), 0U) << of_buildings;
    EXPECT_EQ(parsed.values_after().count(of_buildings), 1U) << of_buildings;
  }
  EXPECT_EQ(before.at("fov"), Names{"50"});
}

// Here only its scene file cannot be written.
TEST_F(Impact, OfAViewpointThatFailsAfterAllHasNoNumbers) {
  const std::string name = "new\xff.geojson";
  std::filesystem::copy_file(path("new.geojson"), path(name));
  const Finished done =
      run(words("impact plain.asc -q --viewpoints points.geojson --size 96x64 "
                "--zone off -o out --buildings " +
                name));
  EXPECT_EQ(done.exit_code, 3);
  EXPECT_TRUE(says(done.err, {"scene file: a name in it is not UTF-8: rename the file"}));
  const Rows rows = table();
  ASSERT_EQ(rows.size(), 4U);
  for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_EQ(rows[i][4], "") << "seen";
  EXPECT_TRUE(says(bytes("out/report.html"), {"is seen from 0 of 0 viewpoints; 3 have no view."}));
}

TEST_F(Impact, InterruptedLeavesNothing) {
  Program program(words("impact plain.asc -q --existing old.geojson --buildings new.geojson "
                        "--viewpoints points.geojson --size 1600x1200 --samples 16 -o new/out"),
                  folder_.path().string());
  while (!std::filesystem::exists(path("new/out")) || names_in(path("new/out")).empty())
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(SIGINT);
  const Finished finished = program.wait();
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_EQ(finished.err, "terrview: interrupted: nothing was written\n");
  EXPECT_EQ(outputs(), (Names{"new.geojson", "old.geojson", "points.geojson"}));
}

TEST_F(Impact, FindsTheZoneThatItsViewpointsAreIn) {
  ASSERT_EQ(study().exit_code, 0);
  const GDALDatasetUniquePtr zone(GDALDataset::Open(path("out/zone.tif").c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(zone);
  EXPECT_EQ(zone->GetRasterXSize(), 80);
  const auto seen = [&](int column, int row) {
    float count = 0;
    EXPECT_EQ(zone->GetRasterBand(1)->RasterIO(GF_Read, column, row, 1, 1, &count, 1, 1,
                                               GDT_Float32, 0, 0),
              CE_None);
    return count > 0;
  };
  EXPECT_TRUE(seen(39, 55));
  EXPECT_FALSE(seen(39, 40)) << "right behind the block";
}

}  // namespace
}  // namespace terrview
