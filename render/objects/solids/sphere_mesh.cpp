#include "render/objects/solids/sphere_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>

#include "render/objects/solids/check_size.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr int kMost = 1000;
constexpr int kDiscPoints = 7;

void check_count(SphereCut cut, int count) {
  const bool by_slices = cut == SphereCut::meridians;
  const int least = by_slices ? 3 : 1;
  if (count >= least && count <= kMost) return;
  throw InputError("triangulated sphere: " + std::to_string(count) +
                   (by_slices ? " slices" : " circles") + ": give from " + std::to_string(least) +
                   " to " + std::to_string(kMost));
}

// How near to the centre of a sphere of `radius_m` a triangle with its corners on it comes: where
// the middle of its circle is within it, or else on its longest side.
double nearest_m(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double radius_m) {
  std::array<double, 3> sides2{glm::dot(b - a, b - a), glm::dot(c - b, c - b),
                               glm::dot(a - c, a - c)};
  std::ranges::sort(sides2);
  const bool is_acute = sides2[0] + sides2[1] > sides2[2];
  if (is_acute) return std::abs(glm::dot(glm::normalize(glm::cross(b - a, c - a)), a));
  return std::sqrt(std::max(radius_m * radius_m - sides2[2] / 4, 0.0));
}

}  // namespace

struct SphereMesh::Ring {
  double latitude;  // radians
  bool is_turned;   // by half a step
};

SphereMesh::SphereMesh(double radius_m, SphereCut cut, int count) {
  check_size("triangulated sphere", "radius", radius_m);
  check_count(cut, count);
  const bool by_slices = cut == SphereCut::meridians;
  points_ = by_slices ? count : kDiscPoints;
  const int steps = by_slices ? std::max(count / 2, 1) : count;  // from a pole to the equator
  // Rings of a disc are turned by turns, from the poles.
  const auto ring_at = [&](int ring) {
    const int from_pole = std::min(ring, 2 * steps - 2 - ring);
    const double latitude = std::numbers::pi / 2 * (steps - 1 - ring) / steps;
    return Ring{latitude, !by_slices && from_pole % 2 == 1};
  };
  const int rings = 2 * steps - 1;
  corners_.emplace_back(0, 0, radius_m);
  for (int ring = 0; ring < rings; ++ring) add_ring(ring_at(ring), radius_m);
  corners_.emplace_back(0, 0, -radius_m);
  const int south = static_cast<int>(corners_.size()) - 1;
  for (int i = 0; i < points_; ++i) triangles_.push_back({0, corner(0, i), corner(0, i + 1)});
  for (int ring = 0; ring + 1 < rings; ++ring)
    add_band(ring, ring_at(ring + 1).is_turned - ring_at(ring).is_turned);
  for (int i = 0; i < points_; ++i)
    triangles_.push_back({south, corner(rings - 1, i + 1), corner(rings - 1, i)});
}

int SphereMesh::corner(int ring, int point) const {
  return 1 + ring * points_ + (point + points_) % points_;
}

void SphereMesh::add_ring(const Ring& ring, double radius_m) {
  const double z_m = radius_m * std::sin(ring.latitude);
  const double across_m = radius_m * std::cos(ring.latitude);
  for (int i = 0; i < points_; ++i) {
    const double azimuth = 2 * std::numbers::pi * (i + (ring.is_turned ? 0.5 : 0)) / points_;
    corners_.emplace_back(across_m * std::cos(azimuth), across_m * std::sin(azimuth), z_m);
  }
  ring_z_m_.push_back(z_m);
}

// Below a ring; the next is turned by so many half steps against it.
void SphereMesh::add_band(int ring, int turned) {
  for (int i = 0; i < points_; ++i) {
    const int below = turned > 0 ? i - 1 : i;
    const int right = corner(ring + 1, below + 1);
    triangles_.push_back({corner(ring, i), corner(ring + 1, below), right});
    triangles_.push_back({corner(ring, i), right, corner(ring, i + 1)});
  }
}

int SphereMesh::band_at(double z_m) const {
  const auto first_below = std::ranges::lower_bound(ring_z_m_, z_m, std::greater{});
  return static_cast<int>(first_below - ring_z_m_.begin());
}

SphereMesh::Group SphereMesh::group(int band, int group) const {
  const auto points = static_cast<std::size_t>(points_);
  const auto of_band = static_cast<std::size_t>(group);
  if (band == 0) return {of_band, 1};
  const std::size_t first = points + (static_cast<std::size_t>(band) - 1) * 2 * points;
  if (band + 1 == bands()) return {first + of_band, 1};
  return {first + 2 * of_band, 2};
}

double SphereMesh::inner_radius_m() const {
  const double radius_m = corners_[0].z;
  double inner_m = radius_m;
  for (const Triangle& t : triangles_) {
    const auto at = [&](std::size_t i) { return corners_[static_cast<std::size_t>(t[i])]; };
    inner_m = std::min(inner_m, nearest_m(at(0), at(1), at(2), radius_m));
  }
  return inner_m;
}

}  // namespace terrview
