// Files that are read, and so must not be written.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace terrview {

class InputFiles {
 public:
  // `reader` is for messages: this view. Names of no file are let be.
  InputFiles(const std::vector<std::string>& paths, std::string reader);

  // Throws InputError if `path` is one of them, whatever it is called; `instead` is for its
  // message.
  void refuse(const std::string& path, const std::string& instead = "write to another file") const;

 private:
  std::set<std::pair<dev_t, ino_t>> known_;
  std::string reader_;
};

}  // namespace terrview
