// What tells whether a file or an option has changed.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace terrview {

// XXH3 of 128 bits, as 32 hexadecimal digits.
[[nodiscard]] std::string hash_of(std::string_view bytes);

struct FileStamp {
  std::string path;
  std::uint64_t bytes = 0;
  std::string xxh3;

  bool operator==(const FileStamp&) const = default;
};

// By content; nullopt if `path` is no regular file that can be read.
[[nodiscard]] std::optional<FileStamp> stamp_file(const std::string& path);

// Stamps of files that many views read, made once.
class InputStamps {
 public:
  // Of a file and of those that GDAL reads with it; empty where there is no such file.
  const std::vector<FileStamp>& of(const std::string& path);

 private:
  std::map<std::string, std::vector<FileStamp>> known_;
};

}  // namespace terrview
