// A shade that counts how often it is asked.
#pragma once

#include <atomic>

#include "render/materials/shade_tree.h"

namespace terrview {

class Counting final : public Shade<double> {
 public:
  explicit Counting(double value) : value_(value) {}
  [[nodiscard]] double at(const ShadingPoint& /*point*/) const override {
    ++count;
    return value_;
  }
  mutable std::atomic<int> count = 0;

 private:
  double value_;
};

}  // namespace terrview
