#pragma once

#include <string>
#include <vector>

#include "cli/batch/manifest.h"
#include "cli/view_options.h"

namespace terrview {

struct MergedManifest {
  std::string text;          // of an undisturbed run without shards, its lines in order of the jobs
  std::vector<int> missing;  // jobs that no manifest has
  std::vector<JobRecord> failed;
};

// Throws InputError for manifests of different tables.
[[nodiscard]] MergedManifest merge(const std::vector<Manifest>& manifests);

// `terrview batch --merge MANIFEST... -o OUT`. Says which jobs are missing or have failed, and
// returns the exit code: 3 if there are any. Throws InputError.
int merge_manifests(const std::vector<std::string>& paths, const ViewOptions& options);

}  // namespace terrview
