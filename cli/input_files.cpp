#include "cli/input_files.h"

#include <sys/stat.h>

#include <optional>

#include "terrain/error.h"

namespace terrview {
namespace {

std::optional<std::pair<dev_t, ino_t>> identity(const std::string& path) {
  struct stat known {};
  if (::stat(path.c_str(), &known) != 0) return std::nullopt;
  return std::pair(known.st_dev, known.st_ino);
}

}  // namespace

InputFiles::InputFiles(const std::vector<std::string>& paths, std::string reader)
    : reader_(std::move(reader)) {
  for (const std::string& path : paths)
    if (const auto file = identity(path)) known_.insert(*file);
}

void InputFiles::refuse(const std::string& path, const std::string& instead) const {
  const auto file = identity(path);
  if (file && known_.count(*file) > 0)
    throw InputError("'" + path + "': is read by " + reader_ + ": " + instead);
}

}  // namespace terrview
