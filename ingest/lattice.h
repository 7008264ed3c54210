// Which tiles are one grid.
//
// Tiles belong together when they have one CRS and one step and their posts fall on each other's
// lattice. Such tiles share posts (SRTM) or lie one step apart (tiles cut pixel from pixel); either
// way the cells between them are ground only if they become one grid.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "ingest/dem.h"

namespace terrview {

struct LatticeTile {
  int columns = 0;
  int rows = 0;
  PostPlacement placement;
  int crs = 0;              // the same number, the same CRS
  bool geographic = false;  // x is a longitude in degrees: 360 more is the same place
};

// How far tiles' posts may lie off one lattice, at any of their corners: what headers with six
// decimals lose.
inline constexpr double kLatticeTolerance_posts = 1e-3;

// Tiles are not joined into a grid with more than this many times the posts they have.
inline constexpr double kMostWaste = 4;

// A grid made of tiles.
struct Mosaic {
  struct Part {
    int tile;          // index into the tiles given
    glm::ivec2 first;  // the post of the mosaic that the tile's first post is
  };
  std::vector<Part> parts;  // in the order of the tiles
  int columns = 0;
  int rows = 0;
  PostPlacement placement;
  bool stopped_by_waste = false;  // touches another mosaic of its lattice
};

// Every tile in one mosaic; mosaics in the order of their first tiles.
[[nodiscard]] std::vector<Mosaic> join_tiles(const std::vector<LatticeTile>& tiles);

}  // namespace terrview
