#include "cli/view_setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "cli/interrupt.h"
#include "cli/plan.h"
#include "cli/scene/place_scene.h"
#include "cli/view_ground.h"
#include "cli/view_light.h"
#include "cli/view_sky.h"
#include "cli/view_water.h"
#include "render/sky_light.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kDegrees = 180 / std::numbers::pi;

// A place and height to aim at, in the view frame.
glm::dvec3 target_point(const Target& target, const ViewFrame& frame) {
  const glm::dvec2 ground_m = target.geographic ? frame.to_ground(*target.geographic)
                                                : frame.to_ground_from_projected(*target.projected);
  const Terrain& terrain = *frame.terrain();
  double scene_height_m = target.height.height_m * terrain.frame().z_scale;
  if (target.height.above_ground) {
    const auto ground = terrain.ground_at(ground_m);
    if (!ground)
      throw InputError("--look-at: there is no ground at that place: give its height too");
    scene_height_m = ground->scene_height_m + target.height.height_m;
  }
  return {ground_m, terrain.frame().at(ground_m).z_m(scene_height_m)};
}

// The middle of the first DEM at the height of its ground, or the eye's where it has none.
glm::dvec3 centre_of(const std::vector<Dem>& dems, const ViewFrame& frame) {
  const HeightGrid& grid = *dems.front().grid;
  const glm::dvec2 middle(0.5 * (grid.columns - 1), 0.5 * (grid.rows - 1));
  const glm::dvec2 ground_m = frame.to_ground_from_projected(dems.front().placement.at(middle));
  const VerticalFrame& vertical = frame.terrain()->frame();
  const auto ground = frame.terrain()->ground_at(ground_m);
  const double scene_height_m = ground ? ground->scene_height_m : vertical.eye_height_m;
  return {ground_m, vertical.at(ground_m).z_m(scene_height_m)};
}

struct Aim {
  double heading_deg;
  double pitch_deg;
};

// Nearer to the plumb line than this, a point has no azimuth but rounding's.
constexpr double kPlumb_m = 1e-3;

Aim aim_at(const glm::dvec3& point_m) {
  const double ground_m = glm::length(glm::dvec2(point_m));
  if (ground_m < kPlumb_m) return {0, point_m.z < 0 ? -90.0 : 90.0};
  double heading_deg = std::atan2(point_m.x, point_m.y) * kDegrees;
  if (heading_deg < 0) heading_deg += 360;
  return {heading_deg, std::atan2(point_m.z, ground_m) * kDegrees};
}

Aim resolve_aim(const ViewOptions& options, const ViewFrame& frame, const std::vector<Dem>& dems) {
  if (options.heading_deg) return {*options.heading_deg, options.pitch_deg.value_or(0)};
  Aim aim =
      aim_at(options.look_at ? target_point(*options.look_at, frame) : centre_of(dems, frame));
  if (options.pitch_deg) aim.pitch_deg = *options.pitch_deg;
  return aim;
}

// A DEM without a coordinate system has no curved Earth.
void check_curved(const ViewOptions& options, const Dem& dem) {
  const char* option = options.refraction                    ? "--refraction"
                       : options.earth == EarthModel::curved ? "--earth curved"
                                                             : nullptr;
  if (option)
    throw InputError(std::string(option) + ": '" + dem.name +
                     "' has no coordinate system, so it is flat: leave it out, or give one with "
                     "--a-srs EPSG:CODE");
}

GroundDetail::MeansOfGrids known_means(const std::vector<Dem>& dems) {
  GroundDetail::MeansOfGrids means;
  for (const Dem& dem : dems) means[dem.grid.get()] = dem.means;
  return means;
}

Scene make_scene(const ViewOptions& options, const ViewFrame& frame, const SunPosition& sun,
                 const std::vector<Dem>& dems) {
  Scene scene;
  scene.terrain = frame.terrain();
  scene.normals = options.normals;
  set_light(options.light, sun, scene);
  if (options.light.sky_azimuths > 0)
    scene.sky_views = std::make_shared<const std::vector<SkyView>>(
        sky_views(*scene.terrain, {.azimuths = options.light.sky_azimuths,
                                   .threads = options.threads,
                                   .progress = [](double) { check_interrupt(); }}));
  if (!options.plan) scene.air = make_air(options.air);
  if (options.sampling.detail)
    scene.detail = std::make_shared<GroundDetail>(*scene.terrain, known_means(dems));
  return scene;
}

}  // namespace

