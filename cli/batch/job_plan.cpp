#include "cli/batch/job_plan.h"

#include <algorithm>

namespace terrview {
namespace {

bool is_untouched(const FileStamp& output) { return stamp_file(output.path) == output; }

bool wrote(const JobRecord& record, const std::vector<std::string>& outputs) {
  const auto same_path = [](const FileStamp& stamp, const std::string& path) {
    return stamp.path == path;
  };
  return std::equal(record.outputs.begin(), record.outputs.end(), outputs.begin(), outputs.end(),
                    same_path);
}

// The record of a job that is up to date; null if it is not.
const JobRecord* find_record(const Job& job, const Manifest& before, InputStamps& stamps) {
  if (!job.error.empty()) return nullptr;
  const auto known = before.of_output.find(job.outputs.front());
  if (known == before.of_output.end()) return nullptr;
  const JobRecord& record = before.records[known->second];
  const bool same = record.error.empty() && record.options == job.fingerprint &&
                    wrote(record, job.outputs) && record.inputs == inputs_now(job, stamps) &&
                    std::all_of(record.outputs.begin(), record.outputs.end(), is_untouched);
  return same ? &record : nullptr;
}

}  // namespace

std::vector<FileStamp> inputs_now(const Job& job, InputStamps& stamps) {
  std::vector<FileStamp> all;
  for (const std::string& path : job.inputs) {
    const std::vector<FileStamp>& of_path = stamps.of(path);
    all.insert(all.end(), of_path.begin(), of_path.end());
  }
  return all;
}

JobPlan plan_jobs(const std::vector<Job>& jobs, const Shard& shard, const Manifest& before,
                  InputStamps& stamps) {
  JobPlan plan;
  for (const Job& job : jobs) {
    if (!shard.has(job.index)) continue;
    const JobRecord* record = find_record(job, before, stamps);
    if (record == nullptr) {
      plan.to_do.push_back(&job);
      continue;
    }
    ++plan.up_to_date;
    const auto last = before.of_job.find(job.index);
    if (last == before.of_job.end() || &before.records[last->second] != record) {
      plan.renumbered.push_back(*record);
      plan.renumbered.back().job = job.index;
      plan.renumbered.back().name = job.name;
    }
  }
  return plan;
}

std::vector<std::string> outputs_of(const JobPlan& plan) {
  std::vector<std::string> paths;
  for (const Job* job : plan.to_do)
    paths.insert(paths.end(), job->outputs.begin(), job->outputs.end());
  return paths;
}

}  // namespace terrview
