#include "cli/scene/scene_pictures.h"

#include <filesystem>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cli/scene/scene_paths.h"
#include "ingest/picture_source.h"

namespace terrview {
namespace {

Raster<glm::u8vec4> pixels_of(const PictureSource& source) {
  const glm::ivec2 size = source.size_px();
  std::vector<glm::u8vec3> colors;
  std::vector<std::uint8_t> valid;
  source.read(0, size.y, colors, valid);
  Raster<glm::u8vec4> picture(size.x, size.y);
  for (int row = 0; row < size.y; ++row)
    for (int column = 0; column < size.x; ++column) {
      const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
                     static_cast<std::size_t>(column);
      const std::uint8_t alpha = valid.empty() ? 255 : valid[i];
      picture.at(column, row) = glm::u8vec4(colors[i], alpha);
    }
  return picture;
}

}  // namespace

std::shared_ptr<const PicturePyramid> ScenePictures::read(const SceneNode& name) {
  const std::string path = from_folder(name.text(), folder_);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) name.fail("is no file: name a picture");
  auto& picture = known_[path];
  if (!picture)
    picture = name.make([&] {
      const PictureSource source(path);
      pixels_ += std::int64_t{source.size_px().x} * source.size_px().y;
      if (pixels_ > kMostPixels)
        throw InputError("with this the textures have more than " + std::to_string(kMostPixels) +
                         " pixels: give smaller pictures");
      return std::make_shared<const PicturePyramid>(pixels_of(source));
    });
  return picture;
}

std::vector<std::string> ScenePictures::paths() const {
  std::vector<std::string> paths;
  for (const auto& [path, picture] : known_) paths.push_back(path);
  return paths;
}

}  // namespace terrview
