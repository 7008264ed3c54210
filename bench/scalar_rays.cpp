#include "bench/scalar_rays.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/parallel.h"
#include "terrain/occlusion.h"
#include "terrain/sun_shadow.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

constexpr double kLift_m = 0.001;

// GCC 12's basic-block vectorizer drops the rounding where two such conversions stand side by side.
[[gnu::noinline]] double round_to_float(double value) { return static_cast<float>(value); }

// The least float that is no less than `value`.
float round_up(double value) {
  const auto nearest = static_cast<float>(value);
  return nearest >= value ? nearest
                          : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

}  // namespace

void store(const std::optional<Hit>& hit, const Terrain& terrain, TracedFrame& frame,
           std::size_t pixel) {
  glm::dvec3 normal(0);
  if (hit) normal = terrain.facet_normal(*hit);
  const int cells_in_row = terrain.layers()[0].grid->columns - 1;
  frame.distance_m[pixel] = hit ? hit->distance_m : std::numeric_limits<double>::infinity();
  frame.cell[pixel] = hit ? hit->cell.y * cells_in_row + hit->cell.x : kNoCell;
  frame.normal_east[pixel] = static_cast<float>(normal.x);
  frame.normal_north[pixel] = static_cast<float>(normal.y);
}

FrameWork trace_rays(const Terrain& terrain, const Camera& camera, int threads,
                     TracedFrame& frame) {
  std::atomic<std::int64_t> tests = 0;
  std::atomic<std::int64_t> nodes = 0;
  parallel_for(frame.size_px.y, threads, [&](int row) {
    TraceCounts counts;
    for (int column = 0; column < frame.size_px.x; ++column) {
      const Ray ray = camera.ray({column + 0.5, row + 0.5});
      store(terrain.first_hit(ray, &counts), terrain, frame, frame.index(column, row));
    }
    tests += counts.tests;
    nodes += counts.nodes;
  });
  return {.tests = tests, .nodes = nodes};
}

namespace {

// The pixels of a row that have a shadow ray, and where those begin, in the view frame.
struct ShadowRow {
  std::vector<std::size_t> pixels;
  std::vector<glm::dvec3> points_m;
};

ShadowRow shadow_row(const BenchView& view, const ShadowRays& rays, int row) {
  const auto width = static_cast<std::size_t>(rays.size_px.x);
  ShadowRow begins;
  begins.pixels.resize(width);
  begins.points_m.resize(width);
  const std::size_t first = static_cast<std::size_t>(row) * width;
  std::size_t count = 0;
  for (std::size_t i = first; i < first + width; ++i) {
    begins.pixels[count] = i;
    begins.points_m[count] = {rays.x_m[i] - view.eye_m.x, rays.y_m[i] - view.eye_m.y,
                              rays.z_m[i] - view.eye_m.z};
    if (!std::isnan(rays.x_m[i])) ++count;
  }
  begins.pixels.resize(count);
  begins.points_m.resize(count);
  return begins;
}

// The cells in which shadow rays begin, and those beside them.
CellRect cells_under(const Terrain& terrain, const BenchView& view, const ShadowRays& rays) {
  glm::vec2 least(std::numeric_limits<float>::infinity());
  glm::vec2 most = -least;
  for (std::size_t i = 0; i < rays.x_m.size(); ++i) {
    if (rays.x_m[i] < least.x) least.x = rays.x_m[i];
    if (rays.x_m[i] > most.x) most.x = rays.x_m[i];
    if (rays.y_m[i] < least.y) least.y = rays.y_m[i];
    if (rays.y_m[i] > most.y) most.y = rays.y_m[i];
  }
  glm::dvec2 first(std::numeric_limits<double>::infinity());
  glm::dvec2 last = -first;
  for (const glm::vec2 corner :
       {least, most, glm::vec2(least.x, most.y), glm::vec2(most.x, least.y)}) {
    const glm::dvec2 uv =
        terrain.layers()[0].map->to_grid(glm::dvec2(corner) - glm::dvec2(view.eye_m));
    first = glm::min(first, uv);
    last = glm::max(last, uv);
  }
  return {glm::max(glm::ivec2(first) - 1, 0), glm::ivec2(last) + 1};
}

}  // namespace

FrameWork shade_rays(const Terrain& terrain, const BenchView& view, const SunMap* map,
                     const ShadowRays& rays, int threads, ShadowFrame& frame) {
  std::atomic<std::int64_t> tests = 0;
  std::atomic<std::int64_t> nodes = 0;
  parallel_for(rays.size_px.y, threads, [&](int row) {
    TraceCounts counts;
    const ShadowRow begins = shadow_row(view, rays, row);
    std::vector<std::uint8_t> stopped(begins.pixels.size());
    if (map) {
      shaded(terrain, *map, begins.points_m, stopped, counts);
    } else {
      std::vector<Ray> sunward;
      sunward.reserve(begins.points_m.size());
      for (const glm::dvec3& point_m : begins.points_m)
        sunward.push_back({point_m, direction_at(terrain.frame(), point_m, view.to_sun)});
      occluded(terrain, sunward, stopped, counts);
    }
    std::fill_n(frame.begin() + std::ptrdiff_t{row} * rays.size_px.x, rays.size_px.x,
                std::uint8_t{0});
    for (std::size_t i = 0; i < stopped.size(); ++i) frame[begins.pixels[i]] = stopped[i];
    tests += counts.tests;
    nodes += counts.nodes;
  });
  return {.tests = tests, .nodes = nodes};
}

std::shared_ptr<const SunMap> sun_map_of(const Terrain& terrain, const BenchView& view,
                                         const ShadowRays& rays, int threads) {
  return SunMap::make(
      terrain, view.to_sun,
      [&](int count, const std::function<void(int index)>& work) {
        parallel_for(count, threads, work);
      },
      cells_under(terrain, view, rays));
}

ShadowRays shadow_rays(const Terrain& terrain, const BenchView& view, const TracedFrame& frame) {
  ShadowRays rays(frame.size_px);
  std::atomic<std::int64_t> count = 0;
  parallel_for(frame.size_px.y, 0, [&](int row) {
    for (int column = 0; column < frame.size_px.x; ++column) {
      const std::size_t i = frame.index(column, row);
      rays.x_m[i] = rays.y_m[i] = rays.z_m[i] = std::numeric_limits<float>::quiet_NaN();
      if (frame.cell[i] == kNoCell) continue;
      const Ray ray = view.camera.ray({column + 0.5, row + 0.5});
      const glm::dvec3 hit_m = view.eye_m + frame.distance_m[i] * glm::normalize(ray.direction);
      const glm::dvec2 xy_m(round_to_float(hit_m.x), round_to_float(hit_m.y));
      const glm::dvec2 ground_m = xy_m - glm::dvec2(view.eye_m);
      const auto ground = terrain.ground_at(ground_m);
      if (!ground) continue;  // rounded away over an edge of the ground
      rays.x_m[i] = static_cast<float>(xy_m.x);
      rays.y_m[i] = static_cast<float>(xy_m.y);
      const double z_m = terrain.frame().at(ground_m).z_m(ground->scene_height_m);
      rays.z_m[i] = round_up(view.eye_m.z + z_m + kLift_m);
      ++count;
    }
  });
  rays.count = count;
  return rays;
}

}  // namespace terrview
