#include "cli/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "terrain/error.h"

namespace terrview {
namespace fs = std::filesystem;

namespace {

std::string temporary_name(const fs::path& path) {
  const std::string name = "." + path.stem().string() + ".part-" + std::to_string(::getpid()) +
                           path.extension().string();
  return (path.parent_path() / name).string();
}

}  // namespace

OutputFile::OutputFile(std::string path, bool overwrite)
    : path_(std::move(path)), temporary_path_(temporary_name(path_)) {
  std::error_code ignored;
  if (fs::is_directory(path_, ignored))
    throw InputError("'" + path_ + "': is a folder: name a file in it");
  if (fs::exists(path_, ignored) && !fs::is_regular_file(path_, ignored))
    throw InputError("'" + path_ + "': is no regular file: name one");
  if (!overwrite && fs::exists(path_, ignored))
    throw InputError("'" + path_ + "': exists already: give --overwrite to replace it");
  const int file = ::open(temporary_path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0)
    throw InputError("'" + path_ + "': cannot be written (" + std::strerror(errno) +
                     "): check its folder");
  ::close(file);
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_path_, ignored);
}

void OutputFile::fill(const std::function<void(const std::string&)>& write) {
  committed_ = false;
  try {
    write(temporary_path_);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("'" + path_ + "': writing failed: " + error.what());
  }
}

void OutputFile::commit() {
  std::error_code error;
  fs::rename(temporary_path_, path_, error);
  if (error)
    throw std::runtime_error("'" + path_ + "': cannot be put in place: " + error.message());
  committed_ = true;
  exists_ = true;
}

}  // namespace terrview
