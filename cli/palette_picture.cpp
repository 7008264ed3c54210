#include "cli/palette_picture.h"

#include "render/color_ramp.h"

namespace terrview {
namespace {

std::vector<Rgb8> srgb_colors(const Image& image) {
  std::vector<Rgb8> colors;
  colors.reserve(image.pixels().size());
  for (const glm::vec3& pixel : image.pixels())
    colors.emplace_back(to_srgb8(pixel.x), to_srgb8(pixel.y), to_srgb8(pixel.z));
  return colors;
}

}  // namespace

void count_colors(const Image& image, ColorCounts& counts) { counts.add(srgb_colors(image)); }

Palette write_palette_image(const std::string& path, const Image& image,
                            const PaletteOptions& palette, const IndexedFileOptions& file) {
  const std::vector<Rgb8> colors = srgb_colors(image);
  ColorCounts counts;
  counts.add(colors);
  const Quantizer quantizer = choose_palette(counts, palette, /*has_nodata=*/false);
  Rewriter rewriter(quantizer.palette, quantizer.find, palette.dither, image.width_px());
  std::vector<std::uint16_t> indices(colors.size());
  const auto width = static_cast<std::size_t>(image.width_px());
  for (std::size_t at = 0; at < colors.size(); at += width)
    rewriter.rewrite(std::span(colors).subspan(at, width), {}, 0,
                     std::span(indices).subspan(at, width));
  IndexedFile indexed(
      path, {.size_px = {image.width_px(), image.height_px()}, .palette = quantizer.palette}, file);
  indexed.write(0, indices);
  indexed.finish([](double) {});
  return quantizer.palette;
}

}  // namespace terrview
