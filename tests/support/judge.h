// Whether the tracer's answer for a ray agrees with the oracle's ground under it.
//
// The promise judged is that of terrain/terrain.h: a hit lies within kTolerance of the scene's
// scale of the surface and the ray is nowhere deeper before it; without a hit the ray stays out of
// the ground to the same tolerance, up to where it ends; occluded() is true where the ray touches
// the ground or is below it.
#pragma once

#include <optional>
#include <string>

#include "terrain/ray.h"
#include "terrain/terrain.h"
#include "tests/support/oracle.h"

namespace terrview::oracle {

// A thousandth of what is promised, so that faults too small for the promise show, too.
inline constexpr double kTolerance = 1e-12;

// The largest of the coordinates, heights and distances that a ray over this terrain involves.
[[nodiscard]] double scene_scale_m(const Terrain& terrain, const Ray& ray);

enum class Outcome { miss, hit, ends_below };

// The answer of the oracle, taken at its word.
[[nodiscard]] Outcome expected_outcome(const Profile& profile);

enum class Verdict {
  wrong,
  right_beside,  // right for a track beside the ray's, where ground borders on nothing
  right_within_tolerance,
  right,  // the same outcome, too
};

struct Judgement {
  Verdict verdict;
  std::string fault;  // of a wrong answer
};

[[nodiscard]] Judgement judge(const Terrain& terrain, const Ray& ray, const std::optional<Hit>& hit,
                              bool occluded, double tolerance = kTolerance);

// Asks the tracer and judges.
[[nodiscard]] Judgement judge(const Terrain& terrain, const Ray& ray,
                              double tolerance = kTolerance);

// A ray as C++, for messages.
[[nodiscard]] std::string to_string(const Ray& ray);

}  // namespace terrview::oracle
