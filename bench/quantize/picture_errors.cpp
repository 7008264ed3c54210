#include "bench/quantize/picture_errors.h"

#include <algorithm>
#include <unordered_map>

#include "quantize/color_counts.h"
#include "quantize/color_difference.h"

namespace terrview {
namespace {

constexpr double kUnseen = 0.5;
constexpr double kSeen = 1;

// CIELAB of the colours met, each reckoned once.
class LabCache {
 public:
  [[nodiscard]] const glm::dvec3& of(Rgb8 color) {
    const auto [place, is_new] = known_.try_emplace(triplets(color));
    if (is_new) place->second = cielab(color);
    return place->second;
  }

 private:
  std::unordered_map<std::uint32_t, glm::dvec3> known_;
};

class Banding {
 public:
  Banding(const Picture& picture, const Rewritten& rewritten)
      : picture_(picture), rewritten_(rewritten) {
    for (const Rgb8 color : rewritten.palette) palette_.push_back(cielab(color));
  }

  void add_pair(std::size_t a, std::size_t b) {
    const Rgb8 before_a = picture_.pixels[a];
    const Rgb8 before_b = picture_.pixels[b];
    if (before_a != before_b && ciede2000(lab_.of(before_a), lab_.of(before_b)) >= kUnseen) return;
    ++smooth_;
    const std::uint16_t index_a = rewritten_.indices[a];
    const std::uint16_t index_b = rewritten_.indices[b];
    if (index_a != index_b && ciede2000(palette_[index_a], palette_[index_b]) >= kSeen) ++steps_;
  }

  [[nodiscard]] double share() const {
    return smooth_ > 0 ? static_cast<double>(steps_) / static_cast<double>(smooth_) : 0;
  }

 private:
  const Picture& picture_;
  const Rewritten& rewritten_;
  std::vector<glm::dvec3> palette_;
  LabCache lab_;
  std::int64_t smooth_ = 0;
  std::int64_t steps_ = 0;
};

double banding(const Picture& picture, const Rewritten& rewritten) {
  Banding pairs(picture, rewritten);
  const auto width = static_cast<std::size_t>(picture.width_px);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if ((i + 1) % width != 0) pairs.add_pair(i, i + 1);
    if (i + width < picture.pixels.size()) pairs.add_pair(i, i + width);
  }
  return pairs.share();
}

}  // namespace

PictureErrors picture_errors(const Picture& picture, const Rewritten& rewritten) {
  // Pairs of a colour and its index are few.
  std::unordered_map<std::uint64_t, std::int64_t> pairs;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    ++pairs[std::uint64_t{triplets(picture.pixels[i])} << 16 | rewritten.indices[i]];
  PictureErrors errors;
  for (const auto& [pair, count] : pairs) {
    const Rgb8 before = color_of_triplets(static_cast<std::uint32_t>(pair >> 16));
    const Rgb8 after = rewritten.palette[pair & 0xFFFF];
    const int component = component_difference(before, after);
    const double difference = ciede2000(before, after);
    errors.mean_component += static_cast<double>(count) * component;
    errors.mean_ciede2000 += static_cast<double>(count) * difference;
    errors.max_component = std::max(errors.max_component, component);
    errors.max_ciede2000 = std::max(errors.max_ciede2000, difference);
  }
  errors.mean_component /= static_cast<double>(picture.pixels.size());
  errors.mean_ciede2000 /= static_cast<double>(picture.pixels.size());
  errors.banding = banding(picture, rewritten);
  return errors;
}

}  // namespace terrview
