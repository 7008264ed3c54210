// A batch as its user sees it: docs/batch.md.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <thread>

#include "tests/cli/small_view.h"

namespace terrview {
namespace {

namespace fs = std::filesystem;

class Batch : public SmallView {
 protected:
  // Rows v1, v2, ... about the middle of the hills.
  void write_table(int rows, const std::string& name = "jobs.csv") const {
    std::string text = "name,eye,heading\n";
    for (int i = 1; i <= rows; ++i)
      text += "v" + std::to_string(i) + ",\"" + std::to_string(47.99 + 0.0001 * (i % 100)) +
              ",6.995,+" + std::to_string(20 + i) + "\"," + std::to_string(i * 37 % 360) + "\n";
    write_text(path(name), text);
  }

  [[nodiscard]] static Arguments line(const std::string& more = "", const std::string& out = "o") {
    const std::string size = more.find("--size") == std::string::npos ? " --size 40x30" : "";
    return words("batch jobs.csv --dem hills.tif -q -o " + out + "/{name}.png " + more + size);
  }

  // Names and bytes of the pictures in a folder; whatever else is there goes to `others`.
  [[nodiscard]] std::map<std::string, std::string> pictures(
      const std::string& folder, std::set<std::string>* others = nullptr) const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::directory_iterator(path(folder))) {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() == ".png" && name.front() != '.')
        all[name] = read_text(entry.path().string());
      else if (others)
        others->insert(name);
    }
    return all;
  }

  // The records of a manifest, the last of each job, and how many were written for it.
  [[nodiscard]] std::map<int, nlohmann::json> records(const std::string& name,
                                                      int* lines = nullptr) const {
    std::map<int, nlohmann::json> last;
    std::istringstream text(bytes(name));
    for (std::string line; std::getline(text, line);) {
      const auto json = nlohmann::json::parse(line);
      if (json.contains("batch")) continue;
      last[json.at("job")] = json;
      if (lines) ++*lines;
    }
    return last;
  }

  // Kills runs of a batch at random moments, then lets it end.
  void survive_kills(const Arguments& args, int kills, unsigned longest_ms) const {
    std::mt19937 random(7);
    for (int i = 0; i < kills; ++i) {
      Program program(args, folder_.path().string());
      std::this_thread::sleep_for(std::chrono::milliseconds(100 + random() % longest_ms));
      program.send(SIGKILL);
      static_cast<void>(program.wait());
    }
    const Finished finished = run(args, RunOptions{.patience_s = 1200});
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
  }
};

TEST_F(Batch, MakesThePicturesThatTheViewsMakeAlone) {
  write_table(3);
  EXPECT_EQ(run(line("--threads 3 --layers o/{name}.tif")).exit_code, 0);
  const auto all = pictures("o");
  ASSERT_EQ(all.size(), 3U);
  view("--eye 47.9901,6.995,+21 --heading 37 --size 40x30 -o a.png --layers a.tif");
  EXPECT_TRUE(all.at("v1.png") == bytes("a.png"));
  EXPECT_TRUE(bytes("o/v1.tif") == bytes("a.tif"));
  const auto said = records("o/jobs.jsonl");
  ASSERT_EQ(said.size(), 3U);
  EXPECT_EQ(said.at(2).at("name"), "v2");
  EXPECT_EQ(said.at(2).at("outputs").at(0).at("path"), "o/v2.png");
  EXPECT_EQ(said.at(2).at("outputs").at(0).at("bytes"), all.at("v2.png").size());
  EXPECT_TRUE(said.at(2).at("error").is_null());
}

