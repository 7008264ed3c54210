// Triangles with their corners on a sphere, in rings about the z axis.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace terrview {

enum class SphereCut {
  meridians,     // along meridians and parallels
  equator_disc,  // the disc of the equator in triangles, raised and lowered onto the sphere
};

// A band lies between two rings, or a ring and a pole; bands and rings are numbered from the north.
// A band has a group of triangles for each point of a ring: one at a pole, else two.
class SphereMesh {
 public:
  using Triangle = std::array<int, 3>;  // corners, anticlockwise from outside

  // By meridians, `count` is that of slices, with half as many bands, rounded down, in each
  // hemisphere. By the disc, it is that of circles: 7 triangles within the first, 14 more within
  // each of the others; of more than 30, the surface folds over itself. Throws InputError unless
  // there are 3 to 1000 slices, or 1 to 1000 circles.
  SphereMesh(double radius_m, SphereCut cut, int count);

  [[nodiscard]] const std::vector<glm::dvec3>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] int points() const { return points_; }  // of each ring
  [[nodiscard]] int bands() const { return static_cast<int>(ring_z_m_.size()) + 1; }

  // The band at a height, or the nearest.
  [[nodiscard]] int band_at(double z_m) const;
  // Group `group` of a band is between the azimuths of group - 1/2 and group + 3/2 points.
  struct Group {
    std::size_t first;
    std::size_t count;  // of its triangles
  };
  [[nodiscard]] Group group(int band, int group) const;

  // How near to the centre the surface comes.
  [[nodiscard]] double inner_radius_m() const;

 private:
  struct Ring;

  [[nodiscard]] int corner(int ring, int point) const;
  void add_ring(const Ring& ring, double radius_m);
  void add_band(int ring, int turned);

  int points_;
  std::vector<double> ring_z_m_;
  std::vector<glm::dvec3> corners_;  // the north pole, the rings, the south pole
  std::vector<Triangle> triangles_;
};

}  // namespace terrview
