// A quadtree of patches that stand for the exact map between ground and posts.
//
// Squares are split, the worst first, until each agrees with the exact map at check points within
// kPatchError. Away from the grid the map may be worse, the more the further it is: all that counts
// there is to stay off the grid.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "ingest/exact_ground_map.h"
#include "ingest/ground_patch.h"

namespace terrview {

class PatchTree {
 public:
  static constexpr double kPatchError_cells = 1e-5;

  struct Leaf {
    GroundPatch patch;
    double error_cells;          // at the check points
    double grid_distance_cells;  // 0 where the square may overlap the grid
    // The points whose leaf it is: not below `low_m`, and below `high_m`, on either axis.
    glm::dvec2 low_m{0, 0};
    glm::dvec2 high_m{0, 0};
  };

  // Throws InputError if no reasonable number of patches follows `exact` on the grid.
  PatchTree(const ExactGroundMap& exact, glm::ivec2 grid_size, const GroundSquare& root,
            double disc_radius_m);

  // The leaf of a point of the root square; points outside belong to the leaf at its edge.
  [[nodiscard]] const Leaf& leaf_at(glm::dvec2 ground_m) const;

  [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }

  // The largest error of the leaves on the grid.
  [[nodiscard]] double error_cells() const;

 private:
  struct Node {
    glm::dvec2 centre_m;
    int first_child = -1;  // of four: south-west, south-east, north-west, north-east; -1 = a leaf
    int leaf = -1;
  };

  // Tells the leaves under a node which points are theirs.
  void share_out(const Node& node, glm::dvec2 low_m, glm::dvec2 high_m);

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
};

}  // namespace terrview
