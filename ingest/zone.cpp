#include "ingest/zone.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <glm/geometric.hpp>

#include "render/parallel.h"
#include "render/post_sight.h"
#include "terrain/error.h"
#include "terrain/post_sight_lines.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

ViewFrame frame_of(const std::vector<Dem>& dems, const std::vector<EyePlace>& targets,
                   std::size_t number, const ZoneOptions& options) {
  ViewFrameOptions frame = options.frame;
  frame.beyond_sight = false;
  frame.above_ground_m = options.observer_m;
  frame.under_ground = true;
  try {
    return {dems, targets[number], frame};
  } catch (const InputError& error) {
    throw InputError("target " + std::to_string(number + 1) + ": " + error.what());
  }
}

// Whether a target is seen, by post.
std::vector<std::uint8_t> sight_of(const ViewFrame& frame, const HeightGrid& grid,
                                   const ZoneOptions& options) {
  const auto objects = options.obstacles ? options.obstacles(frame) : nullptr;
  return posts_that_see_eye(*frame.terrain(), grid,
                            {.observer_m = options.observer_m,
                             .objects = objects.get(),
                             .threads = options.frame.threads,
                             .plain = options.plain});
}

// Targets and observers in one straight frame, that of the first target.
class Directions {
 public:
  Directions(const ViewFrame& frame, const std::vector<ViewFrame::Eye>& targets)
      : terrain_(*frame.terrain()) {
    for (const ViewFrame::Eye& target : targets)
      targets_m_.push_back(
          frame.to_true_enu(at(target.geographic ? frame.to_ground(*target.geographic)
                                                 : frame.to_ground_from_projected(target.projected),
                               terrain_.frame().z_scale * target.height_m)));
  }

  // Of an observer at `ground_m` and this scene height.
  [[nodiscard]] double largest_angle_rad(glm::dvec2 ground_m, double scene_height_m,
                                         const std::vector<std::size_t>& seen) const {
    const glm::dvec3 observer_m = to_true_enu(terrain_.frame(), at(ground_m, scene_height_m));
    std::vector<glm::dvec3> towards;
    for (const std::size_t target : seen)
      towards.push_back(glm::normalize(targets_m_[target] - observer_m));
    double longest = 0;
    for (std::size_t i = 0; i < towards.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        longest = std::max(longest, glm::distance(towards[i], towards[j]));
    return 2 * std::asin(std::min(1.0, longest / 2));
  }

 private:
  [[nodiscard]] glm::dvec3 at(glm::dvec2 ground_m, double scene_height_m) const {
    return {ground_m, terrain_.frame().at(ground_m).z_m(scene_height_m)};
  }

  const Terrain& terrain_;
  std::vector<glm::dvec3> targets_m_;
};

// What is seen by target, and then of it by post.
class ZoneMaker {
 public:
  ZoneMaker(const Dem& dem, bool angles, const ZoneOptions& options)
      : grid_(*dem.grid), options_(options), angles_(angles) {
    zone_.counts.reserve(grid_.heights_m.size());
    zone_.columns = grid_.columns;
    zone_.rows = grid_.rows;
    zone_.placement = dem.placement;
    zone_.crs_wkt = dem.crs_wkt;
    for (const float height_m : grid_.heights_m)
      zone_.counts.push_back(std::isnan(height_m) ? Zone::kNoData : 0);
    zone_.angles_rad = zone_.counts;
  }

  void add(ViewFrame frame) {
    const std::vector<std::uint8_t> seen = sight_of(frame, grid_, options_);
    for (std::size_t post = 0; post < seen.size(); ++post) zone_.counts[post] += seen[post];
    if (angles_) seen_.emplace_back(seen.begin(), seen.end());
    targets_.push_back(frame.eye());
    if (!first_frame_) first_frame_ = std::move(frame);
  }

  Zone result() {
    if (!angles_) return std::move(zone_);
    const Directions directions(*first_frame_, targets_);
    parallel_for(grid_.rows, options_.frame.threads, [&](int row) { fill_row(directions, row); });
    return std::move(zone_);
  }

 private:
  void fill_row(const Directions& directions, int row) {
    std::vector<int> columns;  // from where an angle is subtended
    for (int column = 0; column < grid_.columns; ++column)
      if (zone_.counts[zone_.index(column, row)] >= 2) columns.push_back(column);
    const std::vector<PostPlace> places =
        places_in_row(*first_frame_->terrain(), grid_, row, columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::size_t post = zone_.index(columns[i], row);
      zone_.angles_rad[post] = static_cast<float>(directions.largest_angle_rad(
          ground_of(places[i], {columns[i], row}), scene_height_m(post), seen_from(post)));
    }
  }

  // In the first target's frame, out of whose sight some posts may be.
  [[nodiscard]] glm::dvec2 ground_of(const PostPlace& place, glm::dvec2 post) const {
    return place.map ? place.ground_m
                     : first_frame_->to_ground_from_projected(zone_.placement.at(post));
  }

  // Of an observer's eye.
  [[nodiscard]] double scene_height_m(std::size_t post) const {
    return first_frame_->terrain()->frame().z_scale * grid_.heights_m[post] + options_.observer_m;
  }

  [[nodiscard]] std::vector<std::size_t> seen_from(std::size_t post) const {
    std::vector<std::size_t> seen;
    for (std::size_t target = 0; target < seen_.size(); ++target)
      if (seen_[target][post]) seen.push_back(target);
    return seen;
  }

  const HeightGrid& grid_;
  const ZoneOptions& options_;
  bool angles_;  // more than one target
  Zone zone_;
  std::vector<std::vector<bool>> seen_;  // by target, then by post
  std::vector<ViewFrame::Eye> targets_;
  std::optional<ViewFrame> first_frame_;
};

// Pyramids that the frames of all targets share.
std::vector<Dem> with_ceilings(std::vector<Dem> dems, const ViewFrameOptions& options) {
  for (Dem& dem : dems) {
    const bool has_cells = dem.grid->columns > 1 && dem.grid->rows > 1;
    if (dem.ceilings || options.search == Search::plain || !has_cells) continue;
    dem.ceilings = std::make_shared<const HeightCeilings>(
        *dem.grid, [&](int count, const std::function<void(int index)>& work) {
          parallel_for(count, options.threads, work);
        });
  }
  return dems;
}

}  // namespace

Zone visible_zone(const std::vector<Dem>& dems, const std::vector<EyePlace>& targets,
                  const ZoneOptions& options) {
  if (targets.empty()) throw InputError("no target: give a point of what is to be seen");
  if (!(options.observer_m >= 0) || std::isinf(options.observer_m))
    throw InputError("an observer stands on the ground or above it: give a height from 0");
  if (dems.empty()) throw InputError("no DEM: name at least one file");
  const std::vector<Dem> shared = with_ceilings(dems, options.frame);
  ZoneMaker maker(shared[0], targets.size() > 1, options);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    maker.add(frame_of(shared, targets, i, options));
    if (options.progress)
      options.progress(static_cast<double>(i + 1) / static_cast<double>(targets.size()));
  }
  return maker.result();
}

}  // namespace terrview
