// Embree shares no code with terrview: what both say of the triangles is true of them.
#include "tests/bench/bench_program.h"

namespace terrview {
namespace {

TEST_F(BenchProgram, EmbreeSeesTheSameTriangles) {
  int seen = 0;
  for (const auto& result : run_.at("results")) {
    if (!result.at("contender").get<std::string>().starts_with("embree")) continue;
    if (result.at("rays") == "file-to-png") continue;
    SCOPED_TRACE(result.dump());
    ++seen;
    EXPECT_EQ(result.at("surface"), "triangles");
    EXPECT_GT(result.at("memory_mib"), 0);
    EXPECT_LE(result.at("hit_flips"), 8);  // of 851: walls seen edge on
    // The middle column of pixels looks along a grid line, where rays slip between triangles.
    if (result.at("rays") == "shadow" || result.at("view") == "gridline") continue;
    EXPECT_LE(result.at("cells_differ"), 0.02);
    EXPECT_LE(result.at("p99_rel_error"), 1e-4);
  }
  EXPECT_GT(seen, 0);
}

}  // namespace
}  // namespace terrview
