// Text as ink on pixels, through FreeType.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <glm/vec2.hpp>

namespace terrview {

// One font at one size. Lays letters out from left to right with their kerning; scripts that join
// or reorder their letters are not shaped. Not for several threads at once.
class Font {
 public:
  // Throws InputError if `path` holds no font that FreeType reads.
  Font(const std::string& path, int size_px);
  ~Font();
  Font(Font&&) noexcept;
  Font& operator=(Font&&) noexcept;

  // How far the pen moves over a line of UTF-8; a broken character counts as U+FFFD.
  [[nodiscard]] int width_px(const std::string& text) const;

  // Of most letters, above and below the line they stand on.
  [[nodiscard]] int ascent_px() const;
  [[nodiscard]] int descent_px() const;

  // Calls ink(offset, coverage) for pixels that the text takes a share of, above 0 and up to 1;
  // where letters overlap more than once. Offsets are from the start of the line the letters stand
  // on, rows downwards.
  void draw(const std::string& text,
            const std::function<void(glm::ivec2 offset_px, float coverage)>& ink) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

// The first font file of a list of usual places (DejaVu Sans, else Liberation Sans). Throws
// InputError if there is none.
[[nodiscard]] std::string usual_font();

}  // namespace terrview
