#include "cli/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "terrain/error.h"

namespace terrview {
namespace fs = std::filesystem;

namespace {

std::string temporary_beginning(const fs::path& path) {
  return "." + path.stem().string() + ".part-";
}

std::string temporary_name(const fs::path& path) {
  const std::string name =
      temporary_beginning(path) + std::to_string(::getpid()) + path.extension().string();
  return (path.parent_path() / name).string();
}

// Its name with nothing for the process's number; empty if it is no temporary file's.
std::string without_number(const std::string& name) {
  const std::size_t mark = name.rfind(".part-");
  if (mark == std::string::npos || name.front() != '.') return "";
  const std::size_t number = mark + 6;
  const std::size_t end = std::min(name.find_first_not_of("0123456789", number), name.size());
  return end > number ? name.substr(0, number) + name.substr(end) : "";
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

void make_folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error)
    throw InputError("'" + path + "': its folder cannot be made (" + error.message() +
                     "): name another");
}

void remove_leftovers(const std::vector<std::string>& paths) {
  std::map<fs::path, std::set<std::string>> names;
  for (const fs::path path : paths) {
    const std::string name = temporary_beginning(path) + path.extension().string();
    names[path.parent_path()].insert({name, name + ".tif"});  // of an indexed picture
  }
  for (const auto& [folder, wanted] : names) {
    std::error_code ignored;
    std::vector<fs::path> leftovers;
    for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored))
      if (wanted.count(without_number(entry.path().filename().string())) > 0)
        leftovers.push_back(entry.path());
    for (const fs::path& leftover : leftovers) fs::remove(leftover, ignored);
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
