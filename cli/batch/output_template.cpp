#include "cli/batch/output_template.h"

#include <algorithm>
#include <utility>

#include "terrain/error.h"

namespace terrview {
namespace {

constexpr const char* kIndex = "index";

bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

std::string padded(int index, int digits) {
  std::string text = std::to_string(index);
  const auto wanted = static_cast<std::size_t>(digits);
  return text.size() < wanted ? std::string(wanted - text.size(), '0') + text : text;
}

}  // namespace

OutputTemplate::OutputTemplate(std::string option, const std::string& text)
    : option_(std::move(option)), whole_(text), pieces_(1) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool doubled = i + 1 < text.size() && text[i + 1] == text[i];
    if (text[i] == '{' && !doubled) {
      const std::size_t end = text.find('}', i);
      if (end == std::string::npos) refuse("a { that is never closed: write {{ for a brace");
      pieces_.push_back(parse_hole(text.substr(i + 1, end - i - 1)));
      i = end;
    } else if (text[i] == '}' && !doubled) {
      refuse("a } without its {: write }} for a brace");
    } else {
      if (text[i] == '{' || text[i] == '}') ++i;
      pieces_.back().text += text[i];
    }
  }
}

void OutputTemplate::refuse(const std::string& what) const {
  throw InputError(option_ + " '" + whole_ + "': " + what);
}

OutputTemplate::Piece OutputTemplate::parse_hole(const std::string& hole) const {
  const std::string form = std::string(kIndex) + ":0";
  if (hole.starts_with(form) && hole.size() == form.size() + 1 && hole.back() >= '1' &&
      hole.back() <= '9')
    return {kIndex, hole.back() - '0', ""};
  if (hole.empty() || hole.starts_with(std::string(kIndex) + ":"))
    refuse("{" + hole + "}: give a column, {index} or {index:04}");
  return {hole, 0, ""};
}

std::vector<std::string> OutputTemplate::columns() const {
  std::vector<std::string> names;
  for (const Piece& piece : pieces_)
    if (!piece.column.empty() && piece.column != kIndex) names.push_back(piece.column);
  return names;
}

std::string OutputTemplate::value(const Piece& piece, const JobRow& row, int index) const {
  if (piece.column.empty()) return "";
  if (piece.column == kIndex) return padded(index, piece.digits);
  std::string cell = row.text(piece.column);
  if (cell.empty()) refuse("{" + piece.column + "} is empty here: fill the cell");
  if (cell.find('/') != std::string::npos || std::any_of(cell.begin(), cell.end(), is_control))
    refuse("{" + piece.column + "} has a / or a control character here: rename it");
  if (cell.find_first_not_of('.') == std::string::npos)
    refuse("{" + piece.column + "} is nothing but dots here: rename it");
  return cell;
}

std::string OutputTemplate::fill(const JobRow& row, int index) const {
  std::string filled;
  for (const Piece& piece : pieces_) filled += value(piece, row, index) + piece.text;
  return filled;
}

std::string OutputTemplate::numbered_pattern() const {
  std::string pattern;
  for (const Piece& piece : pieces_) {
    if (!piece.column.empty() && piece.column != kIndex) return "";
    if (!piece.column.empty())
      pattern += piece.digits > 0 ? "%0" + std::to_string(piece.digits) + "d" : "%d";
    for (const char c : piece.text) pattern += c == '%' ? "%%" : std::string(1, c);
  }
  return pattern;
}

}  // namespace terrview
