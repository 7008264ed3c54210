// Most of a viewshed by bounds: which posts of a grid certainly see the eye, and which do not.
//
// The grid around the eye is cut into wedges, less than a post wide: lines from the eye part
// them, as tracks over the grid run. On each of the four sides of the eye the wedges are swept
// outwards, line by line of the grid. All lines of sight in a wedge cross a line of the grid within
// that; the least and the greatest height there bound the slope at which each of them meets
// the ground, so that the greatest of the least slopes so far and the greatest of all bound the
// horizon of every post behind. A post above both is seen, below both it is hidden; between them it
// is left undecided, to a ray (terrain/post_sight_lines.h). Wedges are halved where they have
// become as wide as that, and their halves inherit the bounds.
//
// The sweep computes in single precision; bounds are widened by more than its rounding, so what it
// decides is what the rays say, under every instruction set.
#pragma once

#include <cstdint>
#include <span>

#include "terrain/height_grid.h"
#include "terrain/terrain.h"

namespace terrview {

// Of a post.
inline constexpr std::uint8_t kHidden = 0;
inline constexpr std::uint8_t kSeen = 1;
inline constexpr std::uint8_t kUndecided = 2;

class SightSweep {
 public:
  static constexpr int kSides = 4;
  static constexpr int kParts = 64;  // of a side

  // Whether there is a sweep: within_vector_limits(), the layer of `grid`, under an affine map or
  // one with EyeTracks, and the eye within the grid.
  [[nodiscard]] static bool serves(const Terrain& terrain, const HeightGrid& grid);

  // Observers stand `observer_m` >= 0 above their posts. The eye must not be under the ground.
  // `terrain` must outlive the sweep.
  SightSweep(const Terrain& terrain, double observer_m)
      : terrain_(terrain), observer_m_(observer_m) {}

  // Sets what it decides of the fates of the grid's posts, row by row. Parts of one side share no
  // post: any threads may run them at the same time.
  void run(int side, int part, std::span<std::uint8_t> fates) const;

 private:
  const Terrain& terrain_;
  double observer_m_;
};

}  // namespace terrview
