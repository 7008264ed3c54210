#include "ingest/view_frame.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include <GeographicLib/Constants.hpp>
#include <glm/matrix.hpp>

#include "ingest/frame_errors.h"
#include "ingest/lay_grid.h"
#include "ingest/sight.h"
#include "ingest/view_checks.h"
#include "render/parallel.h"
#include "terrain/error.h"
#include "terrain/grid_walk.h"
#include "terrain/view_transform.h"

namespace terrview {
namespace {

struct Curvatures {
  double north_per_m;
  double east_per_m;
};

Curvatures curvatures_at(double latitude_deg) {
  const double a = GeographicLib::Constants::WGS84_a();
  const double f = GeographicLib::Constants::WGS84_f();
  const double e2 = f * (2 - f);
  const double sine = std::sin(latitude_deg / 180 * GeographicLib::Math::pi());
  const double root = std::sqrt(1 - e2 * sine * sine);
  return {root * root * root / (a * (1 - e2)), root / a};
}

// The middle and the corners of every block of an 8 x 8 division.
std::vector<glm::dvec2> some_posts(const Dem& dem) {
  constexpr int kDivisions = 8;
  const glm::dvec2 last(dem.grid->columns - 1, dem.grid->rows - 1);
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= kDivisions; ++i)
    for (int j = 0; j <= kDivisions; ++j)
      points.push_back(dem.placement.at(last * glm::dvec2(i, j) / double{kDivisions}));
  return points;
}

// 80 degrees of arc: further, the view frame stretches too much.
constexpr double kFurthest_m = 8.9e6;

// A DEM and its place.
struct Place {
  std::shared_ptr<const HeightGrid> grid;
  PostPlacement placement;
  std::shared_ptr<const CrsTransform> crs;  // null = none

  [[nodiscard]] glm::ivec2 size() const { return {grid->columns, grid->rows}; }
  [[nodiscard]] glm::dvec2 middle() const { return glm::dvec2(size() - 1) / 2.0; }
};

// Heights of the scene.
struct Relief {
  double lowest_m = std::numeric_limits<double>::infinity();
  double highest_m = -std::numeric_limits<double>::infinity();
};

Relief relief(const std::vector<Place>& places, double z_scale) {
  Relief relief;
  for (const Place& place : places) {
    const HeightRange range = height_range(*place.grid);
    if (std::isnan(range.highest_m)) continue;
    relief.lowest_m = std::min(relief.lowest_m, z_scale * range.lowest_m);
    relief.highest_m = std::max(relief.highest_m, z_scale * range.highest_m);
  }
  return relief;
}

}  // namespace

struct ViewFrame::Impl {
  ViewFrameOptions options;
  std::vector<Place> places;
  std::vector<CrsOperation> operations;
  std::vector<std::string> warnings;
  Eye eye{};
  bool curved = false;
  glm::dmat2 flat_to_ground{1};  // flat Earth: from the first DEM's (x, y) less the eye's
  FrameErrors errors;
  std::shared_ptr<const Terrain> terrain;

  void place_dems(const std::vector<Dem>& dems);
  void place_eye(const EyePlace& place);
  [[nodiscard]] std::string eye_text() const;
  [[nodiscard]] ExactGroundMap exact_map(const Place& place) const;
  [[nodiscard]] glm::dvec2 projected(const GeoPoint& point) const;
  [[nodiscard]] GeoPoint geographic(glm::dvec2 xy) const;
  [[nodiscard]] TerrainLayer flat_layer(const Place& place) const;
  [[nodiscard]] std::optional<double> ground_under_eye() const;
  [[nodiscard]] VerticalFrame vertical_frame(const EyePlace& place);
  [[nodiscard]] std::vector<TerrainLayer> flat_layers();
  [[nodiscard]] std::vector<TerrainLayer> curved_layers(const VerticalFrame& frame);
};

void ViewFrame::Impl::place_dems(const std::vector<Dem>& dems) {
  for (const Dem& dem : dems) {
    Place place{dem.grid, dem.placement, nullptr};
    if (!dem.crs_wkt.empty()) {
      place.crs = std::make_shared<CrsTransform>(dem.name, dem.crs_wkt, some_posts(dem));
      operations.push_back(place.crs->operation());
    }
    places.push_back(std::move(place));
  }
}

glm::dvec2 ViewFrame::Impl::projected(const GeoPoint& point) const {
  glm::dvec2 xy(point.longitude_deg, point.latitude_deg);
  places[0].crs->from_geographic({&xy, 1});
  const Place& first = places[0];
  if (const auto turn = first.crs->turn())
    xy.x += *turn * std::round((first.placement.at(first.middle()).x - xy.x) / *turn);
  return xy;
}

