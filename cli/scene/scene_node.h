// A value of a scene file, read with the file's name, line and JSON pointer in every complaint.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "cli/scene/json_text.h"
#include "terrain/error.h"

namespace terrview {

// The file must outlive it. Every function throws InputError for what is not as it says.
class SceneNode {
 public:
  explicit SceneNode(const JsonText& file) : SceneNode(file, file.root(), "") {}

  [[nodiscard]] const SceneJson& json() const { return *json_; }

  // Ends with `what`, which says how to mend it.
  [[noreturn]] void fail(const std::string& what) const { file_->fail(pointer_, what); }

  // Ends with the complaint that `name` is none of `names`, which may be none.
  [[noreturn]] void fail_unknown(const std::string& name,
                                 const std::vector<std::string>& names) const;

  // Of an object; all its keys must be among `known`.
  void check_keys(const std::vector<std::string>& known) const;
  [[nodiscard]] bool has(const std::string& key) const { return json_->contains(key); }
  [[nodiscard]] SceneNode at(const std::string& key) const;
  [[nodiscard]] std::optional<SceneNode> find(const std::string& key) const;
  // In alphabetical order.
  [[nodiscard]] std::vector<std::pair<std::string, SceneNode>> members() const;

  // Of an array of at most `most` elements.
  [[nodiscard]] std::vector<SceneNode> elements(std::size_t most) const;

  [[nodiscard]] std::string text() const;
  // One of `words`.
  [[nodiscard]] std::string word(const std::vector<std::string>& words) const;

  struct Range {
    double lowest;
    double highest;
    std::string in_words;  // completes "give ..."
    bool above_lowest = false;
  };
  [[nodiscard]] double number(const Range& range) const;
  [[nodiscard]] int integer(int lowest, int highest) const;
  // Arrays of numbers.
  [[nodiscard]] std::vector<double> numbers(std::size_t count, const Range& range) const;
  [[nodiscard]] glm::dvec3 vector(const Range& range) const;

  // What `make` makes; its InputErrors are this node's.
  template <class Make>
  [[nodiscard]] auto make(const Make& make) const {
    try {
      return make();
    } catch (const InputError& error) {
      fail(error.what());
    }
  }

 private:
  SceneNode(const JsonText& file, const SceneJson& json, std::string pointer)
      : file_(&file), json_(&json), pointer_(std::move(pointer)) {}

  const JsonText* file_;
  const SceneJson* json_;
  std::string pointer_;
};

}  // namespace terrview
