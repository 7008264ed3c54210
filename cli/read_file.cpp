#include "cli/read_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "terrain/error.h"

namespace terrview {

std::string read_file(const std::string& path) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad() || errno == EISDIR)
    throw InputError("'" + path + "': cannot be read (" + std::strerror(errno) +
                     "): check the path");
  return bytes;
}

}  // namespace terrview
