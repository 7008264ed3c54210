// Shade trees: what a material is made of (Cook, SIGGRAPH 1984).
//
// A node gives a value, a scalar or a colour (linear Rec. 709), at a point of a surface. Nodes are
// immutable and may be shared by many trees and threads. A node asks those below it for a value
// only where its own depends on it.
#pragma once

#include <memory>
#include <utility>

#include <glm/vec3.hpp>

#include "render/materials/shading_point.h"
#include "sky/color_table.h"

namespace terrview {

template <class Value>
class Shade {
 public:
  virtual ~Shade() = default;
  [[nodiscard]] virtual Value at(const ShadingPoint& point) const = 0;
};

using ScalarShade = std::shared_ptr<const Shade<double>>;
using ColorShade = std::shared_ptr<const Shade<glm::vec3>>;

// Leaves.
[[nodiscard]] ScalarShade constant(double value);
[[nodiscard]] ColorShade constant(const glm::vec3& color);
// The cosine of the angle between the normal and the direction of the eye.
[[nodiscard]] ScalarShade facing();
// The share of light that a smooth surface mirrors, 1 beyond total reflection (render/fresnel.h).
[[nodiscard]] ScalarShade fresnel(double index);

// Operators. None of their arguments is null.
[[nodiscard]] ScalarShade add(ScalarShade a, ScalarShade b);
[[nodiscard]] ColorShade add(ColorShade a, ColorShade b);
// Where `a` is 0, `b` is not asked for.
[[nodiscard]] ScalarShade multiply(ScalarShade a, ScalarShade b);
[[nodiscard]] ColorShade multiply(ColorShade a, ColorShade b);
// a (1 - share) + b share, the share between 0 and 1.
[[nodiscard]] ScalarShade mix(ScalarShade a, ScalarShade b, ScalarShade share);
[[nodiscard]] ColorShade mix(ColorShade a, ColorShade b, ScalarShade share);

// Between scalars and colours.
[[nodiscard]] ColorShade gray(ScalarShade value);
[[nodiscard]] ScalarShade luminance(ColorShade color);
// The table's colour at an address, 0 to 1.
[[nodiscard]] ColorShade tabled(ScalarShade address, const ColorTable& table);

// A node of a function of the point.
template <class Value, class At>
[[nodiscard]] std::shared_ptr<const Shade<Value>> shade_node(At at) {
  class Node final : public Shade<Value> {
   public:
    explicit Node(At given) : at_(std::move(given)) {}
    [[nodiscard]] Value at(const ShadingPoint& point) const override { return at_(point); }

   private:
    At at_;
  };
  return std::make_shared<const Node>(std::move(at));
}

}  // namespace terrview