TEST_F(Batch, SharesBuildingsDrapeAndLakesWithoutAChange) {
  write_table(4);
  write_text(path("house.geojson"),
             R"({"type": "FeatureCollection", "features": [{"type": "Feature",
             "properties": {"height": 80}, "geometry": {"type": "Polygon", "coordinates":
             [[[6.999, 48], [7.003, 48], [7.003, 48.004], [6.999, 48.004], [6.999, 48]]]}}]})");
  TestRaster picture;
  picture.columns = 20;
  picture.rows = 20;
  picture.number = [](int column, int row) { return (column * 13 + row * 7) % 256; };
  picture.geotransform = {{6.98, 0.002, 0, 48.02, 0, -0.002}};
  picture.crs = "EPSG:4326";
  picture.type = GDT_Byte;
  picture.write(path("drape.tif"));
  write_text(path("lake.geojson"),
             R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {},
             "geometry": {"type": "Polygon", "coordinates":
             [[[6.99, 48.005], [7, 48.005], [7, 48.01], [6.99, 48.01], [6.99, 48.005]]]}}]})");
  const std::string options = "--buildings house.geojson --drape drape.tif --water lake.geojson ";
  EXPECT_EQ(run(line(options + "--threads 4")).exit_code, 0);
  view(options + "--eye 47.9903,6.995,+23 --heading 111 --size 40x30 -o a.png");
  EXPECT_TRUE(pictures("o").at("v3.png") == bytes("a.png"));
  EXPECT_EQ(records("o/jobs.jsonl").at(1).at("inputs").size(), 4U);
}

TEST_F(Batch, IsTheSameForAnyNumberOfThreadsAndShards) {
  write_table(5);
  EXPECT_EQ(run(line("--threads 1", "one")).exit_code, 0);
  EXPECT_EQ(run(line("--threads 7", "many")).exit_code, 0);
  EXPECT_EQ(run(line("--threads 2 --memory 1", "little")).exit_code, 0);
  for (const std::string shard : {"0/3", "1/3", "2/3"})
    EXPECT_EQ(run(line("--shard " + shard, "shards")).exit_code, 0);
  for (const std::string folder : {"many", "little", "shards"})
    EXPECT_TRUE(pictures("one") == pictures(folder)) << folder;
  EXPECT_EQ(run(words("batch --merge shards/jobs-0-of-3.jsonl shards/jobs-2-of-3.jsonl "
                      "shards/jobs-1-of-3.jsonl -o shards/all.jsonl"))
                .exit_code,
            0);
  EXPECT_EQ(records("shards/all.jsonl").size(), 5U);
  const Finished partly = run(words("batch --merge shards/jobs-0-of-3.jsonl -o part.jsonl"));
  EXPECT_EQ(partly.exit_code, 3);
  EXPECT_TRUE(says(partly.err, {"jobs 2-3, 5"}));
}

TEST_F(Batch, ResumedDoesNothingThatIsDone) {
  write_table(4);
  EXPECT_EQ(run(line()).exit_code, 0);
  const auto before = pictures("o");
  fs::remove(path("o/v2.png"));
  write_text(path("o/v3.png"), "damaged");
  EXPECT_EQ(run(line("--resume")).exit_code, 0);
  EXPECT_TRUE(pictures("o") == before);
  int lines = 0;
  static_cast<void>(records("o/jobs.jsonl", &lines));
  EXPECT_EQ(lines, 6);
}

TEST_F(Batch, RefusesWhatIsThereUnlessResumedOrOverwritten) {
  write_table(2);
  EXPECT_EQ(run(line()).exit_code, 0);
  expect_refused(run(line()), {"o/v1.png", "--overwrite", "--resume"});
  fs::remove(path("o/v1.png"));
  fs::remove(path("o/v2.png"));
  expect_refused(run(line()), {"o/jobs.jsonl", "--resume"});
  EXPECT_EQ(run(line("--overwrite")).exit_code, 0);
  EXPECT_EQ(records("o/jobs.jsonl").size(), 2U);
}

TEST_F(Batch, LosesTheBadRowAlone) {
  write_text(path("jobs.csv"),
             "name,eye,heading,buildings\na,\"48,7,+20\",1,\nb,\"48,7,+20\",east,\n"
             "c,\"50,7,+20\",1,\nd,\"48,7,+20\",1,none.geojson\ne,\"48,7,+20\",9,\n");
  const Finished finished = run(line());
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_TRUE(says(finished.err,
                   {"job 2 (b): --heading east", "job 3 (c): ", "job 4 (d): ", "none.geojson"}));
  std::set<std::string> others;
  EXPECT_EQ(pictures("o", &others).size(), 2U);
  EXPECT_EQ(others, std::set<std::string>{"jobs.jsonl"});
  const auto said = records("o/jobs.jsonl");
  ASSERT_EQ(said.size(), 5U);
  EXPECT_TRUE(says(said.at(4).at("error"), {"none.geojson"}));
}

