// The files that a view writes.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "cli/input_files.h"
#include "cli/output_file.h"
#include "cli/view_options.h"

namespace terrview {

// Claimed before the work begins; what was not asked for is null.
class ViewFiles {
 public:
  // Throws InputError for a name that cannot be written, or is used twice or by an input.
  explicit ViewFiles(const ViewOptions& options);

  // Only their names, checked as far as that needs no disk.
  struct NamesOnly {};
  ViewFiles(const ViewOptions& options, NamesOnly names_only);

  // Puts them under their names.
  void commit();

  // Whatever was asked for, the picture first.
  [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }

  std::unique_ptr<OutputFile> image;
  std::unique_ptr<OutputFile> layers;
  std::unique_ptr<OutputFile> stats;
  std::unique_ptr<OutputFile> camera;
  std::unique_ptr<OutputFile> palette;
  std::unique_ptr<OutputFile> objects_csv;
  std::unique_ptr<OutputFile> world;  // of a plan that is no tif: its world file
  std::unique_ptr<OutputFile> side;   // and GDAL's own
  std::unique_ptr<OutputFile> labels_svg;
  std::unique_ptr<OutputFile> wireline;
  std::unique_ptr<OutputFile> progressive;  // put in place whenever it has improved

 private:
  void claim_all(const ViewOptions& options);
  void check(const std::string& picture, const ViewOptions& options) const;
  std::unique_ptr<OutputFile> claim(const std::string& path, const ViewOptions& options);

  bool names_only_ = false;
  InputFiles inputs_;
  std::vector<std::string> paths_;
  std::set<std::filesystem::path> claimed_;
};

}  // namespace terrview
