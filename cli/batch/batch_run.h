// Several views at once, over DEMs that they share.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/fingerprint.h"
#include "cli/batch/job.h"
#include "cli/batch/manifest.h"
#include "cli/progress.h"
#include "ingest/dem.h"

namespace terrview {

struct BatchRunOptions {
  int threads = 0;  // of all views together; 0 = all the processor has
  double memory_bytes = 0;
  ShowBar show_bar = ShowBar::never;
};

// What making a view over these DEMs, of which there is one, takes beside what views share, as
// measured.
[[nodiscard]] double view_bytes(const Job& job, const std::vector<Dem>& dems);

// How many views to have in flight: a thread each, unless there are fewer views, or more would need
// more memory than there is. At least one.
[[nodiscard]] int views_in_flight(const std::vector<const Job*>& jobs, const std::vector<Dem>& dems,
                                  int threads, double memory_bytes);

struct FailedJob {
  const Job* job;
  std::string error;
};

struct BatchOutcome {
  int done = 0;
  std::vector<FailedJob> failed;
  bool interrupted = false;
};

// What was read once for all: the DEMs, or why they could not be read.
struct BatchGround {
  std::vector<Dem> dems;
  std::string error;  // not empty: every view fails by it
};

// Does every job, and writes a line for each into the manifest as soon as its files are in place.
// What a job throws costs that job alone; an interrupt ends all of them, without a line.
[[nodiscard]] BatchOutcome run_jobs(const std::vector<const Job*>& jobs, const BatchGround& ground,
                                    InputStamps& stamps, ManifestFile& manifest,
                                    const BatchRunOptions& options);

}  // namespace terrview
