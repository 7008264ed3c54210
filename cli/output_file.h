// A file that appears under its name only when it is complete.
#pragma once

#include <string>

namespace terrview {

class OutputFile {
 public:
  // Claims `path` by making an empty temporary file beside it, so that a folder that is missing or
  // read-only is known before the work. Throws InputError, also if `path` exists and `overwrite` is
  // false.
  OutputFile(std::string path, bool overwrite);
  ~OutputFile();  // removes the temporary file unless committed
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

  // Where to write; it has the extension of path().
  [[nodiscard]] const std::string& temporary_path() const { return temporary_path_; }

  // Renames the temporary file into place.
  void commit();

 private:
  std::string path_;
  std::string temporary_path_;
  bool committed_ = false;
};

// Writes `text` to the file's temporary path; throws std::runtime_error if it can't.
void write_text(const OutputFile& file, const std::string& text);

}  // namespace terrview
