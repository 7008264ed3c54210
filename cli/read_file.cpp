#include "cli/read_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "terrain/error.h"

namespace terrview {

std::string read_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError("'" + path + "': is a folder: name a file in it");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
    throw InputError("'" + path + "': cannot be read (" + std::strerror(errno) +
                     "): check the path");
  return bytes;
}

}  // namespace terrview
