// Promises of cli/batch/job.h.
#include "cli/batch/job.h"

#include <gtest/gtest.h>

#include "terrain/error.h"
#include "tests/ingest/test_raster.h"
#include "tests/support/temporary_folder.h"

namespace terrview {
namespace {

constexpr const char* kTable =
    "name,eye,heading,no-shadows\n"
    "a,\"48,7,+2\",90,\n"
    "b,\"48,7,+3\",,true\n";

const OptionValues kPictures{{"o", {"{name}.png"}}};

OptionValues with(OptionValues values, const std::string& name, const std::string& value) {
  values[name] = {value};
  return values;
}

std::vector<Job> jobs(const std::string& csv, const OptionValues& values = kPictures,
                      bool ignore_columns = false) {
  return make_jobs(parse_job_table(csv, "t.csv"), {{"d.tif"}, values, ignore_columns});
}

std::string refusal(const std::string& csv, const OptionValues& values = kPictures) {
  try {
    static_cast<void>(jobs(csv, values));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Job, HasTheOptionsOfItsRowAndElseOfTheCommandLine) {
  const auto all = jobs(kTable, with(with(kPictures, "heading", "180"), "fov", "40"));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].error, "");
  EXPECT_EQ(all[0].index, 1);
  EXPECT_EQ(all[0].label(), "job 1 (a)");
  EXPECT_EQ(all[0].options.heading_deg, 90);
  EXPECT_EQ(all[1].options.heading_deg, 180);
  EXPECT_EQ(all[1].options.fov_deg, 40);
  EXPECT_FALSE(all[0].options.light.no_shadows);
  EXPECT_TRUE(all[1].options.light.no_shadows);
  EXPECT_EQ(all[1].options.dems, std::vector<std::string>{"d.tif"});
  EXPECT_EQ(all[1].outputs, std::vector<std::string>{"b.png"});
}

TEST(Job, TakesAFlagBackByFalse) {
  const auto all =
      jobs("name,eye,no_shadows\na,\"48,7,+2\",false\nb,\"48,7,+2\",\nc,\"48,7,+2\",maybe\n",
           with(kPictures, "no-shadows", "true"));
  EXPECT_FALSE(all[0].options.light.no_shadows);
  EXPECT_TRUE(all[1].options.light.no_shadows);
  EXPECT_TRUE(says(all[2].error, {"--no-shadows maybe", "true, false"}));
}

TEST(Job, LeavesOutWhatTheRowExcludes) {
  const auto all = jobs("name,eye,look-at,eye-xy\na,\"48,7,+2\",\"48.1,7\",\nb,,,\"1,2,3\"\n",
                        with(with(kPictures, "heading", "180"), "eye", "1,2,3"));
  EXPECT_EQ(all[0].error, "");
  EXPECT_FALSE(all[0].options.heading_deg);
  EXPECT_TRUE(all[0].options.look_at);
  EXPECT_EQ(all[1].options.heading_deg, 180);
  EXPECT_TRUE(all[1].options.eye->projected);
}

TEST(Job, TakesListsOfJson) {
  const auto all = jobs(R"([{"name": "a", "eye": [48, 7, 900], "co": ["ZLEVEL=1"]}])");
  EXPECT_EQ(all[0].error, "");
  EXPECT_EQ(all[0].options.eye->height_m, 900);
  EXPECT_EQ(all[0].options.creation.at("ZLEVEL"), "1");
}

TEST(Job, OfABadRowHasTheErrorAlone) {
  const auto all =
      jobs("name,eye,heading\na,\"48,7,+2\",east\nb,,1\nc,\"48,7,+2\",2\n/d,\"48,7,+2\",2\n");
  EXPECT_TRUE(says(all[0].error, {"--heading east"}));
  EXPECT_TRUE(says(all[1].error, {"--eye", "missing"}));
  EXPECT_EQ(all[2].error, "");
  EXPECT_TRUE(says(all[3].error, {"{name}", "/"}));
}

TEST(Job, WithAnUnknownColumnIsRefusedWithTheNearestOption) {
  EXPECT_FALSE(says(refusal("name,hel\na,1\n"), {"'help'"}));
  EXPECT_TRUE(says(refusal("name,haeding\na,1\n"), {"haeding", "'heading'", "--ignore-columns"}));
  EXPECT_EQ(jobs("name,eye,owner\na,\"48,7,+2\",x\n", kPictures, true).front().error, "");
  EXPECT_EQ(jobs("id,eye,owner\n1,\"48,7,+2\",x\n", {{"o", {"{owner}-{id}.png"}}}).front().outputs,
            std::vector<std::string>{"x-1.png"});
}

TEST(Job, IgnoresAColumnOfObjects) {
  const std::string table = R"([{"name": "a", "eye": "48,7,+2", "names": {"de": "A"}},
                                {"name": "b", "eye": "48,7,+2", "heading": {"de": 1}},
                                {"name": "c", "eye": [48, {}, 2]}])";
  const auto all = jobs(table, kPictures, true);
  EXPECT_EQ(all[0].error, "");
  EXPECT_TRUE(says(all[1].error, {"--heading"}));
  EXPECT_TRUE(says(all[2].error, {"--eye"}));
}

TEST(Job, TakesNoColumnThatHoldsForTheBatch) {
  for (const std::string column : {"window", "a-srs", "threads", "overwrite", "memory"})
    EXPECT_TRUE(says(refusal("name," + column + "\na,1\n"), {column, "command line"})) << column;
}

TEST(Job, WithATemplateOfNoColumnIsRefused) {
  EXPECT_TRUE(says(refusal("name\na\n", {{"o", {"{nmae}.png"}}}), {"{nmae} of -o:", "no such"}));
  EXPECT_TRUE(says(refusal("name\na\n", with(kPictures, "stats", "{x}")), {"{x} of --stats:"}));
}

TEST(Job, WithTheOutputOfAnotherIsRefused) {
  EXPECT_TRUE(says(refusal("name,eye\na,\"48,7,+2\"\nb,\"48,7,+2\"\na,\"48,7,+2\"\n"),
                   {"a.png", "job 1 (a)", "job 3 (a)"}));
  EXPECT_TRUE(says(refusal(kTable, with(kPictures, "stats", "s.json")), {"s.json", "job 2"}));
  EXPECT_EQ(refusal(kTable, with(kPictures, "stats", "{name}.json")), "");
}

TEST(Job, NamesOutputsOnTheCommandLineAlone) {
  const auto all = jobs("name,eye,stats\na,\"48,7,+2\",../../x.json\n");
  EXPECT_TRUE(says(all[0].error, {"column 'stats'", "command line"}));
}

TEST(Job, KnowsTheFilesThatItReads) {
  const TemporaryFolder folder;
  write_text(folder / "b.geojson", "{}");
  const auto all = jobs(kTable, with(kPictures, "buildings", folder / "b.geojson"));
  EXPECT_EQ(all[0].inputs, (std::vector<std::string>{"d.tif", folder / "b.geojson"}));
}

TEST(Job, HasAFingerprintOfWhatChangesItsOutputs) {
  const auto of = [](const OptionValues& values) { return jobs(kTable, values)[0].fingerprint; };
  const std::string plain = of(kPictures);
  for (const std::string name : {"threads", "memory"})
    EXPECT_EQ(of(with(kPictures, name, "2")), plain) << name;
  EXPECT_NE(of(with(kPictures, "fov", "2")), plain);
  EXPECT_NE(of(with(kPictures, "o", "x{name}.png")), plain);
  EXPECT_NE(jobs(kTable)[1].fingerprint, plain);
}

}  // namespace
}  // namespace terrview