GeoPoint ViewFrame::Impl::geographic(glm::dvec2 xy) const {
  places[0].crs->to_geographic({&xy, 1});
  return {xy.y, std::remainder(xy.x, 360.0)};
}

ExactGroundMap ViewFrame::Impl::exact_map(const Place& place) const {
  ExactGroundMap map(*eye.geographic, place.crs, place.placement);
  map.set_near(place.middle());
  return map;
}

void ViewFrame::Impl::place_eye(const EyePlace& place) {
  if (place.geographic) {
    eye.geographic = place.geographic;
    eye.geographic->longitude_deg = std::remainder(eye.geographic->longitude_deg, 360.0);
    eye.projected = projected(*eye.geographic);
  } else {
    eye.projected = *place.projected;
    if (!places.empty() && places[0].crs) {
      eye.geographic = geographic(eye.projected);
      if (!std::isfinite(eye.geographic->latitude_deg))
        throw InputError("the eye at " + eye_text() + " is nowhere on the Earth: check --eye-xy");
    }
  }
}

std::string ViewFrame::Impl::eye_text() const {
  if (eye.geographic && std::isfinite(eye.geographic->latitude_deg))
    return in_words("%.5f", eye.geographic->latitude_deg) + ", " +
           in_words("%.5f", eye.geographic->longitude_deg);
  return in_words("%.3f", eye.projected.x) + ", " + in_words("%.3f", eye.projected.y);
}

// The first DEM that has ground there tells its height.
std::optional<double> ViewFrame::Impl::ground_under_eye() const {
  for (const Place& place : places) {
    const HeightGrid& grid = *place.grid;
    if (grid.columns < 2 || grid.rows < 2) continue;
    const glm::dvec2 uv =
        place.crs ? exact_map(place).to_grid(glm::dvec2(0)) : place.placement.posts(eye.projected);
    if (!grid.covers(uv)) continue;
    const glm::ivec2 cell = cell_of(grid, uv);
    if (grid.has_ground(cell.x, cell.y)) return height_at(grid, options.surface, cell, uv);
  }
  return std::nullopt;
}

VerticalFrame ViewFrame::Impl::vertical_frame(const EyePlace& place) {
  VerticalFrame frame{.z_scale = options.z_scale};
  if (place.above_ground) {
    if (!eye.ground_m)
      throw InputError("no ground under the eye at " + eye_text() +
                       ": give its height without a +, or move it over the DEM");
    frame.eye_height_m = options.z_scale * *eye.ground_m + place.height_m;
  } else {
    frame.eye_height_m = options.z_scale * place.height_m;
  }
  eye.height_m = frame.eye_height_m / options.z_scale;
  if (!options.under_ground && eye.ground_m && frame.eye_height_m < options.z_scale * *eye.ground_m)
    throw InputError("the eye is " + in_words("%.3f", *eye.ground_m - eye.height_m) +
                     " m under the ground, which at " + eye_text() + " is at " +
                     in_words("%.3f", *eye.ground_m) +
                     " m: raise it, or give +2 for two metres above the ground");
  if (curved) {
    const Curvatures curvatures = curvatures_at(eye.geographic->latitude_deg);
    frame.north_curvature_per_m = curvatures.north_per_m;
    frame.east_curvature_per_m = curvatures.east_per_m;
    frame.refraction = options.refraction;
  }
  return frame;
}

TerrainLayer ViewFrame::Impl::flat_layer(const Place& place) const {
  if (!place.crs)
    return {place.grid,
            std::make_shared<AffineGroundMap>(place.placement.posts(eye.projected),
                                              glm::inverse(place.placement.step), place.size())};
  const ExactGroundMap exact = exact_map(place);
  const glm::dvec2 eye_uv = exact.to_grid(glm::dvec2(0));
  const glm::dmat2 jacobian = exact.jacobian(glm::dvec2(0));
  if (!std::isfinite(glm::determinant(jacobian)) || !std::isfinite(eye_uv.x))
    throw InputError("the eye at " + eye_text() + " is outside of where the coordinates of '" +
                     place.crs->operation().dem +
                     "' are defined: move it, or leave out --earth flat");
  return {place.grid, std::make_shared<AffineGroundMap>(eye_uv, jacobian, place.size())};
}

std::vector<TerrainLayer> ViewFrame::Impl::flat_layers() {
  std::vector<TerrainLayer> layers;
  for (const Place& place : places) layers.push_back(flat_layer(place));
  if (layers.empty()) return layers;
  flat_to_ground = glm::inverse(places[0].placement.step * layers[0].map->jacobian(glm::dvec2(0)));
  return layers;
}

