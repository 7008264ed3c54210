#include "cli/batch/job.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include "cli/batch/fingerprint.h"
#include "cli/batch/output_template.h"
#include "cli/command_line.h"
#include "cli/prepare_view.h"
#include "cli/view_files.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// Neither changes a byte of what is written.
const std::set<std::string> kWithoutEffect{"threads", "quiet", "progress", "overwrite", "memory"};

using Templates = std::map<std::string, std::vector<OutputTemplate>>;

// An option as a command line has it.
std::string as_given(const std::string& name) { return (name == "o" ? "-" : "--") + name; }

Templates templates_of(const OptionValues& values, const ViewVocabulary& vocabulary) {
  Templates templates;
  for (const auto& [name, texts] : values) {
    if (vocabulary.is_common(name) && name != "o") continue;
    for (const std::string& text : texts) templates[name].emplace_back(as_given(name), text);
  }
  return templates;
}

void check_columns(const JobTable& table, const JobDefaults& defaults, const Templates& templates,
                   const ViewVocabulary& vocabulary) {
  std::set<std::string> used{"name", "id", "lat", "lon", "alt"};
  for (const auto& [name, all] : templates) {
    for (const OutputTemplate& one : all) {
      for (const std::string& column : one.columns()) {
        if (std::find(table.columns.begin(), table.columns.end(), column) == table.columns.end())
          throw InputError("{" + column + "} of " + as_given(name) +
                           ": the table has no such column: use one that it has, or {index}");
        used.insert(column);
      }
    }
  }
  for (const std::string& column : table.columns) {
    const auto option = vocabulary.option_of(column);
    if (option && vocabulary.is_common(*option) && used.count(column) == 0)
      throw InputError("column '" + column + "': holds for a whole batch: give --" + *option +
                       " on the command line");
    if (!option && used.count(column) == 0 && !defaults.ignore_columns)
      throw InputError("column '" + column + "': no option is called so: did you mean '" +
                       vocabulary.nearest(column) + "'? --ignore-columns lets such columns be");
  }
}

std::string fingerprint_of(const OptionValues& values, const std::vector<std::string>& dems) {
  std::string text = std::string("terrview ") + kVersion + '\0';
  for (const std::string& dem : dems) text += dem + '\0';
  for (const auto& [name, all] : values) {
    if (kWithoutEffect.count(name) > 0) continue;
    text += '\0' + name + '\0';
    for (const std::string& value : all) text += value + '\0';
  }
  return hash_of(text);
}

bool is_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

// Whatever an option names that is there and is not written.
std::vector<std::string> inputs_of(const OptionValues& values, const Job& job) {
  std::vector<std::string> inputs = job.options.dems;
  for (const auto& [name, all] : values) {
    for (const std::string& value : all) {
      const bool written =
          std::find(job.outputs.begin(), job.outputs.end(), value) != job.outputs.end();
      if (!written && is_file(value)) inputs.push_back(value);
    }
  }
  return inputs;
}

class JobMaker {
 public:
  JobMaker(const JobDefaults& defaults, const ViewVocabulary& vocabulary,
           const Templates& templates)
      : defaults_(defaults), vocabulary_(vocabulary), templates_(templates) {}

  [[nodiscard]] Job make(const JobRow& row, int index) const {
    Job job;
    job.index = index;
    job.name = row.text("name").empty() ? row.text("id") : row.text("name");
    try {
      if (!row.error.empty()) throw InputError(row.error);
      complete(row, job);
    } catch (const InputError& error) {
      job.error = error.what();
    }
    return job;
  }

 private:
  void complete(const JobRow& row, Job& job) const {
    OptionValues values = defaults_.values;
    for (const auto& [name, all] : templates_) {
      values[name].clear();
      for (const OutputTemplate& one : all) values[name].push_back(one.fill(row, job.index));
    }
    values = vocabulary_.with_row(std::move(values), row);
    job.fingerprint = fingerprint_of(values, defaults_.dems);
    job.options = parse_view(vocabulary_.arguments(values, defaults_.dems), "terrview view");
    job.outputs = ViewFiles(job.options, ViewFiles::NamesOnly{}).paths();
    refuse_outputs_of_row(row, job);
    job.inputs = inputs_of(values, job);
  }

  void refuse_outputs_of_row(const JobRow& row, const Job& job) const {
    for (const auto& [column, cell] : row.cells) {
      const auto option = vocabulary_.option_of(column);
      const bool written = option && std::find(job.outputs.begin(), job.outputs.end(),
                                               row.text(column)) != job.outputs.end();
      if (written)
        throw InputError("column '" + column + "': outputs are named on the command line: give --" +
                         *option + " with a template, and rename the column");
    }
  }

  const JobDefaults& defaults_;
  const ViewVocabulary& vocabulary_;
  const Templates& templates_;
};

void check_outputs_differ(const std::vector<Job>& jobs) {
  std::map<std::string, const Job*> writers;
  for (const Job& job : jobs) {
    for (const std::string& path : job.outputs) {
      const auto [writer, is_first] =
          writers.emplace(std::filesystem::absolute(path).lexically_normal().string(), &job);
      if (!is_first)
        throw InputError("'" + path + "': " + writer->second->label() + " and " + job.label() +
                         " write it: put columns or {index} into its name that tell them apart");
    }
  }
}

}  // namespace

std::string Job::label() const {
  return "job " + std::to_string(index) + (name.empty() ? "" : " (" + name + ")");
}

std::vector<Job> make_jobs(const JobTable& table, const JobDefaults& defaults) {
  const ViewVocabulary vocabulary;
  const Templates templates = templates_of(defaults.values, vocabulary);
  check_columns(table, defaults, templates, vocabulary);
  const JobMaker maker(defaults, vocabulary, templates);
  std::vector<Job> jobs;
  for (const JobRow& row : table.rows)
    jobs.push_back(maker.make(row, static_cast<int>(jobs.size()) + 1));
  check_outputs_differ(jobs);
  return jobs;
}

}  // namespace terrview
