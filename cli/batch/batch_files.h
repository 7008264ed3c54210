// What a batch writes beside its pictures, and what it must not write over.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/batch_options.h"
#include "cli/batch/job.h"
#include "cli/batch/shard.h"

namespace terrview {

// Unless the options name it: in the folder that -o names before its first hole.
[[nodiscard]] std::string manifest_path(const BatchOptions& options, const Shard& shard);

// Of the palette of all pictures, beside the outputs; `suffix` tells the files of processes apart.
[[nodiscard]] std::string palette_path(const BatchOptions& options, const std::string& suffix = "");

// Throws InputError if the batch would write over a file that it reads, or two of its own over one
// another, or, unless it replaces them, if outputs or the manifest of the shard exist.
void check_batch_files(const BatchOptions& options, const Shard& shard,
                       const std::vector<Job>& jobs);

}  // namespace terrview
