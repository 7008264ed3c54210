// What a surface does with light.
//
//   I = ka C Ia + kd C sum D + ks sum S + kr R + kt T
//
// C is the colour of the body; Ia the ambient light; D = (N . L) I of each source (Lambert), and S
// = (R . V)^m I (Phong, CACM 18(6), 1975); R and T what the mirrored and the refracted ray show
// (Whitted, CACM 23(6), 1980). docs/materials.md has the whole model. Of it only the terms that a
// material names are computed.
#pragma once

#include "render/materials/shade_tree.h"
#include "render/objects/scene_objects.h"

namespace terrview {

// How the terms come together.
enum class LightModel {
  whitted,  // as above
  // As in F. Guitteny, E. Le Goff & M. Lahuec's "Lancer de rayon", where
  //   - S is (I (R . V))^m, the intensity of the source inside the power;
  //   - D has the source's intensity, but not its colour;
  //   - a mirror's own colour is weighted: (1 - kr) own + kr R, R at most 1;
  //   - a mirror that sees the background alone keeps its own colour;
  //   - the ambient light is the same on all sides.
  guitteny,
};

// Null: the term is absent, or as said.
struct Material {
  ColorShade color = {};  // none: white
  ScalarShade ambient = {};
  ScalarShade diffuse = {};
  ScalarShade specular = {};
  ScalarShade exponent = {};  // m: the larger, the smaller the highlight; none: 50
  ColorShade mirror = {};
  ColorShade transparency = {};
  double refractive_index = 1.5;  // of the solid, in air
  ScalarShade bump_m = {};        // how far the surface stands out along its normal; none: smooth
  LightModel model = LightModel::whitted;
};

// As objects without material: ambient and diffuse light in full.
[[nodiscard]] Material lambert(ColorShade color);

// Shares of light; what they leave of 1 is the share of the ambient light.
struct PhongShares {
  double mirror = 0;
  double diffuse = 0;
  double specular = 0;
  double exponent = 50;
};
[[nodiscard]] Material phong(ColorShade color, const PhongShares& shares,
                             LightModel model = LightModel::whitted);

// Clear, and mirrors by Fresnel's law.
[[nodiscard]] Material glass(double refractive_index);

// The objects without a material that light goes through: for SceneObjects::casters.
[[nodiscard]] Objects opaque_objects(const SceneObjects& objects);

}  // namespace terrview
