#include "cli/overview_block.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/block_shape.h"
#include "render/block_walls.h"
#include "render/color_ramp.h"
#include "render/objects/scene_objects.h"
#include "terrain/error.h"

namespace terrview {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr int kUsualWidth_px = 1600;
constexpr int kLeastBlock_px = 32;
constexpr double kLine_px = 1.6;
// Far enough over the middle that the picture's plane passes above all ground at every tilt.
constexpr double kEyeHeights = 16;  // of the reach

// Of the whole region, before the frame of its view is made.
struct Region {
  double side_m;
  double reach_m;  // of the corners, from the middle of the first DEM
  double lowest_m;
  double highest_m;
};

glm::dvec2 middle_of(const Dem& dem) {
  return dem.placement.at(glm::dvec2(dem.grid->columns - 1, dem.grid->rows - 1) / 2.0);
}

// The four corners of a DEM, at 0 m: all that its place depends on.
Dem outline_of(const Dem& dem) {
  Dem outline = dem;
  outline.grid = std::make_shared<const HeightGrid>(HeightGrid{2, 2, {0, 0, 0, 0}});
  outline.placement.step[0] *= dem.grid->columns - 1;
  outline.placement.step[1] *= dem.grid->rows - 1;
  return outline;
}

Region region_of(const std::vector<Dem>& dems) {
  Region region{0, 0, std::numeric_limits<double>::infinity(),
                -std::numeric_limits<double>::infinity()};
  std::vector<Dem> outlines;
  for (const Dem& dem : dems) {
    outlines.push_back(outline_of(dem));
    const HeightRange range = height_range(*dem.grid);
    region.lowest_m = std::min<double>(region.lowest_m, range.lowest_m);
    region.highest_m = std::max<double>(region.highest_m, range.highest_m);
  }
  EyePlace above;
  above.projected = middle_of(dems.front());
  above.height_m = 1;
  const ViewFrame frame(outlines, above, {.earth = EarthModel::flat});
  glm::dvec2 low_m(0);
  glm::dvec2 high_m(0);
  for (const TerrainLayer& layer : frame.terrain()->layers()) {
    const glm::dmat2 to_ground = glm::inverse(*layer.map->linear());
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
      const glm::dvec2 at_m = to_ground * (corner - layer.map->to_grid(glm::dvec2(0)));
      low_m = glm::min(low_m, at_m);
      high_m = glm::max(high_m, at_m);
      region.reach_m = std::max(region.reach_m, glm::length(at_m));
    }
  }
  const glm::dvec2 size_m = high_m - low_m;
  region.side_m = std::sqrt(size_m.x * size_m.y);
  return region;
}

ViewOptions options_of_view(const OverviewOptions& options, const std::vector<Dem>& dems,
                            const Region& region) {
  ViewOptions view = options.view;
  if (!view.z_scale)
    view.z_scale = block_exaggeration(region.highest_m - region.lowest_m, region.side_m);
  EyePlace eye;
  eye.projected = middle_of(dems.front());
  const double relief_m = *view.z_scale * (region.highest_m - region.lowest_m);
  eye.height_m = region.highest_m + kEyeHeights * (region.reach_m + relief_m) / *view.z_scale;
  view.eye = eye;
  view.heading_deg = std::remainder(options.from_deg + 180, 360.0);
  view.pitch_deg = -options.tilt_deg;
  view.projection = Projection::orthographic;
  view.width_m = 1;
  return view;
}

// How a block of so many metres fits between the margins: the picture's size, and a pixel's.
struct Fit {
  glm::ivec2 size_px;
  double m_per_px;
};

Fit fit(const OverviewOptions& options, const glm::dvec2& block_m, const BlockMargins& margins) {
  const glm::ivec2 taken(margins.left_px + margins.right_px, margins.top_px + margins.bottom_px);
  glm::ivec2 size_px = options.view.size_px.value_or(glm::ivec2(kUsualWidth_px, 0));
  if (!options.view.size_px) {
    const double height_px = block_m.y / block_m.x * (size_px.x - taken.x) + taken.y;
    size_px.y = static_cast<int>(
        std::clamp(std::ceil(height_px), kUsualWidth_px * 0.4, kUsualWidth_px * 1.25));
  }
  const glm::ivec2 room_px = size_px - taken;
  if (room_px.x < kLeastBlock_px || room_px.y < kLeastBlock_px)
    throw InputError("--size: " + std::to_string(size_px.x) + "x" + std::to_string(size_px.y) +
                     ": leaves no room for the block beside its words: give " +
                     std::to_string(taken.x + kLeastBlock_px) + "x" +
                     std::to_string(taken.y + kLeastBlock_px) + " or more" +
                     (options.plain ? "" : ", or add --plain"));
  const glm::dvec2 m_per_px = block_m / glm::dvec2(room_px);
  return {size_px, std::max(m_per_px.x, m_per_px.y)};
}

