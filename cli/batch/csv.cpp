#include "cli/batch/csv.h"

#include "terrain/error.h"

namespace terrview {
namespace {

char separator_of(std::string_view text) {
  const std::string_view first = text.substr(0, text.find('\n'));
  for (const char separator : {',', ';', '\t'})
    if (first.find(separator) != std::string_view::npos) return separator;
  return ',';
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& name)
      : text_(text), name_(name), separator_(separator_of(text)) {}

  std::vector<CsvRecord> records() {
    std::vector<CsvRecord> all;
    while (at_ < text_.size()) {
      CsvRecord record = next_record();
      if (record.cells.size() > 1 || !record.cells.front().empty())
        all.push_back(std::move(record));
    }
    return all;
  }

 private:
  CsvRecord next_record() {
    CsvRecord record{line_, {}};
    do {
      record.cells.push_back(at_ < text_.size() && text_[at_] == '"' ? quoted() : plain());
    } while (at_ < text_.size() && text_[at_++] == separator_);
    ++line_;
    return record;
  }

  // Whether the line ends here; steps over a CR.
  bool ends() {
    if (text_.substr(at_, 2) == "\r\n" || text_.substr(at_) == "\r") ++at_;
    return at_ == text_.size() || text_[at_] == '\n';
  }

  std::string plain() {
    std::string cell;
    while (!ends() && text_[at_] != separator_) cell += text_[at_++];
    return cell;
  }

  std::string quoted() {
    const int first_line = line_;
    std::string cell;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"' && text_.substr(at_ + 1, 1) != "\"") break;
      if (text_[at_] == '"') ++at_;
      if (text_[at_] == '\n') ++line_;
      cell += text_[at_];
    }
    if (at_ == text_.size()) refuse(first_line, "a quote that is never closed");
    ++at_;
    if (!ends() && text_[at_] != separator_) refuse(line_, "text after a closing quote");
    return cell;
  }

  [[noreturn]] void refuse(int line, const std::string& what) const {
    throw InputError("'" + name_ + "', line " + std::to_string(line) + ": " + what +
                     ": quote the cell, and double the quotes in it");
  }

  std::string_view text_;
  const std::string& name_;
  char separator_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

std::vector<CsvRecord> parse_csv(std::string_view text, const std::string& name) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return Reader(text, name).records();
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace terrview
