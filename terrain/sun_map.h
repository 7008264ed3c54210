// Which cells of a grid the sun shines on, all at once.
//
// Rays towards a sun are parallel where the Earth is flat and the grid's map linear. Along them
// w = height + rise * line stays the same, where lines of posts, the rows or columns that the rays
// cross most, are counted away from the sun; so a point is in shadow if and only if ground that
// lies towards the sun, on its strip, has a larger w. The map sweeps the lines away from the sun
// and keeps, for each strip of rays one post wide,
//
//   the horizon  no ray of the strip with a larger w is stopped by the ground passed so far,
//   the wall     every ray of the strip with a smaller w is stopped by it.
//
// A cell on which w grows everywhere away from the sun stops no ray that comes down on it from
// above, so it leaves the horizon as it was: that keeps slopes that face the sun from shading
// themselves. docs/decisions/shadow-rays.md gives the proof.
//
// Source: Coquillart 1984, chapter 2 (shadows by a second view from the sun); the sweep of horizons
// is that of relief shading, made conservative.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/for_each.h"
#include "terrain/ray.h"
#include "terrain/sun_field.h"
#include "terrain/terrain.h"

namespace terrview {

// What is known of the rays that leave a cell's ground towards the sun.
enum class Sunlight : std::uint8_t {
  unknown,  // some may be stopped
  lit,      // none is, nor one that comes down on the cell's ground from above
  shaded,   // all are
};

class SunMap {
 public:
  // Of the sun at `to_sun`, a true direction at the eye, of unit length. Rays may begin `lift_m`
  // above the highest ground of their cell. Refers to nothing of `terrain` afterwards. Null where
  // rays towards the sun are too unlike each other, the sun is not above the horizon everywhere or
  // is in the zenith, and for several layers, a z_scale that is not positive and
  // SurfaceModel::band, whose ground has steps.
  [[nodiscard]] static std::unique_ptr<const SunMap> make(const Terrain& terrain,
                                                          const glm::dvec3& to_sun, double lift_m,
                                                          const ForEach& for_each = one_by_one);

  // Of the cell whose first post is (column, row).
  [[nodiscard]] Sunlight at(glm::ivec2 cell) const {
    return at_byte(place_.first + place_.per_column * cell.x + place_.per_row * cell.y);
  }

  // Of the point at which Terrain::leave() begins a ray from `hit`, where a ray met the ground of
  // `terrain`, the map's.
  [[nodiscard]] Sunlight at(const Terrain& terrain, const Hit& hit) const;

  // Of a place of the grid, in posts: unknown next to the border of its cell, and beyond the grid.
  [[nodiscard]] Sunlight at(glm::dvec2 uv) const;

  // Nearer than this to the border of its cell, in posts, a point's cell is not sure.
  static constexpr double kBorder = 0x1p-18;

  [[nodiscard]] const glm::dvec3& to_sun() const { return to_sun_; }
  [[nodiscard]] std::size_t bytes() const { return size_words_ * sizeof(std::uint32_t); }

  // at() of the cell (column, row) is byte first + per_column * column + per_row * row of words(),
  // from the lowest of each.
  struct Place {
    std::int32_t first, per_column, per_row;
  };
  [[nodiscard]] const Place& place() const { return place_; }
  [[nodiscard]] Sunlight at_byte(std::int32_t byte) const {
    return static_cast<Sunlight>(reinterpret_cast<const std::uint8_t*>(words_.get())[byte]);
  }
  [[nodiscard]] const std::uint32_t* words() const { return words_.get(); }

 private:
  SunMap(const SunField& field, const glm::dvec3& to_sun);
  void sweep(const Terrain& terrain, const SunField& field, double lift_m, const ForEach& for_each);

  glm::dvec3 to_sun_;
  glm::ivec2 cells_;
  double hit_error_;  // how far a hit's place may be from that of its position, in posts
  Place place_{};
  std::size_t size_words_ = 0;
  std::unique_ptr<std::uint32_t[]> words_;
};

}  // namespace terrview
