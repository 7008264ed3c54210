#pragma once

#include "cli/batch/batch_options.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/job_plan.h"
#include "cli/batch/manifest.h"

namespace terrview {

// Says on standard error what failed, what was done, and how to make a film of frames. Returns the
// exit code; throws std::runtime_error if the manifest lacks lines.
int report_batch(const BatchOptions& options, const JobPlan& plan, const BatchOutcome& outcome,
                 ManifestFile& manifest);

}  // namespace terrview
