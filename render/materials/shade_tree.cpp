#include "render/materials/shade_tree.h"

#include <type_traits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/fresnel.h"

namespace terrview {
namespace {

template <class Value>
using Node = std::shared_ptr<const Shade<Value>>;

template <class Value>
Node<Value> constant_node(const Value& value) {
  return shade_node<Value>([value](const ShadingPoint&) { return value; });
}

template <class Value>
Node<Value> sum_node(Node<Value> a, Node<Value> b) {
  return shade_node<Value>([a = std::move(a), b = std::move(b)](const ShadingPoint& point) {
    return a->at(point) + b->at(point);
  });
}

template <class Value>
Node<Value> product_node(Node<Value> a, Node<Value> b) {
  return shade_node<Value>([a = std::move(a), b = std::move(b)](const ShadingPoint& point) {
    const Value factor = a->at(point);
    return factor == Value(0) ? factor : factor * b->at(point);
  });
}

template <class Value>
Value mixed(const Value& a, const Value& b, double share) {
  if constexpr (std::is_same_v<Value, double>)
    return glm::mix(a, b, share);
  else
    return glm::mix(a, b, static_cast<float>(share));
}

template <class Value>
Node<Value> mix_node(Node<Value> a, Node<Value> b, ScalarShade share) {
  return shade_node<Value>(
      [a = std::move(a), b = std::move(b), share = std::move(share)](const ShadingPoint& point) {
        const double of_b = share->at(point);
        if (!(of_b > 0)) return a->at(point);
        if (of_b >= 1) return b->at(point);
        return mixed(a->at(point), b->at(point), of_b);
      });
}

}  // namespace

ScalarShade constant(double value) { return constant_node(value); }
ColorShade constant(const glm::vec3& color) { return constant_node(color); }

ScalarShade facing() {
  return shade_node<double>(
      [](const ShadingPoint& point) { return glm::dot(point.normal, point.towards_eye); });
}

ScalarShade fresnel(double index) {
  return shade_node<double>([index](const ShadingPoint& point) {
    return fresnel_reflectance(glm::dot(point.normal, point.towards_eye),
                               point.inside ? 1 / index : index);
  });
}

ScalarShade add(ScalarShade a, ScalarShade b) { return sum_node(std::move(a), std::move(b)); }
ColorShade add(ColorShade a, ColorShade b) { return sum_node(std::move(a), std::move(b)); }

ScalarShade multiply(ScalarShade a, ScalarShade b) {
  return product_node(std::move(a), std::move(b));
}
ColorShade multiply(ColorShade a, ColorShade b) { return product_node(std::move(a), std::move(b)); }

ScalarShade mix(ScalarShade a, ScalarShade b, ScalarShade share) {
  return mix_node(std::move(a), std::move(b), std::move(share));
}
ColorShade mix(ColorShade a, ColorShade b, ScalarShade share) {
  return mix_node(std::move(a), std::move(b), std::move(share));
}

ColorShade gray(ScalarShade value) {
  return shade_node<glm::vec3>([value = std::move(value)](const ShadingPoint& point) {
    return glm::vec3(static_cast<float>(value->at(point)));
  });
}

ScalarShade luminance(ColorShade color) {
  return shade_node<double>([color = std::move(color)](const ShadingPoint& point) {
    return glm::dot(glm::dvec3(color->at(point)), glm::dvec3(0.2126, 0.7152, 0.0722));
  });
}

ColorShade tabled(ScalarShade address, const ColorTable& table) {
  return shade_node<glm::vec3>(
      [address = std::move(address), colors = BakedTable(table)](const ShadingPoint& point) {
        return colors.at(static_cast<float>(address->at(point)));
      });
}

}  // namespace terrview
