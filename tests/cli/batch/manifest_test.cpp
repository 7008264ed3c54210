// Promises of cli/batch/manifest.h and cli/batch/merge.h.
#include "cli/batch/manifest.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "cli/batch/merge.h"
#include "terrain/error.h"
#include "tests/cli/program.h"
#include "tests/ingest/test_raster.h"
#include "tests/support/temporary_folder.h"

namespace terrview {
namespace {

using Existing = ManifestFile::Existing;

JobRecord record(int job, const std::string& error = "") {
  JobRecord record{job, "n" + std::to_string(job), "0f", {{"d.tif", 5, "aa"}}, {}, 0.25, error};
  if (error.empty()) record.outputs = {{std::to_string(job) + ".png", 9, "bb"}};
  return record;
}

ManifestHeader header(int jobs, Shard shard = {}) { return {jobs, shard, "table"}; }

TEST(Manifest, IsReadAsWritten) {
  const std::string text = header(9, {2, 3}).line() + record(3).line() + record(6, "full").line();
  const Manifest manifest = parse_manifest(text, "m");
  EXPECT_EQ(manifest.header.jobs, 9);
  EXPECT_EQ(manifest.header.shard.number, 2);
  EXPECT_EQ(manifest.header.shard.count, 3);
  ASSERT_EQ(manifest.records.size(), 2U);
  EXPECT_EQ(manifest.header.line() + manifest.records[0].line() + manifest.records[1].line(), text);
}

TEST(Manifest, TornAnywhereKeepsItsWholeLines) {
  const std::string text = header(2).line() + record(1).line() + record(2).line();
  for (std::size_t n = 0; n <= text.size(); ++n) {
    const auto lines =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(n), '\n');
    EXPECT_EQ(parse_manifest(text.substr(0, n), "m").records.size(),
              static_cast<std::size_t>(std::max<std::ptrdiff_t>(lines - 1, 0)));
  }
}

TEST(Manifest, ThatIsNoneIsRefused) {
  for (const std::string text : {"x\n", "{}\n", "[1]\n", "{\"batch\": 1}\n", "{\"job\": \"a\"}\n"})
    EXPECT_THROW(static_cast<void>(parse_manifest(text, "m")), InputError) << text;
}

TEST(ManifestFile, GoesOnBehindTheLastWholeLine) {
  const TemporaryFolder folder;
  const std::string whole = header(3).line() + record(1).line();
  write_text(folder / "m.jsonl", whole + "{\"job\": 2, \"na");
  {
    ManifestFile file(folder / "m.jsonl", Existing::go_on);
    EXPECT_EQ(file.before().records.size(), 1U);
    file.reserve(10);
    file.append(record(3).line());
    EXPECT_TRUE(file.complete());
    EXPECT_EQ(read_text(folder / "m.jsonl"), whole + record(3).line());
  }
  EXPECT_EQ(read_text(folder / "m.jsonl"), whole + record(3).line());
}

TEST(ManifestFile, ThatExistsIsRefusedUnlessGoneOnWithOrReplaced) {
  const TemporaryFolder folder;
  write_text(folder / "m.jsonl", header(3).line());
  EXPECT_THROW(ManifestFile(folder / "m.jsonl", Existing::refuse), InputError);
  EXPECT_EQ(read_text(folder / "m.jsonl"), header(3).line());
  { const ManifestFile file(folder / "m.jsonl", Existing::replace); }
  EXPECT_EQ(read_text(folder / "m.jsonl"), "");
  { const ManifestFile file(folder / "m.jsonl", Existing::refuse); }
  EXPECT_THROW(ManifestFile(folder / "none/m.jsonl", Existing::refuse), InputError);
}

TEST(ManifestFile, ReplacesNoOtherKindOfFile) {
  const TemporaryFolder folder;
  for (const std::string text :
       {"II*\x01", "II*\n\x02", "[{\"name\": \"a\"}]", "name,eye\na,1\n"}) {
    write_text(folder / "mine", text);
    for (const Existing existing : {Existing::refuse, Existing::go_on, Existing::replace}) {
      EXPECT_THROW(ManifestFile(folder / "mine", existing), InputError) << text;
      EXPECT_EQ(read_text(folder / "mine"), text);
    }
  }
  for (const std::size_t torn : {1U, 9U, 12U, 30U}) {
    write_text(folder / "mine", header(3).line().substr(0, torn));
    EXPECT_NO_THROW(ManifestFile(folder / "mine", Existing::go_on)) << torn;
  }
}

TEST(ManifestFile, IsOneProcesssAtATime) {
  const TemporaryFolder folder;
  const ManifestFile first(folder / "m.jsonl", Existing::refuse);
  EXPECT_THROW(ManifestFile(folder / "m.jsonl", Existing::go_on), InputError);
}

TEST(ManifestFile, HoldsWholeLinesAloneThoughTheDiskIsFull) {
  const TemporaryFolder folder;
  ManifestFile file(folder / "m.jsonl", Existing::refuse);
  file.append(record(1).line());
  {
    const FullDisk disk(record(1).line().size() + 10);
    file.append(record(2).line());
    EXPECT_FALSE(file.complete());
    EXPECT_EQ(read_text(folder / "m.jsonl"), record(1).line());
  }
  file.append(record(3).line());
  EXPECT_TRUE(file.complete());
  EXPECT_EQ(read_text(folder / "m.jsonl"), record(1).line() + record(2).line() + record(3).line());
}

RC_GTEST_PROP(MergeProperty, OfShardsIsTheManifestOfAnUndisturbedRun, ()) {
  const int jobs = *rc::gen::inRange(1, 30);
  const int count = *rc::gen::inRange(1, 6);
  std::string undisturbed = header(jobs).line();
  for (int job = 1; job <= jobs; ++job) undisturbed += record(job).line();
  std::vector<Manifest> shards;
  for (int number = 0; number < count; ++number) {
    std::vector<std::string> lines;
    for (int job = 1; job <= jobs; ++job)
      if (Shard{number, count}.has(job)) lines.push_back(record(job).line());
    // In whatever order they were done, some of them after a failure.
    std::string text = header(jobs, {number, count}).line();
    if (!lines.empty() && *rc::gen::arbitrary<bool>()) text += record(1 + number, "full").line();
    std::reverse(lines.begin(), lines.end());
    for (const std::string& line : lines) text += line;
    shards.push_back(parse_manifest(text, "m"));
  }
  const MergedManifest merged = merge(shards);
  RC_ASSERT(merged.text == undisturbed);
  RC_ASSERT(merged.missing.empty() && merged.failed.empty());
}

TEST(Merge, KnowsWhatIsMissingAndWhatFailed) {
  const Manifest first =
      parse_manifest(header(6, {0, 2}).line() + record(1).line() + record(3, "full").line(), "m");
  const Manifest second = parse_manifest(header(6, {1, 2}).line() + record(2).line(), "m");
  const MergedManifest merged = merge({first, second});
  EXPECT_EQ(merged.missing, (std::vector<int>{4, 5, 6}));
  ASSERT_EQ(merged.failed.size(), 1U);
  EXPECT_EQ(merged.failed[0].job, 3);
}

TEST(Merge, KnowsNothingOfATableBeforeTheLast) {
  ManifestHeader changed = header(3);
  changed.table = "changed";
  const std::string before = header(3).line() + record(1).line() + record(2).line();
  const std::string after = changed.line() + record(2).line() + changed.line();
  const Manifest manifest = parse_manifest(before + after, "m");
  EXPECT_EQ(merge({manifest}).missing, (std::vector<int>{1, 3}));
  EXPECT_EQ(manifest.of_output.count("1.png"), 1U);  // still there to be compared
}

TEST(Merge, OfDifferentTablesIsRefused) {
  const Manifest first = parse_manifest(header(6).line(), "m");
  const Manifest second = parse_manifest(header(7).line(), "m");
  EXPECT_THROW(static_cast<void>(merge({first, second})), InputError);
}

}  // namespace
}  // namespace terrview
