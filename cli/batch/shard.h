// One process's part of a batch that several work on without talking to each other.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace terrview {

// Has the jobs 1 + number, 1 + number + count, ...
struct Shard {
  int number = 0;  // from 0
  int count = 1;

  [[nodiscard]] bool has(int job) const { return (job - 1) % count == number; }
};

// Of the environment; null where a variable is not set.
using Environment = std::function<const char*(const char* name)>;

// The shard that `text` of --shard names: I/N, or N alone where the environment tells I. An empty
// text: the whole of a Slurm array, if this is a task of one; else everything. Throws InputError.
[[nodiscard]] Shard find_shard(const std::string& text, const Environment& environment);

// "-I-of-N", or nothing where one shard is all.
[[nodiscard]] std::string shard_suffix(const Shard& shard);

}  // namespace terrview
