// A set of small integers with neighbours found in O(log n) to the base 64.
#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace terrview {

class RankSet {
 public:
  // Of integers in [0, size).
  explicit RankSet(int size) {
    auto words = static_cast<std::size_t>(size);
    do {
      words = (words + 63) / 64;
      levels_.emplace_back(words + 1);  // one more, so that a search need not mind the end
    } while (words > 1);
  }

  void insert(int at) {
    auto i = static_cast<std::size_t>(at);
    for (auto& level : levels_) {
      level[i / 64] |= std::uint64_t{1} << (i % 64);
      i /= 64;
    }
  }

  void erase(int at) {
    auto i = static_cast<std::size_t>(at);
    for (auto& level : levels_) {
      level[i / 64] &= ~(std::uint64_t{1} << (i % 64));
      if (level[i / 64] != 0) return;
      i /= 64;
    }
  }

  [[nodiscard]] bool contains(int at) const {
    const auto i = static_cast<std::size_t>(at);
    return (levels_[0][i / 64] >> (i % 64) & 1) != 0;
  }

  // The least member that is at least `at`; there must be one.
  [[nodiscard]] int next(int at) const {
    auto i = static_cast<std::size_t>(at);
    std::size_t level = 0;
    for (;; ++level, i = i / 64 + 1) {
      assert(level < levels_.size());
      const std::uint64_t rest = levels_[level][i / 64] >> (i % 64);
      if (rest == 0) continue;
      i += static_cast<std::size_t>(std::countr_zero(rest));
      break;
    }
    for (; level > 0; --level)
      i = 64 * i + static_cast<std::size_t>(std::countr_zero(levels_[level - 1][i]));
    return static_cast<int>(i);
  }

  // The greatest member that is at most `at`; there must be one.
  [[nodiscard]] int previous(int at) const {
    auto i = static_cast<std::size_t>(at);
    std::size_t level = 0;
    for (;; ++level, i = i / 64 - 1) {
      assert(level < levels_.size());
      const std::uint64_t rest = levels_[level][i / 64] << (63 - i % 64);
      if (rest == 0) continue;
      i -= static_cast<std::size_t>(std::countl_zero(rest));
      break;
    }
    for (; level > 0; --level)
      i = 64 * i + 63 - static_cast<std::size_t>(std::countl_zero(levels_[level - 1][i]));
    return static_cast<int>(i);
  }

 private:
  std::vector<std::vector<std::uint64_t>> levels_;  // from the members up: a bit per word below
};

}  // namespace terrview
