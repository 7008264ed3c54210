#include "render/pixel_lattice.h"

namespace terrview {

PixelLattice pixel_centres(const Camera& camera) { return {.count = camera.options().size_px}; }

std::optional<ColumnView> column_view(const Camera& camera, const PixelLattice& lattice) {
  const CameraOptions& options = camera.options();
  if (options.projection == Projection::orthographic || options.pitch_rad != 0 ||
      options.roll_rad != 0)
    return std::nullopt;
  ColumnView view;
  for (int column = 0; column < lattice.count.x; ++column)
    view.across.emplace_back(camera.ray(lattice.at({column, 0})).direction);
  for (int row = 0; row < lattice.count.y; ++row)
    view.rise.push_back(camera.ray(lattice.at({0, row})).direction.z);
  return view;
}

}  // namespace terrview
