// Texts with holes for the columns of a row: '{region}/{name}-{index:04}.png'.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/job_table.h"

namespace terrview {

// {column} is the row's cell, {index} the row's number from 1, {index:04} the same with at least
// four digits; {{ and }} are braces.
class OutputTemplate {
 public:
  // `option` is for messages. Throws InputError for braces that do not match, an empty hole, or a
  // format that is none.
  OutputTemplate(std::string option, const std::string& text);

  [[nodiscard]] bool has_holes() const { return pieces_.size() > 1; }

  // Those of the holes but index.
  [[nodiscard]] std::vector<std::string> columns() const;

  // Throws InputError where a cell is empty, or could lead elsewhere than the template says: has a
  // '/' or a control character, or is nothing but dots.
  [[nodiscard]] std::string fill(const JobRow& row, int index) const;

  // The text before the first hole.
  [[nodiscard]] const std::string& beginning() const { return pieces_.front().text; }

  // The names as a pattern of printf, where {index} is the only hole; empty elsewhere.
  [[nodiscard]] std::string numbered_pattern() const;

 private:
  // A hole and the text behind it; the first piece has no hole.
  struct Piece {
    std::string column;
    int digits = 0;
    std::string text;
  };

  [[noreturn]] void refuse(const std::string& what) const;
  [[nodiscard]] Piece parse_hole(const std::string& hole) const;
  [[nodiscard]] std::string value(const Piece& piece, const JobRow& row, int index) const;

  std::string option_;
  std::string whole_;
  std::vector<Piece> pieces_;
};

}  // namespace terrview
