// The pictures that a scene file's textures name.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/scene/scene_node.h"
#include "render/picture_pyramid.h"

namespace terrview {

class ScenePictures {
 public:
  static constexpr std::int64_t kMostPixels = 100'000'000;  // in all

  // Names of files are relative to `folder`.
  explicit ScenePictures(std::string folder) : folder_(std::move(folder)) {}

  // Each file is read once. Throws InputError, also for what GDAL knows by a name but is no file
  // here: a scene made by somebody else fetches nothing.
  [[nodiscard]] std::shared_ptr<const PicturePyramid> read(const SceneNode& name);

  // Of the pictures that were read.
  [[nodiscard]] std::vector<std::string> paths() const;

 private:
  std::string folder_;
  std::map<std::string, std::shared_ptr<const PicturePyramid>> known_;
  std::int64_t pixels_ = 0;
};

}  // namespace terrview
