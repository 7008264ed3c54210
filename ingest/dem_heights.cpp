#include "ingest/dem_heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <sstream>

#include <gdal_priv.h>

#include "terrain/error.h"

namespace terrview {
namespace {

// Numbers that producers write where they have no height. One that no file or user calls nodata is
// taken for it where it stands alone: no other height within kAlone_m of it.
constexpr std::array kUsualNodata{-99999.0, -32768.0, -32767.0, -9999.0, 32767.0, 65535.0};
constexpr double kAlone_m = 1000;

// What a file's numbers were, for the decisions that need all of them.
struct Tally {
  std::array<std::size_t, kUsualNodata.size()> suspects{};
  double lowest_m = std::numeric_limits<double>::infinity();  // of the others
  double highest_m = -std::numeric_limits<double>::infinity();
  std::size_t impossible = 0;
  double first_impossible_m = 0;
  glm::ivec2 first_impossible_post{0, 0};  // of the file
};

// Turns numbers of one file into heights.
class Converter {
 public:
  Converter(const HeightConversion& conversion, bool single_precision)
      : conversion_(conversion), single_precision_(single_precision) {}

  [[nodiscard]] double height_m(double number) const {
    return (number * conversion_.scale + conversion_.offset) * conversion_.metres_per_unit;
  }

  // GDAL reports a Float32 band's nodata as the text of it, rounded elsewhere.
  [[nodiscard]] bool is_nodata(double number) const {
    if (!std::isfinite(number)) return true;
    if (!conversion_.nodata) return false;
    return number == *conversion_.nodata ||
           (single_precision_ &&
            static_cast<float>(number) == static_cast<float>(*conversion_.nodata));
  }

  // The height of the file's post (column, row), NaN where it has none.
  float convert(double number, glm::ivec2 post, Tally& tally) const {
    constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
    if (is_nodata(number)) return kNothing;
    const double height = height_m(number);
    if (!(std::abs(height) < kHighest_m)) {
      if (tally.impossible++ == 0) {
        tally.first_impossible_m = height;
        tally.first_impossible_post = post;
      }
      return kNothing;
    }
    if (!count_suspect(number, tally)) {
      tally.lowest_m = std::min(tally.lowest_m, height);
      tally.highest_m = std::max(tally.highest_m, height);
    }
    return static_cast<float>(height);
  }

  // The same of posts side by side, in the order of the file; false, with nothing done, where one
  // of them needs a second look.
  bool convert_plain(std::span<const double> numbers, std::span<float> posts, Tally& tally) const {
    constexpr std::size_t kChains = 4;  // that do not wait for each other
    std::array<Range, kChains> chains;
    std::size_t first = 0;
    for (; first + kChains <= numbers.size(); first += kChains)
      for (std::size_t k = 0; k < kChains; ++k) chains[k].add(numbers[first + k]);
    for (; first < numbers.size(); ++first) chains[0].add(numbers[first]);
    Range range;
    for (const Range& chain : chains) {
      range.lowest = std::min(range.lowest, chain.lowest);
      range.highest = std::max(range.highest, chain.highest);
    }
    if (!(range.lowest > kLeastPlain && range.highest < kMostPlain)) return false;
    if (conversion_.nodata && range.holds(*conversion_.nodata)) return false;
    const double ends[] = {height_m(range.lowest), height_m(range.highest)};
    if (!(std::max(std::abs(ends[0]), std::abs(ends[1])) < kHighest_m)) return false;
    tally.lowest_m = std::min({tally.lowest_m, ends[0], ends[1]});
    tally.highest_m = std::max({tally.highest_m, ends[0], ends[1]});
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto height = static_cast<float>(height_m(numbers[i]));
      posts[i] = std::isnan(posts[i]) ? height : posts[i];
    }
    return true;
  }

 private:
  // NaN, which becomes no height, is left out.
  struct Range {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    void add(double number) {
      lowest = std::min(lowest, number);
      highest = std::max(highest, number);
    }

    [[nodiscard]] bool holds(double number) const {
      const auto rounded = static_cast<float>(number);
      return (number >= lowest && number <= highest) ||
             (rounded >= static_cast<float>(lowest) && rounded <= static_cast<float>(highest));
    }
  };

