#include "cli/batch/merge.h"

#include <map>

#include "cli/output_file.h"
#include "cli/read_file.h"
#include "cli/say_error.h"
#include "render/write_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// 1-3, 7
std::string in_ranges(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[i]);
    if (last > i) text += "-" + std::to_string(numbers[last]);
    i = last;
  }
  return text;
}

// Where two know of a job, the one that did it has it.
std::map<int, JobRecord> last_records(const std::vector<Manifest>& manifests) {
  std::map<int, JobRecord> records;
  for (const Manifest& manifest : manifests) {
    for (const auto& [job, at] : manifest.of_job) {
      const auto [known, is_first] = records.emplace(job, manifest.records[at]);
      if (!is_first && !known->second.error.empty()) known->second = manifest.records[at];
    }
  }
  return records;
}

}  // namespace

MergedManifest merge(const std::vector<Manifest>& manifests) {
  ManifestHeader header = manifests.front().header;
  header.shard = {};
  for (const Manifest& manifest : manifests) {
    if (manifest.header.table != header.table || manifest.header.jobs != header.jobs)
      throw InputError(
          "--merge: these manifests are of different tables or options: merge those of "
          "one, after --resume if it has changed");
  }
  const std::map<int, JobRecord> records = last_records(manifests);
  MergedManifest merged{header.line(), {}, {}};
  for (int job = 1; job <= header.jobs; ++job) {
    const auto record = records.find(job);
    if (record == records.end()) {
      merged.missing.push_back(job);
      continue;
    }
    merged.text += record->second.line();
    if (!record->second.error.empty()) merged.failed.push_back(record->second);
  }
  return merged;
}

int merge_manifests(const std::vector<std::string>& paths, const ViewOptions& options) {
  OutputFile file(options.output, options.overwrite);
  std::vector<Manifest> manifests;
  for (const std::string& path : paths) {
    manifests.push_back(parse_manifest(read_file(path), path));
    if (manifests.back().header.table.empty())
      throw InputError("'" + path + "': is no manifest of a batch: name another file");
  }
  const MergedManifest merged = merge(manifests);
  file.fill([&](const std::string& path) { write_file(path, merged.text); });
  file.commit();
  for (const JobRecord& record : merged.failed)
    say_error("job " + std::to_string(record.job) + ": " + record.error);
  if (!merged.missing.empty())
    say_error("jobs " + in_ranges(merged.missing) +
              ": in none of the manifests: run their shard with --resume");
  return merged.failed.empty() && merged.missing.empty() ? 0 : 3;
}

}  // namespace terrview
