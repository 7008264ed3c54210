#include "render/text.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "terrain/error.h"

namespace terrview {
namespace {

constexpr std::uint32_t kReplacement = 0xfffd;
constexpr int kUnits = 64;  // of FreeType, a pixel

// The character at the front of `text`, which is cut off it.
std::uint32_t take_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80           ? 1
                             : (first >> 5) == 0x06 ? 2
                             : (first >> 4) == 0x0e ? 3
                             : (first >> 3) == 0x1e ? 4
                                                    : 0;
  std::uint32_t code = length == 1 ? first : first & (0xffU >> (length + 1));
  bool whole = length > 0 && length <= text.size();
  for (std::size_t i = 1; whole && i < length; ++i) {
    whole = (byte(i) & 0xc0U) == 0x80;
    code = code << 6 | (byte(i) & 0x3fU);
  }
  text.remove_prefix(whole ? length : 1);
  return whole ? code : kReplacement;
}

}  // namespace

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Face() = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  ~Face() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }

  // Calls take(pen) with every letter rendered in face->glyph, and returns where the pen ends, in
  // FreeType's units.
  template <class Take>
  long set(std::string_view text, FT_Int32 flags, const Take& take) const {
    long pen = 0;
    FT_UInt before = 0;
    while (!text.empty()) {
      const FT_UInt glyph = FT_Get_Char_Index(face, take_character(text));
      FT_Vector kerning{};
      if (before != 0 && glyph != 0)
        FT_Get_Kerning(face, before, glyph, FT_KERNING_DEFAULT, &kerning);
      pen += kerning.x;
      before = glyph;
      if (FT_Load_Glyph(face, glyph, flags | FT_LOAD_TARGET_LIGHT) != 0) continue;
      take(pen);
      pen += face->glyph->advance.x;
    }
    return pen;
  }
};

Font::Font(const std::string& path, int size_px) : face_(std::make_unique<Face>()) {
  const bool opened = FT_Init_FreeType(&face_->library) == 0 &&
                      FT_New_Face(face_->library, path.c_str(), 0, &face_->face) == 0 &&
                      FT_Set_Pixel_Sizes(face_->face, 0, static_cast<FT_UInt>(size_px)) == 0;
  if (!opened) throw InputError("'" + path + "': no font: give a TrueType or OpenType file");
}

Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

int Font::width_px(const std::string& text) const {
  const long pen = face_->set(text, FT_LOAD_DEFAULT, [](long) {});
  return static_cast<int>((pen + kUnits - 1) / kUnits);
}

int Font::ascent_px() const {
  return static_cast<int>(face_->face->size->metrics.ascender / kUnits);
}

int Font::descent_px() const {
  return static_cast<int>(-face_->face->size->metrics.descender / kUnits);
}

void Font::draw(const std::string& text,
                const std::function<void(glm::ivec2 offset_px, float coverage)>& ink) const {
  face_->set(text, FT_LOAD_RENDER, [&](long pen) {
    const FT_GlyphSlot slot = face_->face->glyph;
    const FT_Bitmap& bitmap = slot->bitmap;
    if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY) return;
    const glm::ivec2 corner(static_cast<int>((pen + kUnits / 2) / kUnits) + slot->bitmap_left,
                            -slot->bitmap_top);
    for (int y = 0; y < static_cast<int>(bitmap.rows); ++y) {
      for (int x = 0; x < static_cast<int>(bitmap.width); ++x) {
        const unsigned char value = bitmap.buffer[y * bitmap.pitch + x];
        if (value > 0) ink(corner + glm::ivec2(x, y), static_cast<float>(value) / 255);
      }
    }
  });
}

std::string usual_font() {
  static constexpr std::array<const char*, 6> kPlaces{
      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
      "/usr/share/fonts/TTF/DejaVuSans.ttf",
      "/usr/share/fonts/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
      "/usr/share/fonts/liberation-sans/LiberationSans-Regular.ttf"};
  for (const char* place : kPlaces)
    if (std::filesystem::exists(place)) return place;
  throw InputError(
      "--font: no font for labels in its usual place: install fonts-dejavu-core, or give --font "
      "FILE");
}

}  // namespace terrview
