// The rays from the eye through a lattice of image points, a block of them at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "render/camera.h"
#include "render/pixel_lattice.h"
#include "terrain/eye_front.h"
#include "terrain/terrain.h"

namespace terrview {

// A rectangle of lattice points that one thread traces at a time.
struct Block {
  glm::ivec2 first;
  glm::ivec2 size;

  [[nodiscard]] std::size_t points() const {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  }
};

// The hits of any rays; with a `front` of the terrain they all come from the eye, and are found
// sooner. Adds to `counts`.
[[nodiscard]] std::vector<std::optional<Hit>> trace_rays(const Terrain& terrain,
                                                         const EyeFront* front,
                                                         std::span<const Ray> rays,
                                                         TraceCounts& counts);

// References must outlive it. Immutable, so threads may share one.
class PixelTracer {
 public:
  // Without `coherence` and without `front` every ray is traced on its own: the same hits, later.
  PixelTracer(const Terrain& terrain, const Camera& camera, bool coherence, const EyeFront* front,
              const PixelLattice& lattice);

  // Blocks that cover the lattice: strips of columns where columns are coherent, else rows.
  [[nodiscard]] std::vector<Block> blocks() const;

  // The points of a block that are wanted, column by column.
  [[nodiscard]] std::vector<glm::ivec2> points(
      const Block& block, const std::function<bool(glm::ivec2 point)>& wanted) const;

  // The rays through points of the lattice.
  [[nodiscard]] std::vector<Ray> rays(std::span<const glm::ivec2> points) const;

  // Their hits; `points` are some of those of `block`, column by column. Adds to `counts`.
  [[nodiscard]] std::vector<std::optional<Hit>> trace(const Block& block,
                                                      std::span<const glm::ivec2> points,
                                                      TraceCounts& counts) const;

 private:
  [[nodiscard]] std::vector<std::optional<Hit>> trace_strip(const Block& block,
                                                            std::span<const glm::ivec2> points,
                                                            TraceCounts& counts) const;

  const Terrain& terrain_;
  const Camera& camera_;
  const EyeFront* front_;
  PixelLattice lattice_;
  std::optional<ColumnView> columns_;
};

}  // namespace terrview
