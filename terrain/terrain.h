// Ray queries against the ground.
//
// The surface. A ray's ground line crosses the lines of the grid; at each crossing the ground's
// height is the linear interpolant of the two posts of the edge crossed, and between two crossings
// the surface in the ray's vertical plane is the chord between them. SurfaceModel says which lines
// count:
//
//   hyperboloid  rows and columns (Coquillart 1984, chapter 2, 3.3.2): depends on the ray's plane
//   band         rows where the line crosses more of them, else columns (ibid., "extensions"; rows
//                on the diagonals); and any line at which ground begins or ends. A chord spans up
//                to two cells, and depends on the ray's plane
//   triangles    rows, columns and the diagonals from the north-west to the south-east post
//   bilinear     rows and columns, and the knots of a bent track; the parabola of the bilinear
//   patch
//                (times dz/dh at the span's start) is added to the chord
//
// Where a ray begins or ends inside a cell, the chord begins or ends at height_at() there, so the
// ground under an eye is one height whatever the azimuth.
//
// Nothing lies outside the outermost posts and in cells that touch a post without data. A ray that
// comes from there below the surface ends at that edge. Of several grids the first that has ground
// at a point wins, and a vertical face closes the step between two of them; where one shows beside
// another, its chord begins and ends at the border at height_at().
//
// Rounding: a hit lies within 1e-9 of the scene's scale of the surface, and the ray is nowhere
// deeper than that before it (tests/terrain/tracer_test.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/ground_map.h"
#include "terrain/height_ceilings.h"
#include "terrain/height_floors.h"
#include "terrain/height_grid.h"
#include "terrain/ray.h"
#include "terrain/surface_model.h"
#include "terrain/vertical_frame.h"

namespace terrview {

// One grid and its place under the eye.
struct TerrainLayer {
  std::shared_ptr<const HeightGrid> grid;
  std::shared_ptr<const GroundMap> map;
  // Those of the grid, where views share them; made by the Terrain that needs them otherwise.
  std::shared_ptr<const HeightCeilings> ceilings{};
};

// How rays find their hits. All give the same hits, bit for bit.
enum class Search {
  plain,    // every cell on the way: the reference
  pyramid,  // blocks of cells that lie below the ray are skipped
};

// The work of a query.
struct TraceCounts {
  std::int64_t tests = 0;  // spans of ground compared with the ray
  std::int64_t nodes = 0;  // blocks of the pyramid compared with it
};

// Immutable, so threads may share one.
class Terrain {
 public:
  // `layers` in order of preference; without any there is no ground. Throws InputError if a grid is
  // smaller than 2 x 2 posts or has no height at all.
  Terrain(std::vector<TerrainLayer> layers, const VerticalFrame& frame, SurfaceModel model,
          Search search = Search::pyramid);

  // The first point of the ground that `ray` meets from above; nullopt if there is none, or if the
  // ray begins below the ground, or ends at an edge below it.
  // Adds the work done to `counts`, if given.
  [[nodiscard]] std::optional<Hit> first_hit(const Ray& ray, TraceCounts* counts = nullptr) const;

  // Whether the ground stops the ray: a hit, or the ray is below the ground somewhere.
  // Adds the work done to `counts`, if given.
  [[nodiscard]] bool occluded(const Ray& ray, TraceCounts* counts = nullptr) const;

  // The scene height (z_scale included) of the ground at a view-frame point, and its layer; nullopt
  // where there is none.
  struct Ground {
    double scene_height_m;
    int grid;
    glm::ivec2 cell;
    glm::dvec2 uv;
  };
  [[nodiscard]] std::optional<Ground> ground_at(glm::dvec2 ground_m) const;

  // Unit normals in the local frame of the hit, z > 0: x and y along the view frame's axes, z along
  // the plumb line there. The facet normal is that of the surface inside the cell; the smooth one
  // interpolates the central differences at the posts.
  [[nodiscard]] glm::dvec3 facet_normal(const Hit& hit) const;
  [[nodiscard]] glm::dvec3 smooth_normal(const Hit& hit) const;

  // A ray towards `direction` from the ground at `hit`, lifted onto ground_at() there (the surface
  // under a ray depends on its plane) and by the rounding error, so that it does not meet the
  // ground it leaves.
  [[nodiscard]] Ray leave(const Hit& hit, const glm::dvec3& direction) const;

  [[nodiscard]] const std::vector<TerrainLayer>& layers() const { return layers_; }
  [[nodiscard]] const VerticalFrame& frame() const { return frame_; }
  [[nodiscard]] SurfaceModel model() const { return model_; }
  // Whether blocks of cells that lie below a ray are skipped; then layers have ceilings, and floors
  // where their holes, or the surface between the posts, make a difference to that.
  [[nodiscard]] bool skips_blocks() const { return search_ == Search::pyramid; }
  [[nodiscard]] const HeightFloors* floors(std::size_t layer) const {
    return floors_.empty() ? nullptr : &floors_[layer];
  }
  // No ground lies further from the eye, or above this z.
  [[nodiscard]] double reach_m() const { return reach_m_; }
  [[nodiscard]] double ceiling_m() const { return ceiling_m_; }
  // No scene height lies further from 0.
  [[nodiscard]] double height_bound_m() const { return height_bound_m_; }
  // The lowest and the highest scene height; with z_scale < 0 the other way round.
  [[nodiscard]] glm::dvec2 height_range_m() const { return height_range_m_; }
  // Whether some post of some layer has no height.
  [[nodiscard]] bool has_holes() const { return has_holes_; }

 private:
  std::vector<TerrainLayer> layers_;
  VerticalFrame frame_;
  SurfaceModel model_;
  Search search_;
  std::vector<HeightFloors> floors_;  // one a layer, or none
  double reach_m_;
  double ceiling_m_;
  double height_bound_m_;
  glm::dvec2 height_range_m_;
  bool has_holes_;
};

}  // namespace terrview
