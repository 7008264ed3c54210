// Which jobs of a batch are still to be done.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/fingerprint.h"
#include "cli/batch/job.h"
#include "cli/batch/manifest.h"
#include "cli/batch/shard.h"

namespace terrview {

struct JobPlan {
  std::vector<const Job*> to_do;
  int up_to_date = 0;
  // Of jobs that are up to date and had another number before.
  std::vector<JobRecord> renumbered;
};

// What the inputs of a job are now.
[[nodiscard]] std::vector<FileStamp> inputs_now(const Job& job, InputStamps& stamps);

// A job of the shard is up to date if it was done with the options and inputs of now, and all that
// it wrote is still there, byte for byte.
[[nodiscard]] JobPlan plan_jobs(const std::vector<Job>& jobs, const Shard& shard,
                                const Manifest& before, InputStamps& stamps);

// What the jobs to do will write.
[[nodiscard]] std::vector<std::string> outputs_of(const JobPlan& plan);

}  // namespace terrview
