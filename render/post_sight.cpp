#include "render/post_sight.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

#include "render/parallel.h"
#include "terrain/post_sight_lines.h"
#include "terrain/sight_sweep.h"
#include "terrain/sight_tracer.h"

namespace terrview {
namespace {

bool is_under_ground(const Terrain& terrain) {
  const auto ground = terrain.ground_at({0, 0});
  return ground && terrain.frame().eye_height_m < ground->scene_height_m;
}

// Lines of sight to the posts of a row that are still undecided, all sent at once.
class RowOfLines {
 public:
  RowOfLines(const Terrain& terrain, const HeightGrid& grid, const PostSightOptions& options,
             int row)
      : terrain_(terrain), grid_(grid), options_(options), row_(row) {}

  // By `tracer`, or by single rays where there is none.
  void decide(const SightTracer* tracer, std::span<std::uint8_t> fates) {
    gather(fates);
    std::vector<std::uint8_t> stopped(rays_.size());
    if (tracer) {
      tracer->trace(rays_, stopped);
    } else {
      for (std::size_t i = 0; i < rays_.size(); ++i)
        stopped[i] = terrain_.occluded(rays_[i]) ? 1 : 0;
    }
    for (std::size_t i = 0; i < rays_.size(); ++i)
      fates[columns_[i]] = stopped[i] == 0 ? kSeen : kHidden;
  }

  // The whole way to the observers who see the eye over the ground.
  void hide_behind_objects(std::span<std::uint8_t> fates) const {
    const std::vector<int> columns = columns_of(fates, kSeen);
    const std::vector<PostPlace> places = places_in_row(terrain_, grid_, row_, columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (places[i].map == nullptr) continue;
      const glm::dvec2 ground_m = places[i].ground_m;
      const glm::dvec3 observer_m(ground_m,
                                  terrain_.frame().at(ground_m).z_m(eye_height_m(columns[i])));
      const double length_m = glm::length(observer_m);
      if (length_m > 0 && options_.objects->stops({{0, 0, 0}, observer_m, length_m}))
        fates[static_cast<std::size_t>(columns[i])] = kHidden;
    }
  }

 private:
  [[nodiscard]] std::vector<int> columns_of(std::span<const std::uint8_t> fates,
                                            std::uint8_t fate) const {
    std::vector<int> columns;
    for (int column = 0; column < grid_.columns; ++column)
      if (fates[static_cast<std::size_t>(column)] == fate) columns.push_back(column);
    return columns;
  }

  void gather(std::span<std::uint8_t> fates) {
    const std::vector<int> columns = columns_of(fates, kUndecided);
    const std::vector<PostPlace> places = places_in_row(terrain_, grid_, row_, columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto at = static_cast<std::size_t>(columns[i]);
      fates[at] = kHidden;
      if (std::isnan(grid_.at(columns[i], row_)) || places[i].map == nullptr) continue;
      const auto ray =
          line_of_sight(terrain_.frame(), places[i], {columns[i], row_}, eye_height_m(columns[i]));
      fates[at] = kSeen;
      if (!ray) continue;
      rays_.push_back(*ray);
      columns_.push_back(at);
    }
  }

  // Of the observer, in heights of the scene.
  [[nodiscard]] double eye_height_m(int column) const {
    return terrain_.frame().z_scale * grid_.at(column, row_) + options_.observer_m;
  }

  const Terrain& terrain_;
  const HeightGrid& grid_;
  const PostSightOptions& options_;
  int row_;
  std::vector<Ray> rays_;
  std::vector<std::size_t> columns_;  // of the rays
};

// Leaves undecided what bounds leave so.
void sweep(const Terrain& terrain, const PostSightOptions& options, std::span<std::uint8_t> fates) {
  const SightSweep sweep(terrain, options.observer_m);
  for (int side = 0; side < SightSweep::kSides; ++side)
    parallel_for(SightSweep::kParts, options.threads,
                 [&](int part) { sweep.run(side, part, fates); });
}

}  // namespace

std::vector<std::uint8_t> posts_that_see_eye(const Terrain& terrain, const HeightGrid& grid,
                                             const PostSightOptions& options) {
  if (is_under_ground(terrain)) return std::vector<std::uint8_t>(grid.heights_m.size(), kHidden);
  std::vector<std::uint8_t> fates(grid.heights_m.size(), kUndecided);
  std::optional<SightTracer> tracer;
  if (!options.plain) {
    if (SightSweep::serves(terrain, grid)) sweep(terrain, options, fates);
    tracer.emplace(terrain);
  }
  const auto columns = static_cast<std::size_t>(grid.columns);
  parallel_for(grid.rows, options.threads, [&](int row) {
    RowOfLines lines(terrain, grid, options, row);
    const auto in_row = std::span(fates).subspan(static_cast<std::size_t>(row) * columns, columns);
    lines.decide(tracer ? &*tracer : nullptr, in_row);
    if (options.objects) lines.hide_behind_objects(in_row);
  });
  return fates;
}

}  // namespace terrview
