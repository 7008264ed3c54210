// One palette for all pictures of a batch.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/job.h"
#include "cli/shared_inputs.h"
#include "ingest/dem.h"
#include "quantize/color.h"

namespace terrview {

// The jobs, of those without an error, whose pictures the palette is made of: some, evenly spread
// over the table, so that every shard finds the same ones.
[[nodiscard]] std::vector<const Job*> palette_jobs(const std::vector<Job>& jobs);

// The palette that the first job's options ask for, of small pictures of these jobs. What cannot be
// made is left out; throws InputError if nothing can.
[[nodiscard]] Palette make_shared_palette(const std::vector<const Job*>& jobs,
                                          const std::vector<Dem>& dems, int threads);

// Puts it under `path`, by way of `own_path`, which no other process writes. Throws InputError if
// another palette is there and is not to be replaced.
void save_shared_palette(const Palette& palette, const std::string& path,
                         const std::string& own_path, bool replaces);

}  // namespace terrview
