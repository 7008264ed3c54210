// A value for each of the 2^24 colours, in blocks that are made where one is first written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "quantize/color.h"

namespace terrview {

template <class Value>
class ColorGrid {
 public:
  static constexpr std::size_t kBlockSize = 4096;  // colours that share their first four triplets
  using Block = std::array<Value, kBlockSize>;

  // Of a colour's triplets.
  [[nodiscard]] Value& at(std::uint32_t triplets) {
    std::unique_ptr<Block>& block = blocks_[triplets / kBlockSize];
    if (!block) block = std::make_unique<Block>();
    return (*block)[triplets % kBlockSize];
  }

  // Calls visit(triplets, value) for every value that is not 0, in the order of triplets.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (!blocks_[i]) continue;
      for (std::size_t j = 0; j < kBlockSize; ++j) {
        const Value& value = (*blocks_[i])[j];
        if (value != Value{}) visit(static_cast<std::uint32_t>(i * kBlockSize + j), value);
      }
    }
  }

 private:
  std::array<std::unique_ptr<Block>, kColorCount / kBlockSize> blocks_;
};

}  // namespace terrview
