// What a table and the command line say of a view's options, as texts.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/batch/job_table.h"

namespace terrview {

class CommandLine;
struct OptionDefinition;

// By the option's long name (o for -o); a flag's value is true.
using OptionValues = std::map<std::string, std::vector<std::string>>;

// The options of `terrview view`, as its own definitions have them.
class ViewVocabulary {
 public:
  ViewVocabulary();
  ~ViewVocabulary();
  ViewVocabulary(const ViewVocabulary&) = delete;
  ViewVocabulary& operator=(const ViewVocabulary&) = delete;

  // What a parsed command line has of them.
  [[nodiscard]] OptionValues given(const CommandLine& parsed) const;

  // The option that a column sets; '_' counts as '-'. nullopt: none.
  [[nodiscard]] std::optional<std::string> option_of(const std::string& column) const;

  // Of all options that a column may set, the one that looks most like `column`.
  [[nodiscard]] std::string nearest(const std::string& column) const;

  // Whether an option is one for a whole batch: says how DEMs are read, or how the program behaves.
  [[nodiscard]] bool is_common(const std::string& option) const;

  // The second only: -o, --threads, --quiet ...
  [[nodiscard]] bool is_behaviour(const std::string& option) const;

  // Whether an option takes no value.
  [[nodiscard]] bool is_flag(const std::string& option) const;

  // Whether `value` of an option is the name of a file, rather than one of its words or a number.
  [[nodiscard]] bool names_file(const std::string& option, const std::string& value) const;

  // Of every option, in alphabetical order.
  [[nodiscard]] std::vector<std::string> names() const;

  // `values` with what the row says instead; an option that excludes one of the row's goes. A
  // flag's cell is true or false. Throws InputError for a flag that is neither.
  [[nodiscard]] OptionValues with_row(OptionValues values, const JobRow& row) const;

  // The arguments of `terrview view DEM...`.
  [[nodiscard]] std::vector<std::string> arguments(const OptionValues& values,
                                                   const std::vector<std::string>& dems) const;

 private:
  [[nodiscard]] const OptionDefinition& option(const std::string& name) const;
  void set(const std::string& name, const std::vector<std::string>& cell,
           OptionValues& values) const;

  struct Definitions;
  std::unique_ptr<Definitions> definitions_;
};

}  // namespace terrview