  // No number in between is one of kUsualNodata.
  static constexpr double kLeastPlain = -9999;
  static constexpr double kMostPlain = 32767;

  [[nodiscard]] bool count_suspect(double number, Tally& tally) const {
    if (conversion_.nodata_given || (number > kLeastPlain && number < kMostPlain)) return false;
    const auto* found = std::find(kUsualNodata.begin(), kUsualNodata.end(), number);
    if (found == kUsualNodata.end()) return false;
    ++tally.suspects[static_cast<std::size_t>(found - kUsualNodata.begin())];
    return true;
  }

  HeightConversion conversion_;
  bool single_precision_;
};

int whole_blocks(int fit, int block, int all) {
  return std::min(all, std::max(1, fit / block) * block);
}

// Windows that follow the file's blocks, so that each block is decoded once; a block too large to
// be had at once is taken in slices.
std::vector<PostWindow> block_windows(GDALRasterBand& band, const PostWindow& part,
                                      int posts_at_once) {
  int block_width = 1;
  int block_height = 1;
  band.GetBlockSize(&block_width, &block_height);
  const int step_x = whole_blocks(posts_at_once / block_height, block_width, band.GetXSize());
  const int step_y = step_x < band.GetXSize()
                         ? block_height
                         : whole_blocks(posts_at_once / step_x, block_height, band.GetYSize());
  const int slice = std::max(1, posts_at_once / step_x);
  const auto next = [](int at, int step, int end) {
    return static_cast<int>(std::min<std::int64_t>(end, (std::int64_t{at} / step + 1) * step));
  };
  const int right = part[0] + part[2];
  const int bottom = part[1] + part[3];
  std::vector<PostWindow> windows;
  for (int y = part[1]; y < bottom; y = next(y, step_y, bottom)) {
    for (int x = part[0]; x < right; x = next(x, step_x, right)) {
      const int width = next(x, step_x, right) - x;
      const int end_y = next(y, step_y, bottom);
      for (int top = y; top < end_y; top += std::min(slice, end_y - top)) {
        windows.push_back({x, top, width, std::min(slice, end_y - top)});
      }
    }
  }
  return windows;
}

// The band's numbers and, where the file has a mask of its own, that.
class BlockReader {
 public:
  BlockReader(DemSource& source, GdalScope& scope) : source_(source), scope_(scope) {
    const int flags = source.band().GetMaskFlags();
    masked_ = (flags & (GMF_ALL_VALID | GMF_NODATA)) == 0;
  }

  void read(const PostWindow& window) {
    const auto size = static_cast<std::size_t>(window[2]) * static_cast<std::size_t>(window[3]);
    numbers_.resize(size);
    read_band(source_.band(), window, numbers_.data(), GDT_Float64);
    if (!masked_) return;
    mask_.resize(size);
    read_band(*source_.band().GetMaskBand(), window, mask_.data(), GDT_Byte);
  }

  // Those from `index` on; empty where the file has a mask.
  [[nodiscard]] std::span<const double> numbers(std::size_t index, int count) const {
    if (masked_) return {};
    return std::span(numbers_).subspan(index, static_cast<std::size_t>(count));
  }

  // Few, so that their numbers stay in the processor's cache; but blocks of a mask take turns with
  // the band's, and large ones would drive each other out.
  [[nodiscard]] int posts_at_once() const { return masked_ ? 1 << 21 : 1 << 17; }

  [[nodiscard]] double number(std::size_t index) const {
    return masked_ && mask_[index] == 0 ? std::numeric_limits<double>::quiet_NaN()
                                        : numbers_[index];
  }

 private:
  void read_band(GDALRasterBand& band, const PostWindow& w, void* numbers, GDALDataType type) {
    const CPLErr error =
        band.RasterIO(GF_Read, w[0], w[1], w[2], w[3], numbers, w[2], w[3], type, 0, 0, nullptr);
    const std::string reason = scope_.take_failure();
    if (error == CE_None && reason.empty()) return;
    const std::string& name = source_.header().name;
    throw InputError(name + ": cannot be read to its end (" + reason +
                     "): fetch it again or convert it");
  }

  DemSource& source_;
  GdalScope& scope_;
  bool masked_ = false;
  std::vector<double> numbers_;
  std::vector<std::uint8_t> mask_;
};

// The post of the grid for each post of the window.
class Destination {
 public:
  Destination(const HeightTarget& target, HeightGrid& grid) : target_(target), grid_(grid) {}

