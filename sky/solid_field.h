// A random field in space: what solids seem to be carved from.
//
// The smooth kind of sky/random_field.h with one dimension more. Each cell of a level is divided in
// eight; the control points at the middles of cells are refined 27:9:9:9:3:3:3:1 and displaced by a
// draw keyed by (seed, level, place). In the limit of endless division that is a sum of
// triquadratic B-splines of noise, one of each level, which are evaluated at the point itself: the
// field is known anywhere, without its surroundings, and is smooth once.
#pragma once

#include <glm/vec3.hpp>

#include "sky/random_field.h"

namespace terrview {

class SolidField {
 public:
  // Of the options `kind` is not used and the levels are those along x, at most kMostLevels.
  explicit SolidField(const FieldOptions& options);

  // At a place in root cells; of levels whose cells are narrower than `width_cells` nothing is
  // left, and of those up to twice as wide a part.
  [[nodiscard]] double at(const glm::dvec3& place_cells, double width_cells = 0) const;

  // The root of the field's variance, averaged over space.
  [[nodiscard]] double expected_deviation() const;

 private:
  [[nodiscard]] double spline(int level, const glm::dvec3& place) const;

  RandomField field_;  // of which the levels' deviations and draws are taken
};

}  // namespace terrview
