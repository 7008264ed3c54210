// Pictures of any size as lines of 8-bit sRGB colours, through GDAL.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/fwd.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

class GDALDataset;

namespace terrview {

// A picture is whatever GDAL opens with 8- or 16-bit bands: one of grey or with a colour table, or
// red, green and blue (by their colour interpretation, else the first three). The high bytes of 16
// bits are taken, rounded. Pixels that are transparent (alpha under a half), masked or nodata in
// every band are invalid.
class PictureSource {
 public:
  // Throws InputError if the file is no picture.
  explicit PictureSource(const std::string& path);
  ~PictureSource();
  PictureSource(const PictureSource&) = delete;
  PictureSource& operator=(const PictureSource&) = delete;

  [[nodiscard]] glm::ivec2 size_px() const { return size_px_; }

  // Whether pixels can be invalid.
  [[nodiscard]] bool has_mask() const;

  // How many lines are best read together: those of the file's blocks, or about four million
  // pixels.
  [[nodiscard]] int lines_at_once() const;

  // Reads `lines` lines from `first_line` down: width * lines pixels; `valid` is 255 or 0, and
  // stays empty without a mask. Throws InputError if the file is broken.
  void read(int first_line, int lines, std::vector<glm::u8vec3>& colors,
            std::vector<std::uint8_t>& valid) const;

  // For the files that are to lie where this one does.
  [[nodiscard]] GDALDataset& dataset() const { return *dataset_; }

 private:
  struct Closing {
    void operator()(GDALDataset* dataset) const;
  };

  void read_band(int band, int first_line, int lines, std::uint8_t* values, int stride) const;
  void read_table_colors(int first_line, int lines, std::vector<glm::u8vec3>& colors,
                         std::vector<std::uint8_t>& valid) const;
  void read_mask(int first_line, int lines, std::vector<std::uint8_t>& valid) const;

  std::string path_;
  std::unique_ptr<GDALDataset, Closing> dataset_;
  glm::ivec2 size_px_{};
  std::vector<int> bands_;          // one of grey or indices, or three
  std::vector<glm::u8vec4> table_;  // of indices; empty for grey and red, green, blue
  std::vector<int> mask_bands_;     // bands whose masks count; a pixel is valid if in one of them
};

}  // namespace terrview
