#pragma once

#include <array>

namespace terrview {

// The surface between posts, as a ray meets it: see terrain/terrain.h.
enum class SurfaceModel { hyperboloid, band, triangles, bilinear };

inline constexpr std::array kSurfaceModels{SurfaceModel::hyperboloid, SurfaceModel::band,
                                           SurfaceModel::triangles, SurfaceModel::bilinear};

[[nodiscard]] constexpr const char* name_of(SurfaceModel model) {
  switch (model) {
    case SurfaceModel::hyperboloid:
      return "hyperboloid";
    case SurfaceModel::band:
      return "band";
    case SurfaceModel::triangles:
      return "triangles";
    case SurfaceModel::bilinear:
      break;
  }
  return "bilinear";
}

}  // namespace terrview
