#include "cli/scene/json_text.h"

#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "ingest/shortened.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// The line of the last character read that is no blank: that of the last token.
struct Line {
  int last_token = 1;
  int current = 1;

  void pass(char c) {
    if (c == '\n')
      ++current;
    else if (c != ' ' && c != '\t' && c != '\r')
      last_token = current;
  }
};

// Characters of a text; reading on counts lines.
class CountedCharacter {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountedCharacter(const char* at, Line* line) : at_(at), line_(line) {}

  const char& operator*() const { return *at_; }
  CountedCharacter& operator++() {
    line_->pass(*at_++);
    return *this;
  }
  bool operator==(const CountedCharacter& other) const { return at_ == other.at_; }
  bool operator!=(const CountedCharacter& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Line* line_;
};

// Follows the parser through a text, up to the value at a pointer if there is one.
class Walk : public nlohmann::json_sax<SceneJson> {
 public:
  Walk(const std::string& name, std::optional<std::string> wanted)
      : name_(name), wanted_(std::move(wanted)) {}

  // The line of the wanted value, or of the last token.
  int over(const std::string& text) {
    SceneJson::sax_parse(CountedCharacter(text.data(), &line_),
                         CountedCharacter(text.data() + text.size(), &line_), this);
    return line_.last_token;
  }

  bool null() override { return value(); }
  bool boolean(bool /*value*/) override { return value(); }
  bool number_integer(number_integer_t /*value*/) override { return value(); }
  bool number_unsigned(number_unsigned_t /*value*/) override { return value(); }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return value(); }
  bool string(string_t& /*text*/) override { return value(); }
  bool binary(binary_t& /*bytes*/) override { return value(); }

  bool start_object(std::size_t /*size*/) override { return value() && open({.keys = Keys{}}); }
  bool start_array(std::size_t /*size*/) override { return value() && open({}); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (name.size() > JsonText::kLongestKey)
      refuse("a key is longer than " + std::to_string(JsonText::kLongestKey) +
             " bytes: give a shorter one");
    levels_.back().key = name;
    if (!levels_.back().keys->insert(name).second)
      refuse(shortened(pointer()) + ": is said twice: leave one");
    return true;
  }

  bool parse_error(std::size_t /*byte*/, const std::string& /*token*/,
                   const SceneJson::exception& error) override {
    if (dynamic_cast<const SceneJson::out_of_range*>(&error) != nullptr)
      refuse("a number is too large: give one that a double holds");
    refuse("broken off, or no JSON in UTF-8: check quotes, commas and brackets up to here");
  }

 private:
  using Keys = std::set<std::string>;

  struct Level {
    std::optional<Keys> keys = {};  // none: an array
    std::string key = {};
    std::size_t values = 0;
    // How much of the wanted pointer leads to this level; none: the wanted value is not in it.
    std::optional<std::size_t> matched = {};

    [[nodiscard]] std::string part() const {
      if (!keys) return "/" + std::to_string(values - 1);
      return (SceneJson::json_pointer() / key).to_string();
    }
  };

  // A value begins; false ends the walk.
  bool value() {
    matched_ = 0;
    if (!levels_.empty()) {
      ++levels_.back().values;
      matched_ = matched_with(levels_.back());
    }
    return !wanted_ || matched_ != wanted_->size();
  }

  [[nodiscard]] std::optional<std::size_t> matched_with(const Level& level) const {
    if (!wanted_ || !level.matched) return std::nullopt;
    const std::string part = level.part();
    if (wanted_->compare(*level.matched, part.size(), part) != 0) return std::nullopt;
    const std::size_t end = *level.matched + part.size();
    if (end < wanted_->size() && (*wanted_)[end] != '/') return std::nullopt;
    return end;
  }

  bool open(Level level) {
    if (levels_.size() >= JsonText::kDeepest)
      refuse("nests deeper than " + std::to_string(JsonText::kDeepest) + ": make it flatter");
    level.matched = matched_;
    levels_.push_back(std::move(level));
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  [[nodiscard]] std::string pointer() const {
    std::string text;
    for (const Level& level : levels_) text += level.part();
    return text;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(line_.last_token) + ": " + what);
  }

  const std::string& name_;
  std::optional<std::string> wanted_;
  Line line_;
  std::vector<Level> levels_;
  std::optional<std::size_t> matched_;  // Level::matched of the value that begins
};

}  // namespace

JsonText::JsonText(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)) {
  if (text_.size() > kLongest)
    throw InputError(name_ + ": is longer than " + std::to_string(kLongest >> 20) +
                     " MiB: a scene refers to its data by the names of files");
  Walk(name_, std::nullopt).over(text_);
  root_ = SceneJson::parse(text_);
}

void JsonText::fail(const std::string& pointer, const std::string& what) const {
  const std::string line =
      text_.empty() ? "" : ":" + std::to_string(Walk(name_, pointer).over(text_));
  const std::string place = shortened(pointer);
  throw InputError(name_ + line + ": " + (place.empty() ? "" : place + ": ") + what);
}

}  // namespace terrview
