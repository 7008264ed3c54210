#include "cli/scene/scene_node.h"

#include <algorithm>
#include <cmath>

#include "cli/nearest_name.h"

namespace terrview {
namespace {

constexpr std::size_t kMostShown = 40;

// Of a text of whatever length, for a message of one line.
std::string shown(const std::string& text) {
  std::string start = text.substr(0, kMostShown);
  std::replace_if(
      start.begin(), start.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return "'" + start + (text.size() > kMostShown ? "...'" : "'");
}

}  // namespace

void SceneNode::fail_unknown(const std::string& name, const std::vector<std::string>& names) const {
  const std::string what = shown(name) + ": nothing is called so here: ";
  if (names.empty()) fail(what + "leave it out");
  // Of long names, which take long to compare, the beginning.
  const std::string nearest = nearest_name(names, name.substr(0, kMostShown));
  fail(what + "did you mean " + shown(nearest) + "?");
}

void SceneNode::check_keys(const std::vector<std::string>& known) const {
  if (!json_->is_object()) fail("give an object, as {\"" + known.front() + "\": ...}");
  for (const auto& [key, value] : json_->items())
    if (std::find(known.begin(), known.end(), key) == known.end()) at(key).fail_unknown(key, known);
}

SceneNode SceneNode::at(const std::string& key) const {
  if (!json_->is_object()) fail("give an object, as {\"" + key + "\": ...}");
  if (!has(key)) fail("'" + key + "' is missing: add it");
  return {*file_, (*json_)[key], pointer_ + (SceneJson::json_pointer() / key).to_string()};
}

std::optional<SceneNode> SceneNode::find(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  return at(key);
}

std::vector<std::pair<std::string, SceneNode>> SceneNode::members() const {
  if (!json_->is_object()) fail("give an object, as {\"name\": ...}");
  std::vector<std::pair<std::string, SceneNode>> all;
  for (const auto& [key, value] : json_->items()) all.emplace_back(key, at(key));
  return all;
}

std::vector<SceneNode> SceneNode::elements(std::size_t most) const {
  if (!json_->is_array()) fail("give an array, as [...]");
  if (json_->size() > most)
    fail("has " + std::to_string(json_->size()) + " elements: give " + std::to_string(most) +
         " at most");
  std::vector<SceneNode> all;
  for (std::size_t i = 0; i < json_->size(); ++i)
    all.push_back(SceneNode(*file_, (*json_)[i], pointer_ + "/" + std::to_string(i)));
  return all;
}

std::string SceneNode::text() const {
  constexpr std::size_t kLongest = 10'000;
  if (!json_->is_string()) fail("give a text in quotes");
  const auto& text = json_->get_ref<const std::string&>();
  if (text.size() > kLongest)
    fail("is longer than " + std::to_string(kLongest) + " letters: give a shorter one");
  return text;
}

std::string SceneNode::word(const std::vector<std::string>& words) const {
  const std::string said = text();
  if (std::find(words.begin(), words.end(), said) == words.end()) fail_unknown(said, words);
  return said;
}

double SceneNode::number(const Range& range) const {
  const double value = json_->is_number() ? json_->get<double>() : std::nan("");
  const bool low = range.above_lowest ? value <= range.lowest : value < range.lowest;
  if (!std::isfinite(value) || low || value > range.highest) fail("give " + range.in_words);
  return value;
}

int SceneNode::integer(int lowest, int highest) const {
  const std::string in_words =
      "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest);
  const double value =
      number({static_cast<double>(lowest), static_cast<double>(highest), in_words});
  if (value != std::floor(value)) fail("give " + in_words);
  return static_cast<int>(value);
}

std::vector<double> SceneNode::numbers(std::size_t count, const Range& range) const {
  if (!json_->is_array() || json_->size() != count)
    fail("give an array of " + std::to_string(count) + " numbers");
  std::vector<double> values;
  for (const SceneNode& element : elements(count)) values.push_back(element.number(range));
  return values;
}

glm::dvec3 SceneNode::vector(const Range& range) const {
  const std::vector<double> values = numbers(3, range);
  return {values[0], values[1], values[2]};
}

}  // namespace terrview
