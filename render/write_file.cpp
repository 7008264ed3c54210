#include "render/write_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace terrview {

void write_file(const std::string& path, std::string_view bytes) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw std::runtime_error(std::generic_category().message(errno));
}

}  // namespace terrview