  // The posts for those of a row; empty where they lie the other way round.
  [[nodiscard]] std::span<float> posts(int column, int row, int count) const {
    if (target_.flip_columns) return {};
    return {&at(column, row), static_cast<std::size_t>(count)};
  }

  float& at(int column, int row) const {
    const PostWindow& w = target_.window;
    const int east = target_.flip_columns ? w[0] + w[2] - 1 - column : column - w[0];
    const int south = target_.flip_rows ? w[1] + w[3] - 1 - row : row - w[1];
    return grid_.heights_m[static_cast<std::size_t>(target_.first.y + south) *
                               static_cast<std::size_t>(grid_.columns) +
                           static_cast<std::size_t>(target_.first.x + east)];
  }

 private:
  const HeightTarget& target_;
  HeightGrid& grid_;
};

std::string number_text(double number) {
  std::ostringstream text;
  text.precision(6);
  text << number;
  return text.str();
}

std::string posts_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " post" : " posts");
}

// Takes back the posts that hold a usual nodata number that stands alone.
std::vector<std::string> drop_suspects(const std::string& name, const Tally& tally,
                                       const Converter& converter, const PostWindow& window,
                                       const Destination& destination) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < kUsualNodata.size(); ++i) {
    const double height = converter.height_m(kUsualNodata[i]);
    const bool alone = height < tally.lowest_m - kAlone_m || height > tally.highest_m + kAlone_m;
    if (tally.suspects[i] == 0 || !alone) continue;
    for (int row = window[1]; row < window[1] + window[3]; ++row) {
      for (int column = window[0]; column < window[0] + window[2]; ++column) {
        float& post = destination.at(column, row);
        if (post == static_cast<float>(height)) post = std::numeric_limits<float>::quiet_NaN();
      }
    }
    const std::string number = number_text(kUsualNodata[i]);
    warnings.push_back(name + ": " + posts_text(tally.suspects[i]) + " of " + number +
                       ", taken as no data: say so with --nodata " + number +
                       ", or keep them by naming another number");
  }
  return warnings;
}

std::string warn_of_impossible(const std::string& name, const Tally& tally) {
  return name + ": " + posts_text(tally.impossible) + " of no possible height (" +
         number_text(tally.first_impossible_m) + " m at column " +
         std::to_string(tally.first_impossible_post.x) + ", row " +
         std::to_string(tally.first_impossible_post.y) +
         "), taken as no data: check --z-unit and --nodata";
}

}  // namespace

std::vector<std::string> read_heights(DemSource& source, const HeightTarget& target,
                                      HeightGrid& grid, GdalScope& scope,
                                      const std::function<void(double posts)>& read) {
  const Converter converter(source.conversion(), source.band().GetRasterDataType() == GDT_Float32);
  const Destination destination(target, grid);
  BlockReader block(source, scope);
  Tally tally;
  for (const PostWindow& window :
       block_windows(source.band(), target.window, block.posts_at_once())) {
    block.read(window);
    std::size_t index = 0;
    for (int row = window[1]; row < window[1] + window[3]; ++row) {
      const auto numbers = block.numbers(index, window[2]);
      const auto posts = destination.posts(window[0], row, window[2]);
      if (!numbers.empty() && !posts.empty() && converter.convert_plain(numbers, posts, tally)) {
        index += numbers.size();
        continue;
      }
      for (int column = window[0]; column < window[0] + window[2]; ++column, ++index) {
        float& post = destination.at(column, row);
        const float height = converter.convert(block.number(index), {column, row}, tally);
        if (std::isnan(post)) post = height;
      }
    }
    if (read) read(static_cast<double>(index));
  }
  auto warnings = drop_suspects(source.header().name, tally, converter, target.window, destination);
  if (tally.impossible > 0) warnings.push_back(warn_of_impossible(source.header().name, tally));
  return warnings;
}

double block_bytes(const DemSource& source) {
  int width = 0;
  int height = 0;
  source.band().GetBlockSize(&width, &height);
  return static_cast<double>(width) * height *
         GDALGetDataTypeSizeBytes(source.band().GetRasterDataType());
}

}  // namespace terrview
