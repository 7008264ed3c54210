#include "cli/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/view_command.h"
#include "cli/view_metadata.h"
#include "ingest/plan_file.h"
#include "render/color_ramp.h"
#include "render/parallel.h"
#include "render/write_file.h"
#include "terrain/error.h"
#include "terrain/mean_heights.h"

namespace terrview {
namespace {

constexpr int kLargestSide_px = 1 << 17;
// So far from its origin the view frame turns the sun by a hundredth of a degree along a shadow of
// 30 km.
constexpr double kFurthest_m = 500'000;

double length_of(const glm::dvec2& step) { return std::hypot(step.x, step.y); }

// In the pixels of `lattice`, whose DEM's posts lie so.
PostPlacement corners_of(const PlanLattice& lattice, const PostPlacement& posts) {
  return {posts.at(lattice.corner_uv + lattice.step_uv * glm::dvec2(lattice.first_px)),
          {posts.step[0] * lattice.step_uv.x, posts.step[1] * lattice.step_uv.y}};
}

Raster<glm::u8vec4> colors_of(const PlanFrame& frame, int threads) {
  const Image& image = frame.image;
  Raster<glm::u8vec4> colors(image.width_px(), image.height_px());
  parallel_for(image.height_px(), threads, [&](int row) {
    for (int column = 0; column < image.width_px(); ++column) {
      if (frame.covered.at(column, row) == 0) continue;
      const glm::vec3& color = image.at(column, row);
      colors.at(column, row) = {to_srgb8(color.x), to_srgb8(color.y), to_srgb8(color.z), 255};
    }
  });
  return colors;
}

PlanFileOptions file_options(const ViewOptions& options, const View& view) {
  return {options.format,
          options.creation,
          {{"terrview:view", view_metadata(options, view.resolved, view.sun)}},
          options.plan_alpha};
}

}  // namespace

void check_plan(const ViewOptions& options) {
  if (!options.plan) {
    if (options.resolution)
      throw InputError("--resolution: of a plan: add --projection plan, or give --size");
    return;
  }
  const AirOptions& air = options.air;
  const std::array<std::pair<bool, const char*>, 23> useless{
      {{!options.preset.empty(), "--preset"},
       {options.look_at.has_value(), "--look-at"},
       {options.heading_deg.has_value(), "--heading"},
       {options.pitch_deg.has_value(), "--pitch"},
       {options.roll_deg.has_value(), "--roll"},
       {options.fov_deg.has_value(), "--fov"},
       {options.width_m.has_value(), "--width"},
       {options.size_px.has_value(), "--size"},
       {options.shift.has_value(), "--shift"},
       {options.crop.has_value(), "--crop"},
       {options.dpi.has_value(), "--dpi"},
       {!options.from_camera.empty(), "--from-camera"},
       {!options.camera.empty(), "--camera"},
       {!options.layers.empty(), "--layers"},
       {!options.objects.csv.empty(), "--objects-csv"},
       {!options.labels.peaks.empty(), "--peaks"},
       {!options.wireline.file.empty(), "--wireline"},
       {!options.progressive.empty(), "--progressive"},
       {options.sampling.preview, "--preview"},
       {wants_palette(options.palette), "--palette"},
       {options.coherence == Coherence::neighbours, "--coherence neighbours"},
       {air.visibility_km || air.extinction_per_km || air.color || air.sunward,
        "--visibility, --extinction, --air-color"},
       {air.haze_px > 0, "--haze"}}};
  for (const auto& [is_given, name] : useless)
    if (is_given)
      throw InputError(std::string(name) +
                       ": a plan looks straight down through clear air, at the DEM's resolution: "
                       "leave it out");
}

EyePlace eye_of_plan(const ViewOptions& options, const std::vector<Dem>& dems) {
  if (options.eye) return *options.eye;
  const Dem& first = dems.front();
  EyePlace eye;
  eye.projected =
      first.placement.at(glm::dvec2(first.grid->columns - 1, first.grid->rows - 1) / 2.0);
  eye.height_m = height_range(*first.grid).highest_m;
  for (const Dem& dem : dems)
    eye.height_m = std::fmax(eye.height_m, height_range(*dem.grid).highest_m);
  return eye;
}

PlanLattice plan_lattice(const ViewOptions& options, const Dem& dem) {
  const glm::dvec2 posts(dem.grid->columns, dem.grid->rows);
  PlanLattice lattice{.size_px = glm::ivec2(posts)};
  if (!options.resolution) return lattice;
  const glm::dvec2 post(length_of(dem.placement.step[0]), length_of(dem.placement.step[1]));
  lattice.step_uv = *options.resolution / post;
  const glm::dvec2 size = glm::max(glm::round(posts / lattice.step_uv), glm::dvec2(1));
  if (!(options.resolution->x > 0 && options.resolution->y > 0 && size.x <= kLargestSide_px &&
        size.y <= kLargestSide_px))
    throw InputError("--resolution: makes no picture of up to " + std::to_string(kLargestSide_px) +
                     " pixels a side: give the size of a pixel in the units of the DEM");
  lattice.size_px = glm::ivec2(size);
  return lattice;
}

void resolve_plan(const ViewOptions& options, const ViewFrame& frame, const Dem& dem,
                  ResolvedView& view) {
  const Terrain& terrain = *frame.terrain();
  if (view.earth == EarthModel::curved && terrain.reach_m() > kFurthest_m)
    throw InputError("--projection plan: the ground reaches " +
                     std::to_string(std::lround(terrain.reach_m() / 1000)) +
                     " km from its middle, too far for one light: give a --window of it, or "
                     "--earth flat");
  const PlanLattice lattice = plan_lattice(options, dem);
  view.plan = true;
  view.projection = Projection::orthographic;
  view.pitch_deg = -90;
  view.size_px = lattice.size_px;
  view.width_m = lattice.size_px.x * lattice.step_uv.x * post_distance_m(terrain.layers().front());
}

PlanFrame draw_plan(const ViewOptions& options, const View& view, const PlanLattice& lattice,
                    const std::string& label) {
  ProgressBar bar(label, show_bar(options));
  return render_plan(view.scene, lattice,
                     {.threads = options.threads,
                      .samples = std::max(1, options.sampling.samples),
                      .progress = [&](double share) {
                        check_interrupt();
                        bar.report(share);
                      }});
}

void write_plan(const ViewOptions& options, const View& view, const Dem& dem,
                const PlanLattice& lattice, const PlanFrame& frame, const ViewFiles& files) {
  const PlanPicture picture{colors_of(frame, options.threads), corners_of(lattice, dem.placement),
                            dem.crs_wkt};
  const std::string& name = files.image->path();
  PlanFiles encoded;
  files.image->fill([&](const std::string& path) {
    encoded = encode_plan(name, picture, file_options(options, view));
    write_file(path, encoded.picture);
  });
  if (files.world)
    files.world->fill(
        [&](const std::string& path) { write_file(path, world_file(picture.corners)); });
  if (files.side)
    files.side->fill([&](const std::string& path) { write_file(path, encoded.side); });
}

}  // namespace terrview
