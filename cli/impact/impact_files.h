// The files of a study.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "cli/impact/impact_options.h"
#include "cli/output_file.h"

namespace terrview {

// Claimed before the work begins, so that they appear together when it is done, or not at all.
class ImpactFiles {
 public:
  struct OfViewpoint {
    std::unique_ptr<OutputFile> before;
    std::unique_ptr<OutputFile> after;
    std::unique_ptr<OutputFile> difference;
    std::unique_ptr<OutputFile> wireline;
    std::unique_ptr<OutputFile> scene;
    bool complete = false;  // others stay away
  };

  // Makes the folder of the options if need be. Throws InputError for what cannot be written, is
  // read by the study, or exists already and is not to be replaced.
  ImpactFiles(const ImpactOptions& options, int viewpoints);
  ~ImpactFiles();  // removes the folder if nothing came into it
  ImpactFiles(const ImpactFiles&) = delete;
  ImpactFiles& operator=(const ImpactFiles&) = delete;

  // Files of a study that stood there before, and are none of these, are removed.
  void commit();

  std::vector<OfViewpoint> viewpoints;
  std::unique_ptr<OutputFile> zone;  // null without one
  std::unique_ptr<OutputFile> table;
  std::unique_ptr<OutputFile> features;
  std::unique_ptr<OutputFile> report;

 private:
  void remove_made() const;

  std::filesystem::path folder_;
  std::filesystem::path made_;                 // the topmost folder that was made; may be empty
  std::vector<std::filesystem::path> former_;  // files of the study that is replaced
};

}  // namespace terrview
