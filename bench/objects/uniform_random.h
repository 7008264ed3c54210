// Numbers at random, the same from every library.
#pragma once

#include <cstdint>
#include <random>

namespace terrview {

class UniformRandom {
 public:
  explicit UniformRandom(std::uint64_t seed) : engine_(seed) {}

  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace terrview
