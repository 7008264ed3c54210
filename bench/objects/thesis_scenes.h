// The scenes of chapter 3 of the thesis, section 7, made anew: what stood where is known by kind
// and number alone, and its cameras are not published.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "render/objects/object_set.h"
#include "terrain/ray.h"

namespace terrview {

// Per ray.
struct ThesisWork {
  double tests;
  double changes;  // of rectangle
};

struct ThesisScene {
  std::string name;
  Objects objects;
  std::vector<Ray> primary;
  std::vector<Ray> secondary;
  ThesisWork printed_primary;  // the thesis's own figures
  ThesisWork printed_secondary;
  std::string printed_rectangles;  // empty / all
};

// [S]: 200 spheres at random in a box, each as large as chance makes it within the room left around
// its centre. [P]: 225 prisms of random height, 15 x 15. [T]: 15 prisms on the ground of photo 2.
[[nodiscard]] std::vector<ThesisScene> thesis_scenes();

// The table of counts, the thesis's beside the rectangle map's.
void write_thesis_table(std::ostream& out);

}  // namespace terrview