ViewFrameOptions frame_options(const ViewOptions& options) {
  ViewFrameOptions frame;
  frame.earth = options.earth.value_or(frame.earth);
  frame.refraction = options.refraction.value_or(frame.refraction);
  frame.z_scale = options.z_scale.value_or(frame.z_scale);
  frame.surface = options.surface;
  frame.search = options.coherence == Coherence::off ? Search::plain : Search::pyramid;
  frame.threads = options.threads;
  frame.beyond_sight = options.plan;
  return frame;
}

ResolvedView known_view(const ViewOptions& options) {
  ResolvedView view;
  view.pitch_deg = options.pitch_deg.value_or(view.pitch_deg);
  view.roll_deg = options.roll_deg.value_or(view.roll_deg);
  view.fov_deg = options.fov_deg.value_or(view.fov_deg);
  view.width_m = options.width_m.value_or(view.width_m);
  view.size_px = options.size_px.value_or(view.size_px);
  view.projection = options.projection.value_or(view.projection);
  view.shift = options.shift.value_or(view.shift);
  view.crop = options.crop;
  const ViewFrameOptions placed = frame_options(options);
  view.earth = placed.earth;
  view.refraction = placed.refraction;
  view.z_scale = placed.z_scale;
  return view;
}

ResolvedView resolve_view(const ViewOptions& options, const ViewFrame& frame,
                          const std::vector<Dem>& dems) {
  if (!frame.is_geographic() && !dems.empty()) check_curved(options, dems.front());
  ResolvedView view = known_view(options);
  if (!frame.is_geographic()) view.earth = EarthModel::flat;
  view.eye = options.plan ? eye_of_plan(options, dems) : *options.eye;
  view.eye.height_m = frame.eye().height_m;
  view.eye.above_ground = false;
  if (options.plan) {
    resolve_plan(options, frame, dems.front(), view);
    return view;
  }
  const Aim aim = resolve_aim(options, frame, dems);
  view.heading_deg = aim.heading_deg;
  view.pitch_deg = aim.pitch_deg;
  return view;
}

Camera make_camera(const ResolvedView& view) {
  const Camera camera({.projection = view.projection,
                       .heading_rad = view.heading_deg * kRadians,
                       .pitch_rad = view.pitch_deg * kRadians,
                       .roll_rad = view.roll_deg * kRadians,
                       .fov_rad = view.fov_deg * kRadians,
                       .width_m = view.width_m,
                       .shift = view.shift,
                       .size_px = view.size_px});
  if (!view.crop) return camera;
  const glm::ivec2 first = view.crop->first_px;
  const glm::ivec2 room = view.size_px - view.crop->size_px;
  if (view.crop->size_px.x < 1 || view.crop->size_px.y < 1 || first.x < 0 || first.y < 0 ||
      first.x > room.x || first.y > room.y)
    throw InputError("--crop: is not within the picture of " + std::to_string(view.size_px.x) +
                     "x" + std::to_string(view.size_px.y) + " pixels: give X,Y,W,H in it");
  return camera.part(*view.crop);
}

View make_view(const ViewOptions& options, const std::vector<Dem>& dems) {
  SharedInputs its_own;
  return make_view(options, dems, its_own);
}

View make_view(const ViewOptions& options, const std::vector<Dem>& dems, SharedInputs& inputs) {
  const auto laid = inputs.water(options.water, dems);
  const std::vector<Dem>& ground = laid->lakes ? laid->lakes->dems : dems;
  const EyePlace eye = options.plan ? eye_of_plan(options, ground) : *options.eye;
  ViewFrame frame(ground, eye, frame_options(options));
  const ResolvedView resolved = resolve_view(options, frame, ground);
  const SunPosition sun =
      resolve_sun(options.light, {frame.eye().geographic, frame.eye().height_m});
  Scene scene = make_scene(options, frame, sun, ground);
  set_ground_colors(options, ground, inputs, scene);
  const Camera camera = make_camera(resolved);
  scene.painted_sky = paint_view_sky(options.sky, frame, camera, scene);
  if (options.contents) place_light(*options.contents, frame, scene);
  ViewObjects objects = read_objects(options, frame, inputs);
  objects.messages.insert(objects.messages.end(), laid->messages.begin(), laid->messages.end());
  scene.objects = objects.scene;
  if (has_water(options.water))
    scene.water = make_water(options.water, *laid, scene, !options.plan,
                             mirror_view_sky(options.sky, frame, camera, scene));
  ViewLabels labels = make_labels(options, frame, camera, scene);
  return {std::move(frame),   resolved,         sun, camera, std::move(scene),
          std::move(objects), std::move(labels)};
}

}  // namespace terrview
