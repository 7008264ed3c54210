// A sphere about the origin that is made of flat triangles, and met and shadowed as such.
//
// Watertight: whether a line passes an edge on one side or the other is decided once for the two
// triangles that share it, so every line passes an even number of triangles.
#pragma once

#include "render/objects/solids/solid.h"
#include "render/objects/solids/sphere_mesh.h"

namespace terrview {

// What a line reaches by an odd number of triangles is inside: where the surface folds over itself,
// not all that it encloses.
class FacetSphere final : public Solid {
 public:
  // Throws InputError as SphereMesh does.
  FacetSphere(double radius_m, SphereCut cut, int count);

  [[nodiscard]] Box bounds() const override;

  // Tests the triangles by where the line is between the sphere around the corners and the one that
  // the triangles leave free within.
  void append_crossings(const Line& line, Crossings& crossings) const override;

  // The same, by testing every triangle: the reference.
  void append_crossings_of_all(const Line& line, Crossings& crossings) const;

  [[nodiscard]] const SphereMesh& mesh() const { return mesh_; }

 private:
  class Test;

  void test_stretch(double from, double to, Test& test) const;
  void test_band(int band, double from_group, double to_group, Test& test) const;

  double radius_m_;
  SphereMesh mesh_;
  double inner_radius_m_;
};

}  // namespace terrview
