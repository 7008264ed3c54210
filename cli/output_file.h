// A file that appears under its name only when it is complete.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace terrview {

class OutputFile {
 public:
  // Claims `path` by making an empty temporary file beside it, so that a folder that is missing or
  // read-only is known before the work. Throws InputError, also if `path` is no regular file, or
  // exists and `overwrite` is false.
  OutputFile(std::string path, bool overwrite);
  ~OutputFile();  // removes the temporary file unless committed
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

  // Calls `write` with the path of the temporary file, which has the extension of path(). The
  // reason it gives by a std::runtime_error gets the name of path().
  void fill(const std::function<void(const std::string& temporary_path)>& write);

  // Renames the temporary file into place. May be filled and committed again.
  void commit();

  // Whether it has ever been put in place.
  [[nodiscard]] bool exists() const { return exists_; }

 private:
  std::string path_;
  std::string temporary_path_;
  bool committed_ = false;
  bool exists_ = false;
};

// Makes the folder that `path` lies in, and those above it. Throws InputError if it cannot.
void make_folder_of(const std::string& path);

// Removes the temporary files that killed processes have left of outputs. Nobody may be writing
// these.
void remove_leftovers(const std::vector<std::string>& paths);

}  // namespace terrview
