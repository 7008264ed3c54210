#include "cli/scene/scene_paths.h"

#include <filesystem>

namespace terrview {
namespace {

namespace fs = std::filesystem;

bool is_the_same_everywhere(const std::string& name) {
  const fs::path path(name);
  return name.empty() || path.is_absolute() ||
         path.begin()->string().find(':') != std::string::npos;
}

using Move = std::string (*)(const std::string& name, const std::string& folder);

OptionValues move_all(OptionValues values, const std::string& folder, Move move) {
  const ViewVocabulary vocabulary;
  for (auto& [name, texts] : values)
    for (std::string& text : texts)
      if (vocabulary.names_file(name, text)) text = move(text, folder);
  return values;
}

}  // namespace

std::string from_folder(const std::string& name, const std::string& folder) {
  if (is_the_same_everywhere(name) || folder.empty()) return name;
  return (fs::path(folder) / name).string();
}

std::string to_folder(const std::string& name, const std::string& folder) {
  if (is_the_same_everywhere(name) || folder.empty()) return name;
  return fs::proximate(name, folder).string();
}

OptionValues from_folder(OptionValues values, const std::string& folder) {
  return move_all(std::move(values), folder, from_folder);
}

OptionValues to_folder(OptionValues values, const std::string& folder) {
  return move_all(std::move(values), folder, to_folder);
}

}  // namespace terrview
