#include "cli/batch/shard.h"

#include <charconv>

#include "terrain/error.h"

namespace terrview {
namespace {

std::optional<int> whole_number(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

std::optional<int> variable(const Environment& environment, const char* name) {
  const char* text = environment(name);
  if (text == nullptr) return std::nullopt;
  const auto value = whole_number(text);
  if (!value) throw InputError(std::string(name) + "=" + text + ": is no number: give --shard I/N");
  return value;
}

std::optional<Shard> slurm_shard(const Environment& environment) {
  const auto task = variable(environment, "SLURM_ARRAY_TASK_ID");
  if (!task) return std::nullopt;
  const int first = variable(environment, "SLURM_ARRAY_TASK_MIN").value_or(0);
  const int step = variable(environment, "SLURM_ARRAY_TASK_STEP").value_or(1);
  const auto count = variable(environment, "SLURM_ARRAY_TASK_COUNT");
  if (!count)
    throw InputError("SLURM_ARRAY_TASK_COUNT: is not set in this array: give --shard I/N");
  const int offset = *task - first;
  if (step < 1 || offset < 0 || offset % step != 0 || offset / step >= *count)
    throw InputError("SLURM_ARRAY_TASK_ID=" + std::to_string(*task) +
                     ": the array has gaps, so this does not tell the shard: give --shard I/N");
  return Shard{offset / step, *count};
}

[[noreturn]] void refuse(const std::string& text, const std::string& remedy) {
  throw InputError("--shard " + text + ": " + remedy);
}

Shard checked(const Shard& shard, const std::string& text) {
  if (shard.count < 1 || shard.number >= shard.count)
    refuse(text, "I counts from 0 and is below N, as in 0/8 to 7/8");
  return shard;
}

}  // namespace

Shard find_shard(const std::string& text, const Environment& environment) {
  if (text.empty()) return slurm_shard(environment).value_or(Shard{});
  const std::size_t slash = text.find('/');
  const auto count = whole_number(slash == std::string::npos ? text : text.substr(slash + 1));
  if (!count) refuse(text, "give I/N, as 0/8, or N alone");
  if (slash != std::string::npos) {
    const auto number = whole_number(text.substr(0, slash));
    if (!number) refuse(text, "give I/N, as 0/8, or N alone");
    return checked({*number, *count}, text);
  }
  if (const auto index = variable(environment, "JOB_COMPLETION_INDEX"))
    return checked({*index, *count}, text);
  const auto slurm = slurm_shard(environment);
  if (!slurm)
    refuse(text, "neither JOB_COMPLETION_INDEX nor SLURM_ARRAY_TASK_ID is set: give I/N, as 0/8");
  return checked({slurm->number, *count}, text);
}

std::string shard_suffix(const Shard& shard) {
  if (shard.count == 1) return "";
  return "-" + std::to_string(shard.number) + "-of-" + std::to_string(shard.count);
}

}  // namespace terrview
