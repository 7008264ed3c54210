#include "render/materials/material.h"

#include <algorithm>
#include <utility>

namespace terrview {

Material lambert(ColorShade color) {
  Material material;
  material.color = std::move(color);
  material.ambient = constant(1.0);
  material.diffuse = constant(1.0);
  return material;
}

Material phong(ColorShade color, const PhongShares& shares, LightModel model) {
  Material material;
  material.color = std::move(color);
  material.model = model;
  const auto share_of = [](double share) { return share == 0 ? nullptr : constant(share); };
  material.ambient = share_of(1 - shares.mirror - shares.diffuse - shares.specular);
  material.diffuse = share_of(shares.diffuse);
  material.specular = share_of(shares.specular);
  material.exponent = constant(shares.exponent);
  if (shares.mirror != 0) material.mirror = gray(constant(shares.mirror));
  return material;
}

Material glass(double refractive_index) {
  Material material;
  material.refractive_index = refractive_index;
  const ScalarShade mirrored = fresnel(refractive_index);
  material.mirror = gray(mirrored);
  material.transparency = gray(mix(constant(1.0), constant(0.0), mirrored));
  return material;
}

Objects opaque_objects(const SceneObjects& objects) {
  const auto is_transparent = [](const auto& material) {
    return material && material->transparency;
  };
  Objects opaque;
  for (std::size_t i = 0; i < objects.looks.size(); ++i) {
    const auto& materials = objects.looks[i].materials;
    if (std::none_of(materials.begin(), materials.end(), is_transparent))
      opaque.push_back(objects.set->objects()[i]);
  }
  return opaque;
}

}  // namespace terrview
