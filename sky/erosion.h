// Rivers for an invented relief.
#pragma once

#include <functional>
#include <vector>

namespace terrview {

using HeightRows = std::vector<std::vector<double>>;  // rows of posts, metres

struct ErosionOptions {
  int steps = 10;
  double incision = 0.06;  // per step, for the water of one post
  double creep = 0.1;      // per step, how far a post moves to the mean of its four neighbours
  std::function<void(double share)> progress = {};  // may throw to end the work
};

// Lets rivers cut `relief`, which drains over its border: the stream power law with the root of the
// drained area, solved implicitly downstream to upstream (Braun & Willett, Geomorphology 180-181,
// 2013). Water flows along the tree of a priority flood (Barnes, Lehman & Mulla, Computers &
// Geosciences 62, 2014), so no hollow stops it. The same result on every machine.
void erode(HeightRows& relief, const ErosionOptions& options = {});

}  // namespace terrview