TEST_F(Batch, OverAVanishedDemFailsAndSaysSo) {
  write_table(3);
  EXPECT_EQ(run(line()).exit_code, 0);
  fs::rename(path("hills.tif"), path("gone.tif"));
  const Finished finished = run(line("--resume"));
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_TRUE(says(finished.err, {"job 1 (v1) (and 2 more)", "hills.tif"}));
  EXPECT_TRUE(says(records("o/jobs.jsonl").at(3).at("error"), {"hills.tif"}));
  fs::rename(path("gone.tif"), path("hills.tif"));
  EXPECT_EQ(run(line("--resume")).exit_code, 0);
  EXPECT_TRUE(records("o/jobs.jsonl").at(3).at("error").is_null());
}

TEST_F(Batch, OnAFullDiskLosesWhatDoesNotFitAndSaysSo) {
  write_text(path("jobs.csv"), "name,size\nsmall,16x12\nlarge,400x300\nmiddle,20x16\n");
  const Arguments args = words(
      "batch jobs.csv --dem hills.tif --eye 48,7,+20 --heading 9 -q -o o/{name}.png --resume");
  {
    const FullDisk disk(6000);
    const Finished finished = run(args);
    EXPECT_EQ(finished.exit_code, 3) << finished.err;
    EXPECT_TRUE(says(finished.err, {"job 2 (large)", "writing failed"}));
  }
  std::set<std::string> others;
  EXPECT_EQ(pictures("o", &others).size(), 2U);
  EXPECT_EQ(others, std::set<std::string>{"jobs.jsonl"});
  EXPECT_TRUE(says(records("o/jobs.jsonl").at(2).at("error"), {"writing failed"}));
  EXPECT_EQ(run(args).exit_code, 0);
  EXPECT_EQ(pictures("o").size(), 3U);
}

TEST_F(Batch, KilledAtAnyMomentAndResumedIsAsIfUndisturbed) {
  write_table(40);
  EXPECT_EQ(run(line("--size 64x48", "calm")).exit_code, 0);
  survive_kills(line("--resume --size 64x48 --threads 2", "killed"), 4, 500);
  std::set<std::string> others;
  EXPECT_TRUE(pictures("killed", &others) == pictures("calm"));
  EXPECT_EQ(others, std::set<std::string>{"jobs.jsonl"});
  EXPECT_EQ(records("killed/jobs.jsonl").size(), 40U);
}

TEST_F(Batch, ThatIsInterruptedLeavesAManifestToGoOnWith) {
  write_table(300);
  const Arguments args = line("--size 200x150 --threads 2");
  Program program(args, folder_.path().string());
  while (!fs::exists(path("o/v1.png"))) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(SIGTERM);
  const Finished finished = program.wait();
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_TRUE(says(finished.err, {"interrupted", "--resume"}));
  std::set<std::string> others;
  const auto done = pictures("o", &others);
  EXPECT_LT(done.size(), 300U);
  EXPECT_EQ(others, std::set<std::string>{"jobs.jsonl"});
  EXPECT_EQ(records("o/jobs.jsonl").size(), done.size());
}

TEST_F(Batch, LeavesTheTemporaryFilesOfOthersAlone) {
  write_table(1);
  fs::create_directory(path("o"));
  const std::set<std::string> foreign{".v1.part-x.png", ".v2.part-12.png", "v1.part-12.png",
                                      ".v1.part-12.tif"};
  for (const std::string& name : foreign) write_text(path("o/" + name), "precious");
  write_text(path("o/.v1.part-12.png"), "left");
  EXPECT_EQ(run(line("--resume")).exit_code, 0);
  for (const std::string& name : foreign) EXPECT_TRUE(fs::exists(path("o/" + name))) << name;
  EXPECT_FALSE(fs::exists(path("o/.v1.part-12.png")));
}

