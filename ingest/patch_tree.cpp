#include "ingest/patch_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "terrain/error.h"
#include "terrain/ground_map.h"

namespace terrview {
namespace {

// Where a cell is narrower than a metre, near a pole of a geographic grid, metres count.
constexpr double kPatchError_m = 1e-5;
constexpr double kNarrowError_cells = 2e-3;
// Off the grid, the error may be this share of the distance from the grid.
constexpr double kDistantError = 0.01;
// Where a datum shift comes from a grid of its own, the map has creases, and halving a square gains
// less than this. Then it must do that an error is below kNarrowError_cells, and that the eye sees
// little of it.
constexpr double kLeastGain = 8;
constexpr double kLittle_rad = 0.05 * GroundMap::kTrackError_rad;
// The check points see most of the largest error, not all of it.
constexpr double kUnseenError = 2;
constexpr double kSmallestHalf_m = 0.5;
constexpr int kMostLeaves = 2000;
constexpr std::array kCheckShares{-1.0, -0.35, 0.4, 1.0};
constexpr std::size_t kNodeCount = GroundPatch::Nodes{}.size();
constexpr std::size_t kChecks = kCheckShares.size() * kCheckShares.size();

using Samples = std::array<glm::dvec2, kNodeCount + kChecks>;

struct Candidate {
  PatchTree::Leaf leaf;
  double excess;   // error over what is allowed
  bool tolerable;  // if halving the square gains nothing
};

struct Waiting {
  double excess;
  int node;
  // The worst first; of equals, the older.
  bool operator<(const Waiting& other) const {
    return excess != other.excess ? excess < other.excess : node > other.node;
  }
};

class Fitter {
 public:
  Fitter(const ExactGroundMap& exact, glm::ivec2 grid_size, const GroundSquare& root,
         double disc_radius_m)
      : exact_(exact),
        last_post_(grid_size - 1),
        root_(root),
        disc_radius_m_(disc_radius_m),
        centre_uv_(exact.to_grid(root.centre_m)),
        centre_jacobian_(exact.jacobian(root.centre_m)) {}

  [[nodiscard]] Candidate fit(const GroundSquare& square) const {
    const Samples ground = points_of(square);
    Samples uv = ground;
    exact_.to_grid(uv);
    for (std::size_t i = 0; i < uv.size(); ++i)
      if (std::isnan(uv[i].x)) uv[i] = nowhere(ground[i]);
    const double distance = grid_distance(uv);
    const bool singular = square.half_m < kSmallestHalf_m;
    if (singular) flatten(square, ground, uv);

    GroundPatch::Nodes at_nodes;
    std::copy_n(uv.begin(), kNodeCount, at_nodes.begin());
    GroundPatch patch(square, at_nodes);
    double error = 0;
    for (std::size_t i = kNodeCount; i < uv.size(); ++i)
      error = std::max(error, kUnseenError * glm::distance(patch.at(ground[i]), uv[i]));
    const bool settled = singular || beyond_disc(square);
    double excess = settled ? 0 : error / allowed(patch, distance);
    if (std::isnan(excess)) excess = std::numeric_limits<double>::infinity();
    const bool tolerable =
        error <= kNarrowError_cells && error <= kLittle_rad * cells_from_eye(patch);
    return {{std::move(patch), settled ? 0 : error, distance}, excess, tolerable};
  }

 private:
  static Samples points_of(const GroundSquare& square) {
    Samples points;
    const GroundPatch::Nodes nodes = GroundPatch::nodes(square);
    auto next = std::copy(nodes.begin(), nodes.end(), points.begin());
    for (const double x : kCheckShares)
      for (const double y : kCheckShares) *next++ = square.at({x, y});
    return points;
  }

  // A place off the grid, for ground that has none in the CRS.
  [[nodiscard]] glm::dvec2 nowhere(glm::dvec2 ground_m) const {
    const glm::dvec2 away = centre_jacobian_ * (ground_m - root_.centre_m);
    return centre_uv_ + 2 * glm::length(last_post_) * away / glm::length(away);
  }

  // Around a point where the map is singular: the bilinear map of the corners.
  static void flatten(const GroundSquare& square, const Samples& ground, Samples& uv) {
    const std::size_t last = kCheckShares.size() - 1;
    const glm::dvec2 south_west = uv[kNodeCount];
    const glm::dvec2 north_west = uv[kNodeCount + last];
    const glm::dvec2 south_east = uv[kNodeCount + last * kCheckShares.size()];
    const glm::dvec2 north_east = uv[kNodeCount + kChecks - 1];
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const glm::dvec2 share =
          0.5 * ((ground[i] - square.centre_m) / square.half_m + glm::dvec2(1));
      uv[i] = glm::mix(glm::mix(south_west, south_east, share.x),
                       glm::mix(north_west, north_east, share.x), share.y);
    }
  }

  [[nodiscard]] double grid_distance(const Samples& uv) const {
    glm::dvec2 low = uv[0];
    glm::dvec2 high = uv[0];
    for (const glm::dvec2& point : uv) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
    const glm::dvec2 margin = 0.05 * (high - low) + glm::dvec2(2);
    return glm::length(
        glm::max(glm::dvec2(0), glm::max(low - margin - last_post_, -(high + margin))));
  }