std::vector<TerrainLayer> ViewFrame::Impl::curved_layers(const VerticalFrame& frame) {
  const Relief heights = relief(places, options.z_scale);
  const double sight = options.beyond_sight ? kFurthest_m
                                            : sight_m(frame, heights.lowest_m,
                                                      heights.highest_m + options.above_ground_m);
  std::vector<TerrainLayer> layers;
  for (const Place& place : places) {
    for (const LaidGrid& laid : lay_grid(exact_map(place), place.size(), sight)) {
      const FrameErrors here = measure_errors(laid, *place.grid, *eye.geographic, frame, sight);
      errors.track_cells = std::max(errors.track_cells, here.track_cells);
      errors.direction_rad = std::max(errors.direction_rad, here.direction_rad);
      layers.push_back({place.grid, laid.map});
    }
  }
  return layers;
}

namespace {

// Those of a grid, in whatever layers it is.
void make_ceilings(const std::vector<Dem>& dems, std::vector<TerrainLayer>& layers, int threads) {
  const ForEach for_each = [threads](int count, const std::function<void(int index)>& work) {
    parallel_for(count, threads, work);
  };
  std::map<const HeightGrid*, std::shared_ptr<const HeightCeilings>> made;
  for (const Dem& dem : dems) made[dem.grid.get()] = dem.ceilings;
  for (TerrainLayer& layer : layers) {
    auto& ceilings = made[layer.grid.get()];
    if (!ceilings) ceilings = std::make_shared<const HeightCeilings>(*layer.grid, for_each);
    layer.ceilings = ceilings;
  }
}

}  // namespace

ViewFrame::ViewFrame(const std::vector<Dem>& dems, const EyePlace& eye,
                     const ViewFrameOptions& options)
    : impl_(std::make_unique<Impl>()) {
  check_request(dems, eye, options);
  impl_->options = options;
  impl_->warnings = datum_warnings(dems);
  impl_->place_dems(dems);
  impl_->place_eye(eye);
  impl_->curved = impl_->eye.geographic && options.earth == EarthModel::curved;

  impl_->eye.ground_m = impl_->ground_under_eye();
  const VerticalFrame frame = impl_->vertical_frame(eye);
  std::vector<TerrainLayer> layers =
      impl_->curved ? impl_->curved_layers(frame) : impl_->flat_layers();
  if (options.search == Search::pyramid) make_ceilings(dems, layers, options.threads);
  impl_->terrain =
      std::make_shared<Terrain>(std::move(layers), frame, options.surface, options.search);
}

ViewFrame::~ViewFrame() = default;
ViewFrame::ViewFrame(ViewFrame&&) noexcept = default;
ViewFrame& ViewFrame::operator=(ViewFrame&&) noexcept = default;

const std::shared_ptr<const Terrain>& ViewFrame::terrain() const { return impl_->terrain; }

bool ViewFrame::is_geographic() const { return impl_->eye.geographic.has_value(); }

glm::dvec2 ViewFrame::to_ground(const GeoPoint& point) const {
  if (impl_->curved) return ground_from_geographic(*impl_->eye.geographic, point);
  if (!is_geographic())
    throw InputError(
        "a latitude means nothing without a coordinate system: give one with "
        "--a-srs EPSG:CODE, or the place in the DEM's own coordinates");
  return impl_->flat_to_ground * (impl_->projected(point) - impl_->eye.projected);
}

glm::dvec2 ViewFrame::to_ground_from_projected(glm::dvec2 xy) const {
  if (impl_->curved) return ground_from_geographic(*impl_->eye.geographic, impl_->geographic(xy));
  return impl_->flat_to_ground * (xy - impl_->eye.projected);
}

GeoPoint ViewFrame::from_ground(glm::dvec2 ground_m) const {
  if (impl_->curved) return geographic_from_ground(*impl_->eye.geographic, ground_m);
  return impl_->geographic(projected_from_ground(ground_m));
}

glm::dvec2 ViewFrame::projected_from_ground(glm::dvec2 ground_m) const {
  if (impl_->curved) return impl_->projected(from_ground(ground_m));
  return impl_->eye.projected + glm::inverse(impl_->flat_to_ground) * ground_m;
}

glm::dvec3 ViewFrame::to_true_enu(const glm::dvec3& view_m) const {
  return terrview::to_true_enu(impl_->terrain->frame(), view_m);
}

glm::dvec3 ViewFrame::from_true_enu(const glm::dvec3& enu_m) const {
  return terrview::from_true_enu(impl_->terrain->frame(), enu_m);
}

const ViewFrame::Eye& ViewFrame::eye() const { return impl_->eye; }

const std::vector<CrsOperation>& ViewFrame::operations() const { return impl_->operations; }

const std::vector<std::string>& ViewFrame::warnings() const { return impl_->warnings; }

double ViewFrame::track_error_cells() const { return impl_->errors.track_cells; }

double ViewFrame::direction_error_rad() const { return impl_->errors.direction_rad; }

}  // namespace terrview
