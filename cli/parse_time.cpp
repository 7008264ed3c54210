#include <chrono>
#include <optional>
#include <string_view>

#include "cli/parse.h"
#include "terrain/error.h"

namespace terrview {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError(
      "--time " + text + ": " + why +
      ": give a date, time and offset, as 2026-06-21T15:00Z or 2026-06-21T17:00+02:00");
}

// Takes pieces off the front of a text.
class Pieces {
 public:
  explicit Pieces(std::string_view text) : text_(text) {}

  // A number of exactly `digits` digits.
  std::optional<int> number(std::size_t digits) {
    if (text_.size() < digits) return std::nullopt;
    int value = 0;
    for (std::size_t i = 0; i < digits; ++i) {
      if (text_[i] < '0' || text_[i] > '9') return std::nullopt;
      value = 10 * value + (text_[i] - '0');
    }
    text_.remove_prefix(digits);
    return value;
  }

  bool take(char c) {
    if (text_.empty() || text_.front() != c) return false;
    text_.remove_prefix(1);
    return true;
  }

  // A fraction's digits, after its point.
  double fraction() {
    double value = 0;
    for (double unit = 0.1; const auto digit = number(1); unit /= 10) value += unit * *digit;
    return value;
  }

  [[nodiscard]] bool empty() const { return text_.empty(); }

 private:
  std::string_view text_;
};

std::optional<std::chrono::sys_days> take_date(Pieces& pieces) {
  const auto year = pieces.number(4);
  if (!year || !pieces.take('-')) return std::nullopt;
  const auto month = pieces.number(2);
  if (!month || !pieces.take('-')) return std::nullopt;
  const auto day = pieces.number(2);
  if (!day) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok()) return std::nullopt;
  return date;
}

std::optional<double> take_seconds_of_day(Pieces& pieces) {
  const auto hour = pieces.number(2);
  if (!hour || *hour > 23 || !pieces.take(':')) return std::nullopt;
  const auto minute = pieces.number(2);
  if (!minute || *minute > 59) return std::nullopt;
  double second = 0;
  if (pieces.take(':')) {
    const auto whole = pieces.number(2);
    if (!whole || *whole > 60) return std::nullopt;
    second = *whole;
    if (pieces.take('.')) second += pieces.fraction();
  }
  return (*hour * 60 + *minute) * 60 + second;
}

// Z, +HH, +HHMM or +HH:MM.
std::optional<int> take_offset_min(Pieces& pieces) {
  if (pieces.take('Z') || pieces.take('z')) return 0;
  const bool west = pieces.take('-');
  if (!west && !pieces.take('+')) return std::nullopt;
  const auto hours = pieces.number(2);
  if (!hours || *hours > 14) return std::nullopt;
  int minutes = 0;
  if (pieces.take(':') || !pieces.empty()) {
    const auto given = pieces.number(2);
    if (!given || *given > 59) return std::nullopt;
    minutes = *given;
  }
  return (west ? -1 : 1) * (*hours * 60 + minutes);
}

}  // namespace

double parse_time(const std::string& text) {
  Pieces pieces(text);
  const auto date = take_date(pieces);
  if (!date) refuse(text, "there is no such date");
  if (!pieces.take('T') && !pieces.take('t') && !pieces.take(' ')) refuse(text, "no time of day");
  const auto seconds = take_seconds_of_day(pieces);
  if (!seconds) refuse(text, "there is no such time of day");
  if (pieces.empty()) refuse(text, "neither Z (for UTC) nor an offset from it");
  const auto offset_min = take_offset_min(pieces);
  if (!offset_min || !pieces.empty()) refuse(text, "there is no such offset");
  constexpr double kEpoch = 2440587.5;  // of std::chrono::sys_days
  const auto days = static_cast<double>(date->time_since_epoch().count());
  return kEpoch + days + (*seconds - *offset_min * 60) / 86400;
}

}  // namespace terrview
