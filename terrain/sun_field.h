// How rays towards the sun go over the lines of a grid, and how that changes from place to place.
//
// Lines are the rows or the columns of posts, those that rays over the middle of the grid cross
// more of; line 0 is the one next to the sun, and a post's place x on its line is its column or
// row. On a flat Earth under a linear map all rays go alike. Elsewhere they turn a little: the
// field is sampled on a lattice, and what it does in between is bounded by its second differences
// there.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/terrain.h"

namespace terrview {

// Of rays towards the sun, somewhere, over the way to the next line towards it.
struct SunRates {
  double drift = 0;       // how far x grows, in posts
  double spread = 0;      // by how much it may grow more or less
  double rise_least = 0;  // in the grid's unit of height
  double rise_most = 0;

  // Of these and other rays.
  [[nodiscard]] SunRates with(const SunRates& other) const;
};

class SunField {
 public:
  // Of a terrain of one layer. `to_sun` is a true direction at the eye, of unit length.
  SunField(const Terrain& terrain, const glm::dvec3& to_sun);

  // Whether the sun is above the horizon all over the grid, and not so near the zenith, nor its
  // rays so unlike each other, that their order on the lines is lost.
  [[nodiscard]] bool is_regular() const { return regular_; }

  // Whether all rays go alike.
  [[nodiscard]] bool is_linear() const { return linear_; }

  [[nodiscard]] bool over_rows() const { return over_rows_; }  // lines are rows
  [[nodiscard]] bool from_last() const { return from_last_; }  // line 0 is the last row or column
  [[nodiscard]] int lines() const { return size_.y; }          // of posts
  [[nodiscard]] int posts() const { return size_.x; }          // of a line

  // Of all rays over these parts of the grid, in posts; beyond its border, as at the border.
  [[nodiscard]] SunRates rates(glm::dvec2 first_xy, glm::dvec2 last_xy) const;

  // In posts: how far a ray's track may lie beside its line in the grid.
  [[nodiscard]] double track_error() const;
  // By how much the drift of a track, and the share of its rise, may be those of another direction.
  [[nodiscard]] double track_turn() const { return track_turn_; }

  // Below the eye the curvature of the Earth turns with the azimuth, and heights along a ray do not
  // change smoothly: by how much, in the grid's unit, they may be others than the rates say, and
  // how far around the eye, in posts, that may be more than track_turn() of the rise.
  [[nodiscard]] double blur() const { return blur_; }
  [[nodiscard]] bool is_near_eye(glm::dvec2 first_xy, glm::dvec2 last_xy) const {
    return last_xy.x >= eye_xy_.x - near_eye_ && first_xy.x <= eye_xy_.x + near_eye_ &&
           last_xy.y >= eye_xy_.y - near_eye_ && first_xy.y <= eye_xy_.y + near_eye_;
  }

 private:
  [[nodiscard]] glm::dvec2 uv_of(glm::dvec2 xy) const;
  [[nodiscard]] glm::dvec2 xy_of(glm::dvec2 uv) const;
  void orient(const Terrain& terrain, const glm::dvec3& to_sun);
  struct Way {
    double drift;
    double rise;
    bool regular;
  };
  [[nodiscard]] Way way(const Terrain& terrain, const glm::dvec3& at_m,
                        const glm::dvec3& direction) const;
  [[nodiscard]] SunRates sample(const Terrain& terrain, const glm::dvec3& to_sun,
                                glm::dvec2 ground_m);
  void fill_lattice(const Terrain& terrain, const glm::dvec3& to_sun);
  void widen_between_nodes();
  void blur_the_eye(const Terrain& terrain);
  [[nodiscard]] SunRates& node(int x, int line) {
    return lattice_[static_cast<std::size_t>(line * nodes_ + x)];
  }
  [[nodiscard]] const SunRates& node(int x, int line) const {
    return lattice_[static_cast<std::size_t>(line * nodes_ + x)];
  }

  bool linear_;
  bool over_rows_ = true;
  bool from_last_ = false;
  bool regular_ = true;
  glm::ivec2 size_{};  // posts, lines
  double track_turn_ = 0;
  double blur_ = 0;
  double near_eye_ = -1;
  glm::dvec2 eye_xy_{0, 0};
  int nodes_;                      // a side of the lattice
  std::vector<SunRates> lattice_;  // line by line
};

}  // namespace terrview
