#include "cli/objects_csv.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cli/batch/csv.h"
#include "render/objects/object_bounds.h"
#include "render/objects/scene_objects.h"
#include "render/parallel.h"

namespace terrview {
namespace {

struct Extent {
  std::int64_t pixels = 0;
  double solid_angle_sr = 0;

  void add(double sr) {
    ++pixels;
    solid_angle_sr += sr;
  }
};

// Pixels from `low` to before `high`.
struct PixelRange {
  glm::ivec2 low;
  glm::ivec2 high;
};

// All pixels whose rays may meet the box: those between its corners, or the whole picture where
// not all of them fall on it in one piece.
PixelRange pixels_of(const Camera& camera, const Box& box) {
  const glm::ivec2 size = camera.options().size_px;
  glm::dvec2 low(size);
  glm::dvec2 high(0);
  int behind = 0;
  for (const glm::dvec3& corner : corners_of(box)) {
    if (const auto point = camera.project(corner)) {
      low = glm::min(low, *point);
      high = glm::max(high, *point);
    } else {
      ++behind;
    }
  }
  const bool round = camera.options().projection == Projection::cylindrical;
  if (behind == 8 && !round) return {{0, 0}, {0, 0}};
  if (behind > 0 || round) return {{0, 0}, size};
  const glm::dvec2 limit(size);
  return {glm::ivec2(glm::clamp(glm::floor(low) - 1.0, glm::dvec2(0), limit)),
          glm::ivec2(glm::clamp(glm::ceil(high) + 1.0, glm::dvec2(0), limit))};
}

// One feature as the picture has it.
struct Subject {
  std::int32_t id;
  std::vector<const Object*> objects;
};

// Whether a ray would show some of the subject above the ground, if nothing stood before it.
bool would_show(const Terrain& terrain, const Subject& subject, const Ray& ray) {
  return std::any_of(subject.objects.begin(), subject.objects.end(), [&](const Object* object) {
    const auto hit = object->first_hit(ray);
    if (!hit) return false;
    const glm::dvec2 ground_m(hit->position_m);
    const auto ground = terrain.ground_at(ground_m);
    return !ground || hit->position_m.z >= terrain.frame().at(ground_m).z_m(ground->scene_height_m);
  });
}

// What the picture would show of the subject if nothing stood before it.
Extent alone(const View& view, const Raster<PixelSample>& samples, const Subject& subject) {
  const Camera& camera = view.camera;
  PixelRange range{camera.options().size_px, {0, 0}};
  for (const Object* object : subject.objects) {
    const PixelRange more = pixels_of(camera, object->bounds());
    if (more.low.x >= more.high.x || more.low.y >= more.high.y) continue;
    range = {glm::min(range.low, more.low), glm::max(range.high, more.high)};
  }
  Extent extent;
  for (int row = range.low.y; row < range.high.y; ++row) {
    for (int column = range.low.x; column < range.high.x; ++column) {
      if (samples.at(column, row).object_id == subject.id ||
          would_show(*view.scene.terrain, subject, camera.ray({column + 0.5, row + 0.5})))
        extent.add(pixel_solid_angle_sr(camera, {column, row}));
    }
  }
  return extent;
}

std::map<std::int32_t, Extent> visible(const Camera& camera, const Raster<PixelSample>& samples) {
  std::map<std::int32_t, Extent> extents;
  for (int row = 0; row < samples.height_px(); ++row)
    for (int column = 0; column < samples.width_px(); ++column) {
      const std::int32_t id = samples.at(column, row).object_id;
      if (id > PixelSample::kGround) extents[id].add(pixel_solid_angle_sr(camera, {column, row}));
    }
  return extents;
}

std::string line_of(const PlacedFeature& feature, const Extent& seen, const Extent& whole) {
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, ",%.6g,%lld,%.6g,", feature.height_m,
                static_cast<long long>(seen.pixels), seen.solid_angle_sr);
  std::string line = std::to_string(feature.id) + "," + feature.kind + "," +
                     std::to_string(feature.number) + "," + csv_cell(feature.name) + numbers;
  if (whole.pixels > 0) {
    const double share = whole.solid_angle_sr > 0
                             ? seen.solid_angle_sr / whole.solid_angle_sr
                             : static_cast<double>(seen.pixels) / static_cast<double>(whole.pixels);
    std::snprintf(numbers, sizeof numbers, "%.4f", share);
    line += numbers;
  }
  return line + "\n";
}

}  // namespace

double pixel_solid_angle_sr(const Camera& camera, glm::ivec2 pixel) {
  if (camera.options().projection == Projection::orthographic) return 0;
  const auto corner = [&](int x, int y) {
    return glm::normalize(camera.ray(glm::dvec2(pixel + glm::ivec2(x, y))).direction);
  };
  const glm::dvec3 a = corner(0, 0);
  const glm::dvec3 c = corner(1, 1);
  // Two triangles (van Oosterom and Strackee 1983).
  const auto triangle = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    const double volume = glm::dot(glm::cross(q - p, r - p), p);
    return 2 * std::atan2(std::abs(volume), 1 + glm::dot(p, q) + glm::dot(q, r) + glm::dot(r, p));
  };
  return triangle(a, corner(1, 0), c) + triangle(a, c, corner(0, 1));
}

std::string objects_csv(const View& view, const Frame& frame, int threads) {
  const std::map<std::int32_t, Extent> seen = visible(view.camera, frame.samples);
  const PlacedObjects& placed = view.objects.placed;
  std::map<std::int32_t, std::vector<const Object*>> objects;
  for (std::size_t i = 0; i < placed.objects.size(); ++i)
    objects[placed.looks[i].id].push_back(placed.objects[i].get());
  std::vector<std::string> lines(placed.features.size());
  parallel_for(static_cast<int>(lines.size()), threads, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    const PlacedFeature& feature = placed.features[i];
    const auto found = seen.find(feature.id);
    lines[i] = line_of(feature, found == seen.end() ? Extent{} : found->second,
                       alone(view, frame.samples, {feature.id, objects.at(feature.id)}));
  });
  std::string text = "id,kind,feature,name,height_m,pixels,solid_angle_sr,share_visible\n";
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace terrview
