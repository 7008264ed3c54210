// How high shadows are over the cells of a grid, all at once.
//
// Rays towards the sun are parallel, or nearly. Along them w = height + rise * line stays the same,
// where lines of posts, the rows or columns that the rays cross most, are counted away from the
// sun. The map sweeps the lines away from the sun and keeps, for each strip of rays one post wide,
//
//   the horizon  no ray of the strip with a larger w is stopped by the ground passed so far,
//   the wall     every ray of the strip with a smaller w is stopped by it.
//
// A cell on which w grows everywhere away from the sun stops no ray that comes down on it from
// above, so it leaves the horizon as it was: that keeps slopes that face the sun from shading
// themselves. docs/decisions/sun-map.md gives the proof.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "terrain/for_each.h"
#include "terrain/ray.h"
#include "terrain/sun_field.h"
#include "terrain/terrain.h"

namespace terrview {

// What is known of a ray from a point of the ground, or above it, towards the sun.
enum class Sunlight : std::uint8_t { unknown, lit, shaded };

// Cells of a grid, both included; as given here, all.
struct CellRect {
  glm::ivec2 first{0};
  glm::ivec2 last{std::numeric_limits<int>::max()};

  [[nodiscard]] glm::ivec2 size() const { return last - first + 1; }
  [[nodiscard]] bool holds(glm::dvec2 cell) const {
    return cell.x >= first.x && cell.y >= first.y && cell.x <= last.x && cell.y <= last.y;
  }
};

class SunMap {
 public:
  // Of the sun at `to_sun`, a true direction at the eye, of unit length; of the cells of `wanted`
  // that the grid has, and some around them. Refers to nothing of `terrain` afterwards. Null where
  // rays towards the sun are too unlike each other, the sun is not above the horizon everywhere or
  // is in the zenith, and for several layers, a z_scale that is not positive and
  // SurfaceModel::band, whose ground has steps.
  [[nodiscard]] static std::unique_ptr<const SunMap> make(const Terrain& terrain,
                                                          const glm::dvec3& to_sun,
                                                          const ForEach& for_each = one_by_one,
                                                          const CellRect& wanted = {});

  // Two codes a cell, on a line of cells away from the sun: a ray over the cell that is higher,
  // where it comes to the line's end towards the sun, than the one says is not stopped by what lies
  // further on; one that is lower than the other says is. Heights are in the grid's unit.
  struct Codes {
    // The code of a height is (height - low) * per_height, within kRounding of a code.
    double low, per_height;
    // How much a ray rises from line to line, and the share of that from a place in a cell.
    double rise_least, rise_most;
    double share0, share_per_column, share_per_row;
    bool over_rows;  // lines are rows

    // Of free_above(): 0 says that all of the cell's ground is lit, kMost that nothing is known.
    static constexpr std::uint32_t kMost = 0xffff;
    static constexpr double kRounding = 0.25;
    // Of a word: 0 knows nothing.
    static std::uint32_t free_above(std::uint32_t word) { return kMost - (word & kMost); }
    static std::uint32_t stopped_below(std::uint32_t word) { return word >> 16; }
  };
  [[nodiscard]] const Codes& codes() const { return codes_; }
  // The cells that it knows of, and their words row by row.
  [[nodiscard]] const CellRect& cells() const { return cells_; }
  [[nodiscard]] const std::uint32_t* words() const { return words_.get(); }

  // Of a point on the ground or above it, at a place of the grid in posts: unknown next to the
  // border of its cell, beyond cells(), and in a hole below all ground.
  [[nodiscard]] Sunlight at(glm::dvec2 uv, double height) const;

  // Whether all the ground of the cell in which a ray meets it is lit. False next to the border of
  // the cell, where Terrain::leave() may begin in another.
  [[nodiscard]] bool lights(const Hit& hit) const;

  // Nearer than this to the border of its cell, in posts, a point's cell is not sure.
  static constexpr double kBorder = 0x1p-18;

  [[nodiscard]] const glm::dvec3& to_sun() const { return to_sun_; }
  [[nodiscard]] std::size_t bytes() const {
    const glm::ivec2 size = cells_.size();
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
           sizeof(std::uint32_t);
  }

 private:
  SunMap(const Terrain& terrain, const SunField& field, const glm::dvec3& to_sun,
         const CellRect& cells);
  void sweep(const Terrain& terrain, const SunField& field, const ForEach& for_each);
  [[nodiscard]] std::uint32_t word(glm::ivec2 cell) const {
    const glm::ivec2 place = cell - cells_.first;
    return words_[static_cast<std::size_t>(place.y) * static_cast<std::size_t>(cells_.size().x) +
                  static_cast<std::size_t>(place.x)];
  }

  glm::dvec3 to_sun_;
  CellRect cells_;
  double hit_error_;  // how far a hit's place may be from that of its position, in posts
  Codes codes_{};
  struct Free {
    void operator()(std::uint32_t* words) const { std::free(words); }
  };
  std::unique_ptr<std::uint32_t[], Free> words_;
};

}  // namespace terrview
