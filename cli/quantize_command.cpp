#include "cli/quantize_command.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "cli/command_line.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/output_options.h"
#include "cli/palette_file.h"
#include "cli/progress.h"
#include "cli/quantize_options.h"
#include "ingest/gdal_scope.h"
#include "ingest/indexed_file.h"
#include "ingest/picture_source.h"
#include "render/write_file.h"
#include "terrain/error.h"

namespace terrview {
namespace {

// A row of blocks of a wide picture; colours that are counted need the memory more.
constexpr std::int64_t kBlockCache_bytes = 32 << 20;

struct CommandOptions {
  std::string input;
  std::string output;
  PaletteOptions palette;
  IndexedFileOptions file;
  bool overwrite = false;
  BarOptions bar;
};

CommandOptions parse_quantize(const std::vector<std::string>& args) {
  CommandOptions options;
  CommandLine app("A picture with a colour table", "terrview quantize");
  app.add_option("IN", options.input, "A picture that GDAL reads")->required()->type_name("FILE");
  app.add_option("-o", options.output, "Picture: png, tif, gif, jpg, webp or ppm")
      ->required()
      ->type_name("FILE");
  add_palette_options(app, "--colors", options.palette);
  add_method_options(app, options.palette);
  add_format_options(app, options.file.format, options.file.creation, "GDAL's of the format");
  app.add_flag("--overwrite", options.overwrite, "Replace existing outputs");
  add_bar_options(app, options.bar.quiet, options.bar.progress);
  app.parse_args(args);
  check_palette_options(options.palette);
  check_indexed_file(options.output, options.file);
  if (same_place(options.output, options.palette.save_palette))
    throw InputError("'" + options.output +
                     "': named for two outputs: give each a name of its own");
  return options;
}

std::unique_ptr<OutputFile> claim(const std::string& path, const CommandOptions& options) {
  if (path.empty()) return nullptr;
  for (const std::string& input : {options.input, options.palette.use_palette}) {
    std::error_code not_both_exist;
    if (std::filesystem::equivalent(path, input, not_both_exist))
      throw InputError("'" + path + "': is an input: write to another file");
  }
  return std::make_unique<OutputFile>(path, options.overwrite);
}

// The picture from the top, some lines at a time, with the mask where there is one.
class Lines {
 public:
  Lines(const PictureSource& source, const char* label, ShowBar show)
      : source_(source), bar_(label, show) {}

  // False at the end.
  bool next() {
    const glm::ivec2 size_px = source_.size_px();
    first_line_ += lines_;
    lines_ = std::min(source_.lines_at_once(), size_px.y - first_line_);
    if (lines_ <= 0) return false;
    check_interrupt();
    source_.read(first_line_, lines_, colors_, valid_);
    bar_.report(static_cast<double>(first_line_) / size_px.y);
    return true;
  }

  [[nodiscard]] int first_line() const { return first_line_; }
  [[nodiscard]] int count() const { return lines_; }

  // Of the i-th of these lines.
  [[nodiscard]] std::span<const Rgb8> colors(int i) const { return part(colors_, i); }
  [[nodiscard]] std::span<const std::uint8_t> valid(int i) const {
    return valid_.empty() ? std::span<const std::uint8_t>() : part(valid_, i);
  }

 private:
  template <class Value>
  [[nodiscard]] std::span<const Value> part(const std::vector<Value>& values, int i) const {
    const auto width = static_cast<std::size_t>(source_.size_px().x);
    return std::span(values).subspan(static_cast<std::size_t>(i) * width, width);
  }

  const PictureSource& source_;
  ProgressBar bar_;
  int first_line_ = 0;
  int lines_ = 0;
  std::vector<Rgb8> colors_;
  std::vector<std::uint8_t> valid_;
};

ColorCounts count_colors(const PictureSource& source, ShowBar show) {
  ColorCounts counts;
  Lines lines(source, "counting", show);
  std::vector<Rgb8> valid_colors;
  while (lines.next()) {
    for (int i = 0; i < lines.count(); ++i) {
      const auto colors = lines.colors(i);
      const auto valid = lines.valid(i);
      if (valid.empty()) {
        counts.add(colors);
        continue;
      }
      valid_colors.clear();
      for (std::size_t pixel = 0; pixel < colors.size(); ++pixel)
        if (valid[pixel] != 0) valid_colors.push_back(colors[pixel]);
      counts.add(valid_colors);
    }
  }
  return counts;
}

void write_picture(const PictureSource& source, const Quantizer& quantizer,
                   const CommandOptions& options, const std::string& path) {
  IndexedFile file(path,
                   {.size_px = source.size_px(),
                    .palette = quantizer.palette,
                    .has_nodata = source.has_mask(),
                    .place = &source.dataset()},
                   options.file);
  const auto width = static_cast<std::size_t>(source.size_px().x);
  const auto nodata = static_cast<std::uint16_t>(quantizer.palette.size());
  Rewriter rewriter(quantizer.palette, quantizer.find, options.palette.dither, source.size_px().x);
  std::vector<std::uint16_t> indices;
  {
    Lines lines(source, "rewriting", options.bar.show());
    while (lines.next()) {
      indices.resize(width * static_cast<std::size_t>(lines.count()));
      for (int i = 0; i < lines.count(); ++i)
        rewriter.rewrite(lines.colors(i), lines.valid(i), nodata,
                         std::span(indices).subspan(static_cast<std::size_t>(i) * width, width));
      file.write(lines.first_line(), indices);
    }
  }
  ProgressBar bar("completing", options.bar.show());
  file.finish([&](double share) {
    check_interrupt();
    bar.report(share);
  });
}

}  // namespace

int run_quantize(const std::vector<std::string>& args) {
  const CommandOptions options = parse_quantize(args);
  const PictureSource source(options.input);
  limit_block_cache(kBlockCache_bytes);
  const auto picture = claim(options.output, options);
  const auto palette = claim(options.palette.save_palette, options);
  Quantizer quantizer;
  {
    const ColorCounts counts =
        needs_counts(options.palette) ? count_colors(source, options.bar.show()) : ColorCounts();
    quantizer = choose_palette(counts, options.palette, source.has_mask());
  }
  picture->fill([&](const std::string& path) { write_picture(source, quantizer, options, path); });
  if (palette) {
    const std::string text = palette_text(quantizer.palette, options.palette.save_palette);
    palette->fill([&](const std::string& path) { write_file(path, text); });
    palette->commit();
  }
  picture->commit();
  if (!options.bar.quiet)
    std::fprintf(stderr, "wrote %s: %zu colours%s\n", options.output.c_str(),
                 quantizer.palette.size(), source.has_mask() ? " and nodata" : "");
  return 0;
}

}  // namespace terrview