  [[nodiscard]] bool beyond_disc(const GroundSquare& square) const {
    const glm::dvec2 away = glm::abs(square.centre_m - root_.centre_m) - square.half_m;
    return glm::length(glm::max(away, glm::dvec2(0))) > disc_radius_m_;
  }

  // The distance of a square from the eye in its widest cells, one at least.
  [[nodiscard]] static double cells_from_eye(const GroundPatch& patch) {
    const GroundSquare& square = patch.square();
    const glm::dvec2 away = glm::abs(square.centre_m) - square.half_m;
    const double cell_m = std::max(patch.cell_m().x, patch.cell_m().y);
    return std::max(1.0, glm::length(glm::max(away, glm::dvec2(0))) / cell_m);
  }

  [[nodiscard]] static double allowed(const GroundPatch& patch, double distance) {
    const glm::dvec2 cell_m = patch.cell_m();
    const double narrow = kPatchError_m / std::min(cell_m.x, cell_m.y);
    return std::clamp(narrow, PatchTree::kPatchError_cells, kNarrowError_cells) +
           kDistantError * distance;
  }

  const ExactGroundMap& exact_;
  glm::dvec2 last_post_;
  GroundSquare root_;
  double disc_radius_m_;
  glm::dvec2 centre_uv_;
  glm::dmat2 centre_jacobian_;
};

}  // namespace

PatchTree::PatchTree(const ExactGroundMap& exact, glm::ivec2 grid_size, const GroundSquare& root,
                     double disc_radius_m) {
  if (std::isnan(exact.to_grid(root.centre_m).x))
    throw InputError("'" + exact.dem() +
                     "': its coordinates are not defined where the eye is: warp it to a "
                     "projection made for the place with gdalwarp");
  const Fitter fitter(exact, grid_size, root, disc_radius_m);
  std::priority_queue<Waiting> waiting;
  const auto put = [&](int node, int leaf, const GroundSquare& square, double parents_error) {
    Candidate candidate = fitter.fit(square);
    const double error = candidate.leaf.error_cells;
    const bool creased = candidate.tolerable && error * kLeastGain > parents_error;
    const auto at = static_cast<std::size_t>(leaf);
    if (at == leaves_.size())
      leaves_.push_back(std::move(candidate.leaf));
    else
      leaves_[at] = std::move(candidate.leaf);
    nodes_[static_cast<std::size_t>(node)].leaf = leaf;
    if (candidate.excess > 1 && !creased) waiting.push({candidate.excess, node});
  };
  nodes_.push_back({root.centre_m});
  put(0, 0, root, std::numeric_limits<double>::infinity());
  while (!waiting.empty() && leaves_.size() < kMostLeaves) {
    const auto parent = static_cast<std::size_t>(waiting.top().node);
    waiting.pop();
    const int leaf = nodes_[parent].leaf;
    const GroundSquare square = leaves_[static_cast<std::size_t>(leaf)].patch.square();
    const double error = leaves_[static_cast<std::size_t>(leaf)].error_cells;
    nodes_[parent].first_child = static_cast<int>(nodes_.size());
    for (int child = 0; child < 4; ++child) {
      const glm::dvec2 corner(child % 2 == 0 ? -0.5 : 0.5, child < 2 ? -0.5 : 0.5);
      nodes_.push_back({square.at(corner)});
      put(static_cast<int>(nodes_.size()) - 1, child == 0 ? leaf : static_cast<int>(leaves_.size()),
          {square.at(corner), square.half_m / 2}, error);
    }
  }
  const glm::dvec2 everywhere(std::numeric_limits<double>::infinity());
  share_out(nodes_[0], -everywhere, everywhere);
  if (!(error_cells() <= kNarrowError_cells))
    throw InputError("'" + exact.dem() +
                     "': its coordinates bend too sharply within sight of the eye, near a pole or "
                     "the edge of its projection: warp it to a projection made for the place "
                     "with gdalwarp");
}

void PatchTree::share_out(const Node& node, glm::dvec2 low_m, glm::dvec2 high_m) {
  if (node.first_child < 0) {
    Leaf& leaf = leaves_[static_cast<std::size_t>(node.leaf)];
    leaf.low_m = low_m;
    leaf.high_m = high_m;
    return;
  }
  for (int child = 0; child < 4; ++child) {
    glm::dvec2 low = low_m;
    glm::dvec2 high = high_m;
    (child % 2 == 0 ? high : low).x = node.centre_m.x;
    (child < 2 ? high : low).y = node.centre_m.y;
    share_out(nodes_[static_cast<std::size_t>(node.first_child + child)], low, high);
  }
}

const PatchTree::Leaf& PatchTree::leaf_at(glm::dvec2 ground_m) const {
  const Node* node = nodes_.data();
  while (node->first_child >= 0) {
    const int child =
        (ground_m.x >= node->centre_m.x ? 1 : 0) + (ground_m.y >= node->centre_m.y ? 2 : 0);
    node = &nodes_[static_cast<std::size_t>(node->first_child + child)];
  }
  return leaves_[static_cast<std::size_t>(node->leaf)];
}

double PatchTree::error_cells() const {
  double largest = 0;
  for (const Leaf& leaf : leaves_)
    if (leaf.grid_distance_cells == 0) largest = std::max(largest, leaf.error_cells);
  return largest;
}

}  // namespace terrview
