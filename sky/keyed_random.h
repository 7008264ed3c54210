// Random numbers that are functions of a seed and a place: made in any order, by any thread, they
// are the same.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace terrview {

// Laws of mean 0 and variance 1.
enum class Law {
  gaussian,
  uniform,  // between -sqrt(3) and sqrt(3)
  laplace,  // two-sided exponential: rare, strong draws
  coin,     // -1 or 1
};

// SplitMix64's finaliser (Steele, Lea & Flood, OOPSLA 2014).
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

// A law's quantile function, tabled: 32 bits in, one draw out.
//
// The tail probability p in (0, 1/2) is interpolated linearly in 64 intervals of each octave
// [2^-(k+1), 2^-k], so that the tails are as true as the middle: within 2e-4 of the law's quantile,
// up to 6.3 standard deviations of the gaussian.
class QuantileTable {
 public:
  explicit QuantileTable(Law law);

  [[nodiscard]] float draw(std::uint32_t bits) const {
    const std::uint32_t tail = (bits << 1) | 1U;  // p = tail / 2^33
    const int octave = __builtin_clz(tail);
    const std::uint32_t normalized = tail << octave;
    const Interval& interval =
        intervals_[static_cast<std::size_t>(octave) * kIntervals + ((normalized >> 25) & 63U)];
    const auto offset = static_cast<std::int32_t>(normalized & 0x1ffffffU);
    const float quantile = interval.start + interval.slope * static_cast<float>(offset);
    return (bits >> 31) != 0 ? -quantile : quantile;
  }

 private:
  static constexpr std::size_t kIntervals = 64;
  struct Interval {
    float start;
    float slope;  // per 2^-25 of the interval
  };
  std::array<Interval, 32 * kIntervals> intervals_;
};

// The table of a law, made once.
[[nodiscard]] const QuantileTable& quantile_table(Law law);

// Draws keyed by (seed, level, column, row).
class KeyedRandom {
 public:
  static constexpr int kLevels = 32;

  KeyedRandom(std::uint64_t seed, Law law) : table_(&quantile_table(law)) {
    for (std::uint64_t level = 0; level < kLevels; ++level)
      level_keys_[level] = mix_bits(mix_bits(seed) + kStep * (level + 1));
  }

  // What the keys of a row have in common; levels are below kLevels.
  [[nodiscard]] std::uint64_t row_key(int level, std::int64_t row) const {
    return mix_bits(level_keys_[static_cast<std::size_t>(level)] +
                    kStep * static_cast<std::uint64_t>(row));
  }
  // 64 bits, enough for two independent draws.
  [[nodiscard]] static std::uint64_t bits(std::uint64_t row_key, std::int64_t column) {
    return mix_bits(row_key + kStep * static_cast<std::uint64_t>(column));
  }
  [[nodiscard]] float first(std::uint64_t bits) const {
    return table_->draw(static_cast<std::uint32_t>(bits >> 32));
  }
  [[nodiscard]] float second(std::uint64_t bits) const {
    return table_->draw(static_cast<std::uint32_t>(bits));
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15U;

  std::array<std::uint64_t, kLevels> level_keys_{};
  const QuantileTable* table_;
};

}  // namespace terrview
