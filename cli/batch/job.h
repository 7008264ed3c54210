// The jobs of a batch: each the view of one row, as far as options and names go.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/job_table.h"
#include "cli/batch/option_values.h"
#include "cli/view_options.h"

namespace terrview {

struct Job {
  int index = 0;     // from 1
  std::string name;  // the row's name or id, may be empty
  ViewOptions options;
  std::string fingerprint;           // of what decides the outputs' bytes and names
  std::vector<std::string> inputs;   // files that options name, the DEMs first
  std::vector<std::string> outputs;  // the picture first
  std::string error;                 // not empty: cannot be done

  // For messages: job 3 (name).
  [[nodiscard]] std::string label() const;
};

struct JobDefaults {
  std::vector<std::string> dems;
  OptionValues values;          // the command line's; those with holes are templates
  bool ignore_columns = false;  // unknown ones are let be
};

// One job a row. Throws InputError for what is wrong with all of them: a column that is no option
// and that no template uses, a template's hole that is no column, two jobs with one output. What is
// wrong with one row is that job's error.
[[nodiscard]] std::vector<Job> make_jobs(const JobTable& table, const JobDefaults& defaults);

}  // namespace terrview