BlockMargins margins_for(int letter_px, bool plain) {
  if (plain) return {letter_px, letter_px, letter_px, letter_px};
  return {8 * letter_px, 8 * letter_px, 5 * letter_px, 8 * letter_px};
}

// Aims the camera so that the middle of `bounds` lies in the middle between the margins.
void aim(const ImageBounds& bounds, const Fit& fit, const BlockMargins& margins,
         ResolvedView& view) {
  const glm::dvec2 middle_m = (bounds.low_m + bounds.high_m) / 2.0;
  const glm::dvec2 room_px(fit.size_px.x - margins.left_px - margins.right_px,
                           fit.size_px.y - margins.top_px - margins.bottom_px);
  const glm::dvec2 target_px = glm::dvec2(margins.left_px, margins.top_px) + room_px / 2.0;
  // Where the eye's own axis falls, far off the picture: a whole picture about it holds this one.
  const glm::ivec2 axis_px(
      glm::round(target_px + glm::dvec2(-middle_m.x, middle_m.y) / fit.m_per_px));
  const glm::ivec2 half_px = glm::max(glm::abs(axis_px), glm::abs(fit.size_px - axis_px));
  view.size_px = 2 * half_px;
  view.crop = PixelRect{half_px - axis_px, fit.size_px};
  view.width_m = view.size_px.x * fit.m_per_px;
}

// The camera of the picture, which shows a part of a larger one.
Camera make_block_camera(const ResolvedView& view) {
  try {
    return make_camera(view);
  } catch (const InputError&) {
    throw InputError("--size: " + std::to_string(view.crop->size_px.x) + "x" +
                     std::to_string(view.crop->size_px.y) +
                     ": is too large for a block: give fewer pixels");
  }
}

std::optional<BlockFonts> make_fonts(const OverviewOptions& options, int letter_px) {
  if (options.plain) return std::nullopt;
  const std::string& given = options.view.labels.font;
  const std::string path = given.empty() ? usual_font() : given;
  return BlockFonts{Font(path, letter_px), Font(path, static_cast<int>(1.6 * letter_px))};
}

void set_paper(Scene& scene) {
  const glm::vec3 paper = from_srgb8(246, 244, 239);
  scene.sky = {paper, paper, std::nullopt};
  scene.air = Air{};
}

std::shared_ptr<const SceneObjects> walls_of(const Scene& scene, double plinth_z_m, double line_m) {
  auto objects = std::make_shared<SceneObjects>();
  objects->set = std::make_shared<const ObjectList>(
      Objects{std::make_shared<const BlockWalls>(scene.terrain, plinth_z_m, line_m)});
  objects->looks = {{.color = from_srgb8(176, 150, 122), .roof_color = from_srgb8(84, 66, 52)}};
  objects->walls_in_ground = true;
  return objects;
}

}  // namespace

BlockView make_block(const OverviewOptions& options, const std::vector<Dem>& dems) {
  const Region region = region_of(dems);
  const ViewOptions of_view = options_of_view(options, dems, region);
  View view = make_view(of_view, dems);
  const VerticalFrame& frame = view.scene.terrain->frame();
  const double plinth_z_m =
      frame.z_scale * region.lowest_m - plinth_depth_m(region.side_m) - frame.eye_height_m;
  const ImageBounds bounds =
      block_bounds(*view.scene.terrain, plinth_z_m, view.camera.right(), view.camera.up());
  const int width_px = options.view.size_px ? options.view.size_px->x : kUsualWidth_px;
  const int letter_px = std::max(9, width_px / 80);
  const BlockMargins margins = margins_for(letter_px, options.plain);
  const Fit fitted = fit(options, bounds.high_m - bounds.low_m, margins);
  aim(bounds, fitted, margins, view.resolved);
  view.camera = make_block_camera(view.resolved);
  set_paper(view.scene);
  const double upright = std::max(0.1, std::cos(options.tilt_deg * kRadians));
  view.scene.objects = walls_of(view.scene, plinth_z_m, kLine_px * fitted.m_per_px / upright);
  const double z_scale = frame.z_scale;
  return {std::move(view),
          margins,
          plinth_z_m,
          fitted.m_per_px,
          z_scale,
          letter_px,
          make_fonts(options, letter_px)};
}

}  // namespace terrview
