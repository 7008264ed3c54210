// How the lines of rays that are to march go over a grid, in double precision and in vectors. What
// a step cannot do as the single ray does makes a ray undecided.
#pragma once

#include "terrain/march_lines.h"
#include "terrain/march_set.h"
#include "terrain/terrain.h"

namespace terrview {

// Lines whose directions are given, of any length, over a grid whose map is linear: they are one
// piece.
void lay_straight(const Terrain& terrain, MarchLines& lines, Fates& fates);

// Over any other map: how lines go over the ground, and how far. Those from the eye have tracks of
// their own.
void lay_lines(const Terrain& terrain, MarchLines& lines, Fates& fates);

// The pieces of tracks that begin where lines stand, as track_piece() makes them.
void lay_pieces(const Terrain& terrain, MarchLines& lines, Fates& fates);

}  // namespace terrview
