// The whole of terrview-bench, in small: what docs/cli.md says of its files.
#include "tests/bench/bench_program.h"

#include "bench/bench_options.h"
#include "bench/contender.h"
#include "terrain/error.h"

namespace terrview {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

TEST_F(BenchProgram, SaysWhatItRanOnAndHow) {
  EXPECT_GE(run_.at("machine").at("threads").get<int>(), 1);
  EXPECT_TRUE(run_.at("machine").contains("cpu"));
  EXPECT_TRUE(run_.at("command").get<std::string>().starts_with("terrview-bench --quick"));
  EXPECT_EQ(run_.at("date").get<std::string>().size(), std::string("2026-01-01T00:00:00Z").size());
}

TEST_F(BenchProgram, EveryResultHasEveryField) {
  ASSERT_FALSE(run_.at("results").empty());
  for (const Json& result : run_.at("results")) {
    SCOPED_TRACE(result.dump());
    for (const char* field : {"dem", "view", "rays", "contender"})
      EXPECT_TRUE(result.at(field).is_string()) << field;
    EXPECT_TRUE(result.at("threads").is_number_integer());
    EXPECT_GT(result.at("mrays_per_s").get<double>(), 0);
    for (const char* field :
         {"surface", "tests_per_ray", "nodes_per_ray", "build_s", "memory_mib", "cells_differ",
          "hit_flips", "p50_rel_error", "p99_rel_error", "max_rel_error", "hit_share", "seconds"})
      EXPECT_TRUE(result.contains(field)) << field;
  }
}

TEST_F(BenchProgram, MeasuresEveryViewOfEveryScene) {
  EXPECT_EQ(values_of("dem"), (std::set<std::string>{"synthetic-65", "city-32"}));
  EXPECT_EQ(values_of("view"),
            (std::set<std::string>{"horizon", "gridline", "valley", "oblique", "down", "up"}));
  EXPECT_EQ(values_of("rays"), (std::set<std::string>{"primary", "shadow", "file-to-png"}));
}

TEST_F(BenchProgram, ThePlainTracerIsTheReference) {
  int seen = 0;
  for (const Json& result : run_.at("results")) {
    if (result.at("contender") != "terrview-plain") continue;
    SCOPED_TRACE(result.dump());
    ++seen;
    EXPECT_EQ(result.at("hit_flips"), 0);
    if (result.at("rays") == "shadow") continue;
    EXPECT_EQ(result.at("cells_differ"), 0);
    EXPECT_EQ(result.at("max_rel_error"), 0);
    EXPECT_GT(result.at("tests_per_ray"), 0);
  }
  EXPECT_GE(seen, 6 * 2 * 3 * 2);  // views, scenes, surfaces, kinds of rays
}

TEST_F(BenchProgram, EveryTracerOfTerrviewSeesWhatThePlainOneSees) {
  int seen = 0;
  for (const Json& result : run_.at("results")) {
    if (!result.at("contender").get<std::string>().starts_with("terrview")) continue;
    if (result.at("contender") == kNeighbourWay) continue;
    if (result.at("rays") == "file-to-png") continue;
    SCOPED_TRACE(result.dump());
    ++seen;
    EXPECT_EQ(result.at("hit_flips"), 0);
    if (result.at("rays") == "shadow") continue;
    EXPECT_EQ(result.at("max_rel_error"), 0);
  }
  EXPECT_GT(seen, 0);
}

TEST_F(BenchProgram, SaysWhatTheThesissRuleMisses) {
  int seen = 0;
  for (const Json& result : run_.at("results")) {
    if (result.at("contender") != kNeighbourWay) continue;
    SCOPED_TRACE(result.dump());
    ++seen;
    EXPECT_EQ(result.at("rays"), "primary");
    EXPECT_GT(result.at("tests_per_ray"), 0);
    EXPECT_LT(result.at("cells_differ"), 0.2);
    // Level views are columns of vertical planes, where nothing is missed.
    if (result.at("view") != "horizon" && result.at("view") != "gridline") continue;
    EXPECT_EQ(result.at("hit_flips"), 0);
    EXPECT_EQ(result.at("max_rel_error"), 0);
  }
  EXPECT_GE(seen, 6 * 2);
}

TEST_F(BenchProgram, TimesWholePicturesBesideEmbreesBuildAndRays) {
  std::set<std::string> contenders;
  for (const Json& result : run_.at("results")) {
    if (result.at("rays") != "file-to-png") continue;
    SCOPED_TRACE(result.dump());
    EXPECT_EQ(result.at("dem"), "synthetic-65");
    EXPECT_GT(result.at("seconds"), 0);
    EXPECT_GE(result.at("ray_count"), 37 * 23);
    const std::string contender = result.at("contender");
    contenders.insert(contender.substr(0, contender.find('-', std::string("embree-").size())));
  }
  EXPECT_TRUE(contenders.contains("terrview"));
  EXPECT_EQ(contenders.size(), embree_version().empty() ? 1U : 3U);
}

TEST_F(BenchProgram, ShowsCurvedAndBentGroundBesideFlat) {
  std::set<std::string> seen;
  for (const Json& result : run_.at("results"))
    if (result.at("rays") == "primary") seen.insert(result.at("contender").get<std::string>());
  EXPECT_TRUE(seen.contains(kCurvedWay));
  EXPECT_TRUE(seen.contains(kBentWay));
  EXPECT_NE(table_.find("Time on the curved Earth"), std::string::npos);
}

TEST_F(BenchProgram, PrintsATableAndDrawsAFigure) {
  EXPECT_NE(table_.find("synthetic-65, valley, primary rays, 1 thread"), std::string::npos);
  EXPECT_NE(table_.find("terrview-plain"), std::string::npos);
  const std::string svg = text_of(folder_ / "r.svg");
  EXPECT_NE(svg.find("terrview-plain (hyperboloid)"), std::string::npos);
  EXPECT_NE(svg.find("city-32, up"), std::string::npos);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST_F(BenchProgram, ShowsResultsAgainFromTheirFile) {
  testing::internal::CaptureStdout();
  const int code =
      run_bench({"--from", (folder_ / "r.json").string(), "--json",
                 (folder_ / "again.json").string(), "--svg", (folder_ / "again.svg").string()});
  const std::string table = testing::internal::GetCapturedStdout();
  ASSERT_EQ(code, 0);
  EXPECT_NE(table_.find(table), std::string::npos);
  EXPECT_EQ(text_of(folder_ / "again.json"), text_of(folder_ / "r.json"));
  EXPECT_EQ(text_of(folder_ / "again.svg"), text_of(folder_ / "r.svg"));
}

TEST_F(BenchProgram, PutsItsTablesBetweenTheCommentsOfAPage) {
  const fs::path page = folder_ / "page.md";
  std::ofstream(page) << "before\n<!-- terrview-bench --page: begin -->\nold\n"
                         "<!-- terrview-bench --page: end -->\nafter\n";
  testing::internal::CaptureStdout();
  ASSERT_EQ(run_bench({"--from", (folder_ / "r.json").string(), "--page", page.string()}), 0);
  testing::internal::GetCapturedStdout();
  const std::string text = text_of(page);
  EXPECT_TRUE(text.starts_with("before\n<!-- terrview-bench --page: begin -->\n"));
  EXPECT_TRUE(text.ends_with("<!-- terrview-bench --page: end -->\nafter\n"));
  EXPECT_EQ(text.find("old"), std::string::npos);
  EXPECT_NE(text.find("| synthetic-65, valley | "), std::string::npos);
  EXPECT_NE(text.find(run_.at("command").get<std::string>()), std::string::npos);
}

TEST(BenchOptions, APageWithoutAPlaceForTablesIsRefused) {
  EXPECT_THROW((void)run_bench({"--page", TERRVIEW_SOURCE_DIR "/CMakePresets.json"}), InputError);
}

TEST(BenchOptions, QuickIsSmallAndMayBeChanged) {
  const auto options = parse_bench_options({"--quick", "--size", "100x50"});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->mountain_posts, 1024);
  EXPECT_EQ(options->size_px, glm::ivec2(100, 50));
  EXPECT_EQ(options->threads[0], 1);
}

TEST(BenchOptions, AnUnknownNameIsRefused) {
  EXPECT_THROW((void)parse_bench_options({"--views", "sideways"}), InputError);
  EXPECT_THROW((void)parse_bench_options({"--scenes", "moon"}), InputError);
  EXPECT_THROW((void)parse_bench_options({"--posts", "-3"}), InputError);
}

TEST(BenchOptions, AFileThatIsNotResultsIsRefused) {
  EXPECT_THROW((void)run_bench({"--from", TERRVIEW_SOURCE_DIR "/CMakePresets.json"}), InputError);
  EXPECT_THROW((void)run_bench({"--from", "/no/such/file.json"}), InputError);
}

}  // namespace
}  // namespace terrview
