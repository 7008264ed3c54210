// Promises of cli/batch/job_plan.h: exactly what is missing or stale.
#include "cli/batch/job_plan.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/ingest/test_raster.h"
#include "tests/support/temporary_folder.h"

namespace terrview {
namespace {

class JobPlanning : public testing::Test {
 protected:
  JobPlanning() {
    write_text(folder_ / "d.tif", "dem");
    for (int index = 1; index <= 4; ++index) {
      Job job;
      job.index = index;
      job.fingerprint = "options" + std::to_string(index);
      job.inputs = {folder_ / "d.tif"};
      job.outputs = {folder_ / (std::to_string(index) + ".png"),
                     folder_ / (std::to_string(index) + ".json")};
      for (const std::string& path : job.outputs) write_text(path, path);
      jobs_.push_back(job);
      records_.push_back({index, "", job.fingerprint, {*stamp_file(job.inputs[0])}, {}, 1, ""});
      for (const std::string& path : job.outputs)
        records_.back().outputs.push_back(*stamp_file(path));
    }
  }

  [[nodiscard]] JobPlan plan(const Shard& shard = {}) const {
    std::string text = ManifestHeader{4, {}, ""}.line();
    for (const JobRecord& record : records_) text += record.line();
    InputStamps stamps;
    return plan_jobs(jobs_, shard, parse_manifest(text, "m"), stamps);
  }

  [[nodiscard]] std::vector<int> to_do() const {
    std::vector<int> numbers;
    for (const Job* job : plan().to_do) numbers.push_back(job->index);
    return numbers;
  }

  TemporaryFolder folder_;
  std::vector<Job> jobs_;
  std::vector<JobRecord> records_;
};

using Numbers = std::vector<int>;

TEST_F(JobPlanning, LeavesAloneWhatIsUpToDate) {
  EXPECT_EQ(to_do(), Numbers());
  EXPECT_EQ(plan().up_to_date, 4);
  EXPECT_TRUE(plan().renumbered.empty());
}

TEST_F(JobPlanning, RedoesAnOutputThatIsGoneOrChanged) {
  std::filesystem::remove(folder_ / "2.json");
  std::string text = read_text(folder_ / "3.png");
  text.back() = 'x';  // of the same size
  write_text(folder_ / "3.png", text);
  EXPECT_EQ(to_do(), (Numbers{2, 3}));
}

TEST_F(JobPlanning, RedoesWhatHasOtherOptionsOrOutputs) {
  jobs_[0].fingerprint = "other";
  jobs_[3].outputs.pop_back();
  EXPECT_EQ(to_do(), (Numbers{1, 4}));
}

TEST_F(JobPlanning, RedoesAllThatReadAChangedFile) {
  write_text(folder_ / "b.geojson", "buildings");
  jobs_[1].inputs.push_back(folder_ / "b.geojson");
  EXPECT_EQ(to_do(), Numbers{2});
  write_text(folder_ / "d.tif", "DEM");
  EXPECT_EQ(to_do(), (Numbers{1, 2, 3, 4}));
  std::filesystem::remove(folder_ / "d.tif");
  EXPECT_EQ(to_do(), (Numbers{1, 2, 3, 4}));
}

TEST_F(JobPlanning, LeavesAloneWhatReadAFileThatIsOnlyYounger) {
  std::filesystem::last_write_time(folder_ / "d.tif",
                                   std::filesystem::file_time_type::clock::now());
  EXPECT_EQ(to_do(), Numbers());
}

TEST_F(JobPlanning, RedoesWhatFailedOrIsNotRecorded) {
  records_[0].error = "full";
  records_[0].outputs.clear();
  records_.erase(records_.begin() + 2);
  EXPECT_EQ(to_do(), (Numbers{1, 3}));
}

TEST_F(JobPlanning, DoesABadRowEachTimeSoThatItIsSaid) {
  jobs_[2].error = "bad";
  EXPECT_EQ(to_do(), Numbers{3});
}

TEST_F(JobPlanning, KeepsWhatARowMovedInTheTable) {
  std::swap(jobs_[0], jobs_[3]);
  std::swap(jobs_[0].index, jobs_[3].index);
  const JobPlan planned = plan();
  EXPECT_TRUE(planned.to_do.empty());
  ASSERT_EQ(planned.renumbered.size(), 2U);
  EXPECT_EQ(planned.renumbered[0].job, 1);
  EXPECT_EQ(planned.renumbered[0].outputs[0].path, folder_ / "4.png");
}

TEST_F(JobPlanning, KeepsToItsShard) {
  records_.clear();
  const JobPlan planned = plan({1, 3});
  ASSERT_EQ(planned.to_do.size(), 1U);
  EXPECT_EQ(planned.to_do[0]->index, 2);
  EXPECT_EQ(outputs_of(planned), jobs_[1].outputs);
}

}  // namespace
}  // namespace terrview
