// The text of a JSON file that somebody else may have written, and where in it things stand.
#pragma once

#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace terrview {

using SceneJson = nlohmann::json;

class JsonText {
 public:
  static constexpr std::size_t kDeepest = 200;                    // nesting of objects and arrays
  static constexpr std::size_t kLongest = std::size_t{16} << 20;  // bytes
  static constexpr std::size_t kLongestKey = 1000;                // bytes

  // `name` is for messages. Throws InputError, with the line, for what is longer or deeper than
  // that, is no JSON in UTF-8, has a number that no double holds, or says a key of an object twice.
  JsonText(std::string name, std::string text);

  // Of JSON that was made, not read: fail() knows no line.
  JsonText(std::string name, SceneJson root) : name_(std::move(name)), root_(std::move(root)) {}

  [[nodiscard]] const SceneJson& root() const { return root_; }
  [[nodiscard]] const std::string& name() const { return name_; }

  // Throws InputError: `name:line: pointer: what`, the line being that on which the value at a JSON
  // pointer begins.
  [[noreturn]] void fail(const std::string& pointer, const std::string& what) const;

 private:
  std::string name_;
  std::string text_;
  SceneJson root_;
};

}  // namespace terrview
