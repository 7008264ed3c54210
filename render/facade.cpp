#include "render/facade.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/objects/scene_objects.h"
#include "render/parallel.h"

namespace terrview {
namespace {

// Rays meet a wall to within so much.
constexpr double kBefore_m = 1e-3;

// An upright strip of a wall: its area is that of its middle.
struct Strip {
  const Prism* prism;
  glm::dvec2 from_m;
  glm::dvec2 edge_m;
  int number;  // along the wall
  double height_m;

  [[nodiscard]] double width_m() const { return glm::length(edge_m); }
};

// Of a wall at a place.
struct Upright {
  double foot_z_m;
  double top_z_m;

  [[nodiscard]] double height_m() const { return top_z_m - foot_z_m; }
};

Upright upright_at(const Terrain& terrain, const Prism& prism, glm::dvec2 at_m) {
  double foot_z_m = prism.foot_z_m(at_m);
  if (const auto ground = terrain.ground_at(at_m))
    foot_z_m = std::max(foot_z_m, terrain.frame().at(at_m).z_m(ground->scene_height_m));
  return {foot_z_m, prism.top_z_m(at_m)};
}

struct Wall {
  const Prism* prism;
  glm::dvec2 from_m;
  glm::dvec2 edge_m;

  // In `count` strips; those that are under the ground are left out.
  void add_strips(const Terrain& terrain, int count, std::vector<Strip>& strips) const {
    const glm::dvec2 part_m = edge_m * (1.0 / count);
    for (int i = 0; i < count; ++i) {
      const glm::dvec2 begin_m = from_m + static_cast<double>(i) * part_m;
      const Upright middle = upright_at(terrain, *prism, begin_m + 0.5 * part_m);
      if (middle.height_m() > 0) strips.push_back({prism, begin_m, part_m, i, middle.height_m()});
    }
  }
};

bool is_inside(std::span<const Prism* const> parts, glm::dvec2 at_m) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const Prism* part) { return part->footprint().contains(at_m); });
}

// The walls whose outer sides are turned to the eye.
std::vector<Wall> facing_walls(std::span<const Prism* const> parts) {
  std::vector<Wall> walls;
  for (const Prism* part : parts) {
    const std::span<const glm::dvec2> vertices = part->footprint().vertices();
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const glm::dvec2 edge_m = vertices[i + 1] - vertices[i];
      if (!part->footprint().is_edge(i) || !(glm::length(edge_m) > 0)) continue;
      const glm::dvec2 middle_m = vertices[i] + 0.5 * edge_m;
      glm::dvec2 to_eye = glm::normalize(glm::dvec2(edge_m.y, -edge_m.x));
      if (glm::dot(to_eye, middle_m) > 0) to_eye = -to_eye;
      const bool faces = is_inside(parts, middle_m - kBefore_m * to_eye) &&
                         !is_inside(parts, middle_m + kBefore_m * to_eye);
      if (faces) walls.push_back({part, vertices[i], edge_m});
    }
  }
  return walls;
}

double area_m2(const std::vector<Strip>& strips) {
  double sum_m2 = 0;
  for (const Strip& strip : strips) sum_m2 += strip.width_m() * strip.height_m;
  return sum_m2;
}

// Whether the first that a ray meets is that wall of the parts: where another building's wall
// coincides with it, the picture shows the one that ObjectSet has first.
bool is_seen(const Scene& scene, std::span<const Prism* const> parts, const glm::dvec3& point_m) {
  const double distance_m = glm::length(point_m);
  Ray ray{.origin_m = {0, 0, 0},
          .direction = glm::normalize(point_m),
          .length_m = std::max(0.0, distance_m - kBefore_m)};
  if (scene.terrain->occluded(ray)) return false;
  ray.length_m = distance_m + kBefore_m;
  const auto hit = scene.objects->set->first_hit(ray);
  if (!hit) return true;
  const Object* first = scene.objects->set->objects()[static_cast<std::size_t>(hit->object)].get();
  const bool is_own = std::find(parts.begin(), parts.end(), first) != parts.end();
  return is_own && hit->surface.distance_m > distance_m - kBefore_m;
}

// Fractional parts of multiples: any few in a row lie evenly between 0 and 1, and so do sums of
// both. From the plastic number (Roberts 2018, "The unreasonable effectiveness of quasirandom
// sequences").
double evenly_along(int row) { return glm::fract((row + 0.5) * 0.7548776662466927); }
double evenly_up(int strip) { return glm::fract((strip + 0.5) * 0.5698402909980532); }

// By a point in each of its rectangles, not in the middles, which an outline that runs along the
// rectangles would pass all at once.
FacadeSight strip_sight(const Scene& scene, std::span<const Prism* const> parts, const Strip& strip,
                        int rows) {
  const double part_m2 = strip.width_m() * strip.height_m / rows;
  FacadeSight sight{.facing_m2 = rows * part_m2};
  for (int row = 0; row < rows; ++row) {
    const glm::dvec2 at_m = strip.from_m + evenly_along(row) * strip.edge_m;
    const Upright upright = upright_at(*scene.terrain, *strip.prism, at_m);
    const glm::dvec3 point_m(
        at_m, upright.foot_z_m + (row + evenly_up(strip.number)) / rows * upright.height_m());
    if (upright.height_m() > 0 && is_seen(scene, parts, point_m))
      sight += {.seen_m2 = part_m2, .nearest_m = point_m, .farthest_m = point_m};
  }
  return sight;
}

int count_of(double length_m, double step_m) {
  return std::max(1, static_cast<int>(std::ceil(length_m / step_m)));
}

}  // namespace

FacadeSight& FacadeSight::operator+=(const FacadeSight& more) {
  facing_m2 += more.facing_m2;
  seen_m2 += more.seen_m2;
  if (!more.nearest_m) return *this;
  if (!nearest_m || glm::length(*more.nearest_m) < glm::length(*nearest_m))
    nearest_m = more.nearest_m;
  if (!farthest_m || glm::length(*more.farthest_m) > glm::length(*farthest_m))
    farthest_m = more.farthest_m;
  return *this;
}

FacadeSight facade_sight(const Scene& scene, std::span<const Prism* const> parts,
                         const FacadeOptions& options) {
  constexpr int kRoughStrips = 8;
  const std::vector<Wall> walls = facing_walls(parts);
  std::vector<Strip> strips;
  for (const Wall& wall : walls) wall.add_strips(*scene.terrain, kRoughStrips, strips);
  const double step_m = std::sqrt(area_m2(strips) / options.samples);
  if (!(step_m > 0)) return {};
  strips.clear();
  for (const Wall& wall : walls)
    wall.add_strips(*scene.terrain, count_of(glm::length(wall.edge_m), step_m), strips);
  std::vector<FacadeSight> sights(strips.size());
  parallel_for(static_cast<int>(strips.size()), options.threads, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    sights[i] = strip_sight(scene, parts, strips[i], count_of(strips[i].height_m, step_m));
  });
  FacadeSight sight;
  for (const FacadeSight& one : sights) sight += one;
  return sight;
}

}  // namespace terrview
