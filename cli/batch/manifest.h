// What became of each job: JSON lines beside the outputs, only ever appended to.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "cli/batch/fingerprint.h"
#include "cli/batch/shard.h"

namespace terrview {

// The first line of every run.
struct ManifestHeader {
  int jobs = 0;  // of the whole table
  Shard shard;
  std::string table;  // fingerprint of all jobs' options

  [[nodiscard]] std::string line() const;
};

struct JobRecord {
  int job = 0;          // from 1
  std::string name;     // as the table has it
  std::string options;  // fingerprint
  std::vector<FileStamp> inputs;
  std::vector<FileStamp> outputs;
  double seconds = 0;
  std::string error;  // empty: done

  [[nodiscard]] std::string line() const;
};

struct Manifest {
  ManifestHeader header;  // the last
  std::vector<JobRecord> records;
  std::map<int, std::size_t> of_job;             // the last of each, of the last table
  std::map<std::string, std::size_t> of_output;  // that wrote it last
};

// A last line without an end is left out: whoever wrote it was killed. `name` is for messages.
// Throws InputError for other lines that are none of a manifest.
[[nodiscard]] Manifest parse_manifest(std::string_view text, const std::string& name);

// Throws InputError if the file exists; an empty one is none.
void check_is_new(const std::string& path);

// A manifest that is being written; one process at a time.
class ManifestFile {
 public:
  enum class Existing { refuse, go_on, replace };

  // Throws InputError where it cannot be written, exists against `existing`, holds what is no
  // manifest, or another process writes it.
  ManifestFile(std::string path, Existing existing);
  ~ManifestFile();
  ManifestFile(const ManifestFile&) = delete;
  ManifestFile& operator=(const ManifestFile&) = delete;

  // What it held at first.
  [[nodiscard]] const Manifest& before() const { return before_; }
  [[nodiscard]] const std::string& path() const { return path_; }

  // Keeps room for so many lines on the disk, where the file system can: a disk that outputs have
  // filled still takes them.
  void reserve(std::size_t lines);

  // From any thread. The line is on the disk when this returns, unless the disk is full: then it is
  // tried again with the next one.
  void append(const std::string& line);

  // Whether all lines are on the disk.
  [[nodiscard]] bool complete();

 private:
  void write_pending();

  std::string path_;
  int file_;
  Manifest before_;
  std::mutex mutex_;
  std::string pending_;
};

}  // namespace terrview