TEST_F(Batch, ThatCannotBeIsRefusedBeforeAnythingIsWritten) {
  write_table(2);
  const auto refused = [&](const std::string& args, const std::vector<std::string>& parts) {
    SCOPED_TRACE(args);
    expect_refused(run(words("batch " + args)), parts);
    EXPECT_EQ(outputs(), std::vector<std::string>{"jobs.csv"});
  };
  refused("--dem hills.tif -o {name}.png", {"JOBS"});
  refused("jobs.csv -o {name}.png", {"--dem"});
  refused("jobs.csv --dem hills.tif", {"-o", "{name}.png"});
  refused("jobs.csv --dem hills.tif -o a.png", {"a.png", "job 1 (v1)", "job 2 (v2)"});
  refused("none.csv --dem hills.tif -o {name}.png", {"none.csv"});
  refused("jobs.csv --dem hills.tif -o {name}.png --shard 3/3", {"--shard 3/3"});
  refused("jobs.csv --dem hills.tif -o {name}.jsonl --of PNG --manifest v2.jsonl", {"job 2 (v2)"});
  refused("jobs.csv --dem hills.tif -o {name}.png --progressive p.png", {"--progressive"});
  refused("--merge a.jsonl", {"-o"});
}

TEST_F(Batch, SharesOnePaletteWhateverItsShards) {
  write_table(5);
  const std::string options = "--palette 16 --shared-palette ";
  EXPECT_EQ(run(line(options, "whole")).exit_code, 0);
  EXPECT_EQ(run(line(options + "--shard 0/2", "parts")).exit_code, 0);
  EXPECT_EQ(run(line(options + "--shard 1/2", "parts")).exit_code, 0);
  EXPECT_TRUE(pictures("whole") == pictures("parts"));
  EXPECT_EQ(json("whole/jobs.palette.json").at("colors").size(), 16U);
  fs::remove(path("whole/v2.png"));
  EXPECT_EQ(run(line(options + "--resume", "whole")).exit_code, 0);
  EXPECT_TRUE(pictures("whole") == pictures("parts"));
  int lines = 0;
  static_cast<void>(records("whole/jobs.jsonl", &lines));
  EXPECT_EQ(lines, 6);
}

TEST_F(Batch, OfAPathMakesFramesAndSaysHowToFilm) {
  write_text(path("fly.csv"), "time,eye\n0,\"48,7,+20\"\n1,\"48.001,7,+40\"\n");
  const Finished finished = run(words(
      "batch --path fly.csv --fps 2 --dem hills.tif --heading 9 --size 16x12 -o o/{index:03}.png"));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(
      says(finished.err, {"ffmpeg -framerate 2 -start_number 1 -i 'o/%03d.png'", "fly.mp4"}));
  EXPECT_EQ(pictures("o").size(), 3U);
  EXPECT_EQ(records("o/fly.jsonl").size(), 3U);
}

class BatchLong : public Batch {
 protected:
  // `--resume` over views of the Vosges, in a folder.
  [[nodiscard]] static Arguments vosges(const std::string& out) {
    return words("batch jobs.csv --size 640x360 -q --resume -o " + out + "/{name}.png --dem " +
                 shared_data("vosges/N47E007.hgt") + " " + shared_data("vosges/N48E007.hgt"));
  }
};

TEST_F(BatchLong, OfAThousandViewsOfTheVosgesSurvivesTenKills) {
  NEEDS_SHARED_DATA();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  std::string text = "name,eye,heading\n";
  for (int i = 1; i <= 1000; ++i) {
    text += "v" + std::to_string(i) + ",\"" + std::to_string(47.6 + 0.4 * share(random)) + ",";
    text += std::to_string(7 + 0.3 * share(random)) + ",+" + std::to_string(20 + i / 4) + "\",";
    text += std::to_string(i * 37 % 360) + "\n";
  }
  write_text(path("jobs.csv"), text);
  ASSERT_EQ(run(vosges("calm")).exit_code, 0);
  survive_kills(vosges("killed"), 10, 20000);
  std::set<std::string> others;
  EXPECT_TRUE(pictures("killed", &others) == pictures("calm"));
  EXPECT_EQ(others, std::set<std::string>{"jobs.jsonl"});
  EXPECT_EQ(records("killed/jobs.jsonl").size(), 1000U);
}

}  // namespace
}  // namespace terrview
