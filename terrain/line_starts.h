// Where rays first come to lines of the grid that they may be below: what EyeFront::starts_m()
// knows of ground whose cells are wider than a wedge.
//
// A ray is compared with the ground where it crosses lines of the grid. Between two posts of a line
// the ground is a straight edge; so of each line that a wedge crosses, the part between the wedge's
// edges is bounded by the heights at its ends. A ray that is above all of the parts nearer than
// some distance is above the ground up to the line before it.
#pragma once

#include <array>
#include <vector>

#include "terrain/eye_front.h"
#include "terrain/terrain.h"
#include "terrain/wedge_edges.h"

namespace terrview {

// By wedge, a distance.
using WedgeDistances = std::array<float, EyeFront::kGroup>;

struct LineStartsOptions {
  // What crossings may be off, of lines from edge to edge of a wedge: by piece of the tracks, where
  // both edges are on it, and where they are not.
  std::vector<double> margins_cells;
  double knot_margin_cells;
  double furthest_m;     // no line beyond is looked at
  double highest_slope;  // what is behind lines seen more steeply does not matter
  int first_bin;         // these stand for those below and above them, too
  int last_bin;
};

// Lowers starts_m[wedge * EyeFront::kStartBins + bin], of the bin in which a part of a line is seen
// or below, to the distance at which the wedge comes to it. Returns up to where all parts were met,
// but for those that do not matter: infinite where there are no others, on straight tracks.
[[nodiscard]] WedgeDistances meet_lines(const Terrain& terrain, const WedgeEdges& edges,
                                        const LineStartsOptions& options, float* starts_m);

}  // namespace terrview
