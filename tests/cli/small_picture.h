// A folder with small pictures, and what quantizing them writes.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include <glm/fwd.hpp>
#include <glm/vec4.hpp>

#include "quantize/color.h"
#include "tests/cli/small_view.h"

namespace terrview {

// What GDAL makes of a file.
struct ReadPicture {
  int width_px = 0;
  int height_px = 0;
  int bands = 0;
  GDALDataType type = GDT_Unknown;
  Palette table;                   // empty if there is none
  std::vector<int> indices;        // the first band
  std::vector<glm::ivec4> colors;  // red, green, blue, alpha, through the table where there is one
  double nodata = -1;
};

[[nodiscard]] ReadPicture read_picture(const std::string& path);

class SmallPicture : public testing::Test {
 protected:
  static constexpr int kWidth_px = 90;
  static constexpr int kHeight_px = 70;

  // land.tif: over a thousand colours, in UTM. few.png: 12 colours. holes.png: land with an alpha
  // of 0 in its middle.
  SmallPicture();

  // Writes a picture of as many bands as `value` is asked for.
  void write_picture(const std::string& name, const std::string& driver, int bands,
                     GDALDataType type, const std::function<int(int x, int y, int band)>& value,
                     const std::function<void(GDALDataset&)>& change = {}) const;

  [[nodiscard]] Finished quantize(const std::string& line) const {
    return run_here(words("quantize " + line), folder_.path().string());
  }
  // Quietly; must succeed.
  ReadPicture quantized(const std::string& input, const std::string& output,
                        const std::string& options = "") const;

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] std::string bytes(const std::string& name) const { return read_text(path(name)); }

  // Names in the folder but for the inputs, hidden ones too.
  [[nodiscard]] std::set<std::string> outputs() const;

  TemporaryFolder folder_;

 private:
  std::set<std::string> inputs_;
};

}  // namespace terrview
